#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The tutorial fallingRocks, shortened to so many fluid steps in which three
#     rocks come in, hit the pipe and each other, on several numbers of ranks.
#         compareRanks("name", {2: "(2 1 1)"}, levels=1, steps=100, bars={2: 1e-5})
#     in steps of 0.2 s over their number.
#     The linear solvers are tight: what they leave is what the ranks differ by,
#     and each collision makes it larger.
#------------------------------------------------------------------------------
import os
import re

from cases import ledger, setEntry
from cloudCase import copyCase, distance, meshChanges, readBodies, runIn, \
    runParallel
from figure import figure, figureTrue

end = "0.2"
diameter = 0.04     # of the sphere of the rock's volume [m], rounded down

tight = """solvers
{
    "(p|pcorr).*"
    {
        solver          GAMG;
        smoother        DICGaussSeidel;
        tolerance       1e-13;
        relTol          0;
    }

    "U.*"
    {
        solver          PBiCGStab;
        preconditioner  DILU;
        tolerance       1e-14;
        relTol          0;
    }
}

"""


def prepare(case, levels, steps):
    """The tutorial as far as the mesh, shortened."""
    copyCase(os.environ["STYX_DIR"] + "/tutorials/resolved/fallingRocks", case)
    runIn(case, "./Allclean")
    runIn(case, "./makeRock", "constant/rock.stl")
    runIn(case, "surfaceToMultisphere", "constant/rock.stl",
          "constant/rock.multisphere", "-spheres", "5", "-fit")
    runIn(case, "blockMesh")
    runIn(case, "topoSet")
    runIn(case, "subsetMesh", "water", "-patch", "pipe", "-overwrite")
    copyCase(case + "/0.orig", case + "/0")

    setEntry(case + "/system/controlDict", "endTime", end)
    setEntry(case + "/system/controlDict", "deltaT", "%g" % (0.2/steps))
    setEntry(case + "/constant/dynamicMeshDict", "maxRefinement", str(levels))
    particles = case + "/constant/demCloudProperties"
    for key, value in (("rate", "30"), ("total", "3"),
                       ("velocity", "(0.6 0 -0.8)")):
        setEntry(particles, "generators/pipe/" + key, value)

    file = case + "/system/fvSolution"
    with open(file) as stream:
        text = stream.read()
    with open(file, "w") as stream:
        stream.write(re.sub(r"solvers\n\{.*?\n\}\n\n", tight, text,
                            flags=re.S))


def compareRanks(name, blocks, levels, steps, bars):
    """Figures of each number of ranks against one."""
    prepare("case", levels, steps)
    copyCase("case", "ranks1")
    log = runIn("ranks1", "pimpleFoam")
    expected = readBodies("ranks1", end, "position")
    changes = meshChanges(log)
    lines = ledger(log)

    figure(name + "_steps", len(lines), steps, steps, "fluid steps",
           end + " s")
    figure(name + "_rocks", len(expected), 3, 3, "rocks", "come in")
    figure(name + "_collisions", sum(
        b["contacts"] > a["contacts"] for a, b in zip(lines, lines[1:])),
        3, None, "times", "contacts begin")
    figure(name + "_refinements", sum(" refined " in " " + line.lower()
                                      for line in changes),
           20, None, "times", "the mesh changes")

    for ranks, n in blocks.items():
        case = copyCase("case", "ranks%d" % ranks)
        log = runParallel(case, ranks, "pimpleFoam", n)
        found = readBodies(case, end, "position")
        figure("%s_%d" % (name, ranks),
               distance(expected, found, "position")/diameter, None,
               bars[ranks],
               "d", "%d ranks against 1 after %d steps" % (ranks, steps))
        figureTrue("%s_%d_cells" % (name, ranks),
                   meshChanges(log) == changes,
                   "%d lines on the mesh" % len(changes), "the same",
                   "cells refined and merged at each change")
