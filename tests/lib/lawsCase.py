#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The balls and clumps of tests/restart/restartDem with the contact laws
#     that remember more than a slip: springs of rolling and torsion, bridges of
#     liquid; and with contacts that share.
#         case = lawsCase("through")
#------------------------------------------------------------------------------
import os

from cases import setEntry
from cloudCase import copyCase

laws = """
contact
{
    rolling elasticPlastic; torsion elasticPlastic;
    cohesion capillary; multiContact share;
}
"""
pair = ("rollingFriction 0.1; torsionalFriction 0.05; surfaceTension 1;"
        " contactAngle 20; bridgeVolume 0.01;")


def lawsCase(name):
    """A copy with these laws that ends with many contacts."""
    case = copyCase(os.environ["STYX_DIR"] + "/tests/restart/restartDem", name)
    file = case + "/constant/demCloudProperties"
    with open(file) as stream:
        text = stream.read()
    text = text.replace("friction 0.4;", "friction 0.4; " + pair)
    text = text.replace("\nshapes", laws + "\nshapes", 1)
    with open(file, "w") as stream:
        stream.write(text)
    setEntry(case + "/system/controlDict", "writeFormat", "binary")
    return case
