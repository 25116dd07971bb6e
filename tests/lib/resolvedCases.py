#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Cases around bodies that are larger than cells, on meshes of any fineness.
#         channel("case", 16)     Schaefer & Turek, 16 cells over the diameter
#         cube("case", 36, 3.0, nu, properties)
#                                 a cube of 36^3 cells with cyclic sides
#         startFrom("fine", "coarse")     the flow of another mesh
#------------------------------------------------------------------------------
import os
import re
import shutil

from badInput import edit
from cases import setEntry
from cloudCase import copyCase, runIn

tests = os.environ["STYX_DIR"] + "/tests/"


def setTimes(case, step, end):
    control = case + "/system/controlDict"
    setEntry(control, "deltaT", "%.10g" % step)
    setEntry(control, "endTime", "%.10g" % end)
    setEntry(control, "writeInterval", "%.10g" % end)


def channel(case, cells, step, end, speed=0.3):
    """The channel with cells over the diameter of the cylinder; speed is
    the largest at the inlet [m/s]."""
    copyCase(tests + "validation/schaeferTurek2D1", case)
    points = ["(%g %g %g)" % (x, y, z) for z in (0, 0.05)
              for y in (0, 0.4, 0.41) for x in (0, 0.5, 2.2)]
    blocks = []
    for row, ny in ((0, 4*cells), (1, max(1, round(0.12*cells)))):
        for column, nx in ((0, 5*cells), (1, 6*cells)):
            a = 3*row + column
            low = (a, a + 1, a + 4, a + 3)
            blocks.append("hex (%d %d %d %d %d %d %d %d)" % (
                low + tuple(p + 9 for p in low))
                + " (%d %d 1) simpleGrading (%d 1 1)" % (
                    nx, ny, 6 if column else 1))
    text = open(case + "/system/blockMeshDict").read()
    head = text[:text.index("// 20 cells")]
    with open(case + "/system/blockMeshDict", "w") as out:
        out.write(head + "vertices\n(\n%s\n);\n\nblocks\n(\n%s\n);\n" % (
            "\n".join(points), "\n".join(blocks)) + """
boundary
(
    inlet        { type patch; faces ((0 9 12 3) (3 12 15 6)); }
    outlet       { type patch; faces ((2 5 14 11) (5 8 17 14)); }
    walls
    {
        type  wall;
        faces ((0 1 10 9) (1 2 11 10) (6 15 16 7) (7 16 17 8));
    }
    frontAndBack
    {
        type  empty;
        faces
        (
            (0 3 4 1) (1 4 5 2) (3 6 7 4) (4 7 8 5)
            (9 10 13 12) (10 11 14 13) (12 13 16 15) (13 14 17 16)
        );
    }
);
""")
    # The profile has the peak 0.3 m/s in the case that was copied
    for old in ("2.926829268", "-7.138607971"):
        edit(case, "0/U", old, "%.9f" % (float(old)*speed/0.3))
    setTimes(case, step, end)
    runIn(case, "blockMesh")


def cube(case, cells, edge, nu, properties, step, end, drive=None):
    """A cube with cyclic sides; drive is the acceleration along x [m/s2]."""
    copyCase(tests + "analytic/periodicArray", case)
    edit(case, "system/blockMeshDict", "(24 24 24)", "(%d %d %d)" % (
        cells, cells, cells))
    edit(case, "system/blockMeshDict", "vertices",
         "scale %.10g;\n\nvertices" % edge)
    setEntry(case + "/constant/transportProperties", "nu", "%.10g" % nu)
    file = case + "/constant/demCloudProperties"
    text = open(file).read()
    with open(file, "w") as out:
        out.write(text[:text.index("coupling")] + properties)
    if drive is None:
        setEntry(case + "/constant/fvOptions", "drive", None)
    else:
        edit(case, "constant/fvOptions", "(0.01 0 0)", "(%.10g 0 0)" % drive)
    setTimes(case, step, end)
    runIn(case, "blockMesh")


def startFrom(case, other):
    """Start with the last flow of another mesh."""
    runIn(case, "mapFields", os.path.abspath(other), "-consistent",
          "-sourceTime", "latestTime")
    for folder in ("lagrangian", "uniform"):
        shutil.rmtree(case + "/0/" + folder, ignore_errors=True)


def meanVelocity(log):
    """The last mean velocity along x that a log has [m/s]."""
    with open(log) as text:
        return float(re.findall(r"volAverage.* of U = \((\S+)", text.read())
                     [-1])


def writeBox(file, edges, centre=(0, 0, 0)):
    """A box as an STL surface, two triangles a side."""
    corner = [[centre[d] + edges[d]*((k >> d & 1) - 0.5) for d in range(3)]
              for k in range(8)]
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4),
             (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    with open(file, "w") as out:
        out.write("solid box\n")
        for a, b, c, d in sides:
            for triangle in ((a, b, c), (a, c, d)):
                out.write("facet normal 0 0 0\nouter loop\n")
                for k in triangle:
                    out.write("vertex %.10g %.10g %.10g\n" % tuple(corner[k]))
                out.write("endloop\nendfacet\n")
        out.write("endsolid box\n")
