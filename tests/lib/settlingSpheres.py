#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs of the tutorial resolved/settlingSphere.
#         rows = settle("E4")                 to the bottom
#         rows = settle("E4", endTime="0.1")  the first steps
#             of each experiment a dictionary: largest (m/s), curve (%), shift,
#             touchdown (s), path, approach (%), gap (d)
#------------------------------------------------------------------------------
import os
import subprocess

from cloudCase import copyCase


def settle(*experiments, endTime=None):
    case = copyCase(os.environ["STYX_DIR"]
                    + "/tutorials/resolved/settlingSphere", "spheres")
    subprocess.check_call(["./Allclean"], cwd=case)
    if endTime:
        # The end that Allrun chooses for an experiment
        with open(case + "/Allrun") as text:
            script = text.read().replace("$endTime", endTime)
        with open(case + "/Allrun", "w") as text:
            text.write(script)
    subprocess.check_call(["./Allrun", *experiments], cwd=case)
    out = subprocess.check_output(["./results"], cwd=case).decode()
    names = ("largest", "curve", "shift", "touchdown", "path", "approach",
             "gap")
    return {words[0]: dict(zip(names, map(float, words[1:])))
            for words in (row.split() for row in out.splitlines()[1:])}
