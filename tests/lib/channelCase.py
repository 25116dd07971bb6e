#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     A long channel full of balls that come in at its start and leave at its
#     end, with two meters.
#------------------------------------------------------------------------------
import os
import re

from badInput import edit
from cases import setEntry
from cloudCase import copyCase, runIn


def channel(name, n, length, end):
    """A case with n balls in a channel of that length, in m, until end."""
    case = copyCase(
        os.environ["STYX_DIR"] + "/tests/restart/restartDem", name)
    file = case + "/constant/demCloudProperties"
    with open(file) as stream:
        text = stream.read()
    text = re.sub(r"bodies\n\{.*?\n\}\n", "", text, flags=re.S)
    text = re.sub(r"generators\n\{.*?\n\}\n", """generators
{
    bed
    {
        type fill; shape pebble; material stone; number %d; seed 5;
        region { box (0.004 0.004 0.004) (%g 0.036 0.076); }
        velocity (2 0 -2);
    }
}
sinks { end { type region; region { box (%g -1 -1) (2 1 1); } } }
meters
{
    middle { type massFlow; point (%g 0 0); normal (1 0 0); }
    touch { type coordination; }
    filled
    {
        type profile; low (0 0 0); high (%g 0.04 0.08); windows (7 2 3);
        interval 0.002;
    }
}
""" % (n, length - 0.004, length - 0.02, length/2, length), text, flags=re.S)
    with open(file, "w") as stream:
        stream.write(text)
    file = case + "/system/blockMeshDict"
    with open(file) as stream:
        text = stream.read()
    text = re.sub(r"vertices.*?\);", "vertices (%s);" % " ".join(
        "( %g %g %g)" % (length*x, 0.04*y, 0.08*z) for z in (0, 1)
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))), text, count=1, flags=re.S)
    with open(file, "w") as stream:
        stream.write(text)
    setEntry(case + "/system/controlDict", "endTime", end)
    edit(case, "system/controlDict", "writeInterval   15;", "writeInterval 10;")
    runIn(case, "blockMesh")
    return case
#------------------------------------------------------------------------------
