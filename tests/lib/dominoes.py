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
import re
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


def startsOf(case, cluster, coupling, step, number):
    """Fall times where the first column leans by a millionth of a degree more
    from one start to the next [s]."""
    times = []
    for k in range(1, number + 1):
        run = "starts/%s_%s_%s_%d" % (cluster, coupling, step, k)
        runIn(case, "./makeCase", cluster, coupling, step, run)
        file = case + "/" + run + "/constant/demCloudProperties"
        with open(file) as text:
            leaning, n = re.subn(r"rotation\s[^;]*;", "rotation ((0 1 0) %.9f);"
                                 % (12 + 1e-6*k), text.read(), count=1)
        assert n == 1, file
        with open(file, "w") as text:
            text.write(leaning)
        runIn(case + "/" + run, "blockMesh")
        runIn(case + "/" + run,
              "demFoam" if coupling == "vacuum" else "pimpleFoam")
        with open(case + "/" + run
                  + "/postProcessing/fallen/0/massFlow.dat") as rows:
            fallen = [row.split() for row in rows if row[0] != "#"]
        times += [float(row[0]) for row in fallen if int(row[1]) > 0][:1]
    print("%s %s %s s: %s" % (cluster, coupling, step, times))
    return times
