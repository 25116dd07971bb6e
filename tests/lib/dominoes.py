#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs of the tutorial resolved/dominoInWater.
#         case = domino()             a copy of it
#         times = fallTimes(case, ("coarse", "fine"), ("vacuum",), ("0.001",))
#             of each cluster, coupling and step the time at which the last
#             column has fallen
#------------------------------------------------------------------------------
import math
import os
import subprocess

from cloudCase import copyCase, runIn


def domino():
    case = copyCase(os.environ["STYX_DIR"] + "/tutorials/resolved/dominoInWater",
                    "domino")
    subprocess.check_call(["./Allclean"], cwd=case)
    return case


def fallTimes(case, clusters, couplings, steps):
    for cluster in clusters:
        for coupling in couplings:
            for step in steps:
                run = "runs/%s_%s_%s" % (cluster, coupling, step)
                runIn(case, "./makeCase", cluster, coupling, step, run)
                runIn(case + "/" + run, "blockMesh")
                runIn(case + "/" + run,
                      "demFoam" if coupling == "vacuum" else "pimpleFoam")
    out = subprocess.check_output(["./results"], cwd=case).decode()
    print(out)
    times = {}
    for row in out.splitlines()[1:]:
        cluster, coupling, step, time, _ = row.split()
        times[cluster, coupling, step] = (math.nan if time == "-"
                                          else float(time))
    return times
