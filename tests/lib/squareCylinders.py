#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs of the tutorial squareCylinder.
#         table = compare(8, ["30"], ["fitted", "surface"])
#             of each shape and Reynolds number the drag coefficient and the
#             length of the recirculation over D
#         compare(12, ["200"], ["fitted"], sheds=9)
#             where vortices are shed: 9 s, from a flow that starts across,
#             second order in time
#------------------------------------------------------------------------------
import os
import re
import subprocess

from badInput import edit
from cases import setEntry
from cloudCase import copyCase, runIn


def compare(cells, numbers, shapes, sheds=0, folder="square"):
    case = copyCase(os.environ["STYX_DIR"]
                    + "/tutorials/resolved/squareCylinder", folder)
    for Re in numbers:
        for shape in shapes:
            run = "%s/runs/%s_%s" % (folder, shape, Re)
            subprocess.check_call(["./makeCase", shape, Re, str(cells),
                                   "runs/%s_%s" % (shape, Re)], cwd=folder)
            if sheds:
                setEntry(run + "/system/controlDict", "endTime", "%g" % sheds)
                setEntry(run + "/system/controlDict", "writeInterval",
                         "%g" % sheds)
                setEntry(run + "/system/fvSchemes", "ddtSchemes/default",
                         "backward")
                setEntry(run + "/system/fvSolution",
                         "PIMPLE/nOuterCorrectors", "2")
                edit(run, "0/U", "uniform (0.0667 0 0)",
                     "uniform (0.0667 0.03 0)")
            runIn(run, "blockMesh")
            runIn(run, "pimpleFoam")
    out = subprocess.check_output(["./results"], cwd=case).decode()
    print(out)

    rows = out.splitlines()
    names = rows[0].split()[1:1 + len(shapes)]
    table = {}
    for row in rows[1:]:
        pairs = re.findall(r"(\S+) \( *([-0-9.]+)\)", row)
        for name, (drag, wake) in zip(names, pairs):
            table[name, float(row.split()[0])] = (float(drag), float(wake))
    return table
