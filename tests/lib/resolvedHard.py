#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Hard cases of bodies that fill cells, in a tank that is refined around
#     them, 12 cells over the diameter, on 1 or on 2 ranks that meet in the
#     middle of the tank. Each prints the number that its row must hold and gives
#     its case.
#         refining(ranks=2)       23: the mesh changes in each step
#         leaving(ranks=2)        25: a sphere leaves through an outlet
#         released(0.1, ranks=2)  17: a sphere of a density ratio, released
#------------------------------------------------------------------------------
import re
import shutil

import numpy as np

from badInput import edit
from cases import ledger, setEntry
from cloudCase import copyCase, readBodies, runIn, runParallel
from figure import figure, figureNear, figureTrue
from resolvedCases import setTimes, tests

properties = "constant/demCloudProperties"
d = 0.02


def tank(name, nu=None, density=500, body="position (0.1 0.1 0.1);", step=1e-3,
         steps=10):
    case = copyCase(tests + "analytic/releasedSphere", name)
    edit(case, properties, "position (0.1 0.1 0.1);", body)
    edit(case, properties, "density 500", "density %.10g" % density)
    if nu is not None:
        setEntry(case + "/constant/transportProperties", "nu", "%.10g" % nu)
    setTimes(case, step, steps*step)
    setEntry(case + "/system/controlDict", "writePrecision", "12")
    shutil.copy(tests + "analytic/periodicArray/system/decomposeParDict",
                case + "/system")
    return case


def solve(case, ranks):
    if ranks == 1:
        return runIn(case, "pimpleFoam")
    return runParallel(case, ranks, "pimpleFoam")


def names(name, ranks):
    """Name of the case, and what figures get at the end."""
    return (name, "") if ranks == 1 else (
        "%s_%d" % (name, ranks), "_%dranks" % ranks)


def refining(ranks=1):
    """Re 20, half a cell a step; no weight, and so heavy that the speed
    stays. It crosses from rank to rank."""
    name, end = names("refining", ranks)
    U = 0.2
    step = 0.5*d/12/U
    case = tank(name, U*d/20, 1e9, "position (%s 0.1007 0.1005); velocity"
                " (%g 0 0);" % ("0.0612" if ranks == 1 else "0.0812", U), step,
                40)
    setEntry(case + "/constant/g", "value", "(0 0 0)")
    setEntry(case + "/constant/dynamicMeshDict", "refineInterval", "1")
    runIn(case, "blockMesh")
    log = solve(case, ranks)
    force = np.array([r["toBodies"][0] for r in ledger(log)])[15:]
    smooth = np.polyval(np.polyfit(range(len(force)), force, 4),
                        range(len(force)))
    with open(log) as text:
        changes = len(re.findall("^Refined from|^Unrefined from", text.read(),
                                 re.M))
    figure("resolvedStates_refined" + end, changes, 10, None, "times",
           "the mesh changes")
    figure("resolvedStates_refining" + end,
           100*abs(force - smooth).max()/abs(smooth.mean()), None, 5, "%",
           "largest jump of the force over drag, hard case 23, %d ranks"
           % ranks)
    return case


def leaving(ranks=1):
    name, end = names("leaving", ranks)
    case = tank(name, density=2000, body="position (0.18 0.1 0.1); velocity"
                " (0.8 0 0);", steps=45)
    edit(case, "system/blockMeshDict", "walls\n    {",
         "out\n    {\n        type patch;\n        faces ((1 2 6 5));\n    }\n"
         "    walls\n    {")
    edit(case, "system/blockMeshDict", "(0 1 5 4) (1 2 6 5) ", "(0 1 5 4) ")
    for field, kind in (("U", "inletOutlet; inletValue uniform (0 0 0); value"
                         " uniform (0 0 0)"),
                        ("p", "fixedValue; value uniform 0")):
        edit(case, "0/" + field, "{ walls", "{ out { type %s; } walls" % kind)
    runIn(case, "blockMesh")
    log = solve(case, ranks)
    records = ledger(log)
    figure("resolvedStates_leaving" + end, records[-1]["bodies"], 0, 0,
           "bodies", "gone whole, hard case 25, %d ranks" % ranks)
    with open(log) as text:
        figureTrue("resolvedStates_leavingCounted" + end,
                   "1 left the domain" in text.read(), "said in the summary",
                   "it is counted", "hard case 25")
    figure("resolvedStates_leavingExchange" + end,
           max(r.get("mismatch", 0) for r in records), None, 1e-10, "-",
           "bodies received against the matrix, half outside too")
    return case


def released(ratio, ranks=1):
    """The accelerations over those of the added mass."""
    name, end = names("ratio%g" % ratio, ranks)
    case = tank(name, density=1000*ratio)
    runIn(case, "blockMesh")
    speed = [r["fastest"] for r in ledger(solve(case, ranks))]
    name = "releasedSphere_ratio%g" % ratio

    if ratio == 1:
        figure(name + end, max(speed)/0.01, None, 1e-3, "m/s2",
               "rests: no growth, %d ranks" % ranks)
        return case

    # Slope of the velocity gained after the first step, by least squares
    times = [1e-3*n for n in range(1, len(speed))]
    gained = [v - speed[0] for v in speed[1:]]
    slope = (sum(v*t for v, t in zip(gained, times))
             /sum(t*t for t in times))
    exact = 9.81*abs(ratio - 1)/(ratio + 0.5)
    figureNear(name + end, slope, exact, 0.05, "m/s2",
               "added mass, references 12, %d ranks" % ranks)

    # In no step more than a fifth above it (hard case 17)
    steps = [(b - a)/1e-3 for a, b in zip(speed, speed[1:])]
    figure(name + "_largest" + end, max(steps)/exact, None, 1.2, "-",
           "largest acceleration in a step over the closed form")

    # No growth of what is not smooth: second differences of the velocity
    jumps = [abs(speed[k + 1] - 2*speed[k] + speed[k - 1])
             for k in range(1, len(speed) - 1)]
    figure(name + "_noise" + end, max(jumps[-4:])/(exact*1e-3), None, 0.05,
           "-", "change of the acceleration from step to step")
    return case
