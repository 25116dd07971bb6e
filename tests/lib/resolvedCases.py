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
#         releasedPlate(0.5, 4, 11)       accelerations over the closed form
#         inStyxFoam("case", "type pisoIB;", 3)
#                                 the same case for styxFoam, 3 correctors
#------------------------------------------------------------------------------
import math
import os
import re
import shutil

from badInput import edit
from cases import ledger, setEntry
from cloudCase import copyCase, runIn, runParallel

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


def inStyxFoam(case, immersed, correctors):
    """Turn a case of pimpleFoam into one of styxFoam."""
    os.remove(case + "/constant/fvOptions")
    setEntry(case + "/constant/demCloudProperties", "immersed",
             "{ %s }" % immersed)
    edit(case, "system/fvSchemes", "div(phi,U) ", "div(alphaPhi,U) ")
    edit(case, "system/fvSchemes", "div((nuEff*dev2(T(grad(U)))))",
         "div(((voidFraction*nuEff)*dev2(T(grad(U)))))")
    setEntry(case + "/system/fvSolution", "PIMPLE/nCorrectors",
             str(correctors))


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


def cylinderInOpen(case, cells, step, end):
    """The cylinder of the channel, D = 0.1 m, 15 D behind an inlet of 1 m/s,
    25 D before the outlet, 20 D from sides that slip; cells over D near it."""
    copyCase(tests + "validation/schaeferTurek2D1", case)
    D = 0.1
    x, y = (-1.5, 2.5), (-2, 2)
    core = (-0.75*D, 1.5*D, -0.75*D, 0.75*D)

    def sections(low, high, inner, numbers, ratios):
        """Three pieces of a side: length, cells, last cell over first."""
        lengths = (inner[0] - low, inner[1] - inner[0], high - inner[1])
        return "(%s)" % " ".join("(%.6g %d %.6g)" % row for row in
                                 zip(lengths, numbers, ratios))

    nx = [round(1.75*cells), round(2.25*cells), 4*cells]
    ny = [round(1.8*cells), round(1.5*cells), round(1.8*cells)]
    grading = "%s %s 1" % (
        sections(*x, core[:2], nx, (1/27, 1, 18)),
        sections(*y, core[2:], ny, (1/38, 1, 38)))
    text = open(case + "/system/blockMeshDict").read()
    head = text[:text.index("// 20 cells")]
    points = ["(%g %g %g)" % (a, b, c) for c in (0, 0.05) for b in y for a in x]
    with open(case + "/system/blockMeshDict", "w") as out:
        out.write(head + "vertices\n(\n%s\n);\n\nblocks\n(\n"
                  "hex (0 1 3 2 4 5 7 6) (%d %d 1) simpleGrading (%s)\n);\n"
                  % ("\n".join(points), sum(nx), sum(ny), grading) + """
boundary
(
    inlet        { type patch; faces ((0 4 6 2)); }
    outlet       { type patch; faces ((1 3 7 5)); }
    walls        { type patch; faces ((0 1 5 4) (2 6 7 3)); }
    frontAndBack { type empty; faces ((0 2 3 1) (4 5 7 6)); }
);
""")
    # No side of the cylinder lies on a side of cells
    edit(case, "constant/demCloudProperties", "(0.2 0.2 0.025)",
         "(%.8g %.8g 0.025)" % (0.3*D/cells, 0.2*D/cells))
    text = open(case + "/0/U").read()
    with open(case + "/0/U", "w") as out:
        out.write(text[:text.index("internalField")] + """\
internalField   uniform (1 0 0);
boundaryField
{
    inlet        { type fixedValue; value uniform (1 0 0); }
    outlet       { type inletOutlet; inletValue uniform (0 0 0);
                   value uniform (1 0 0); }
    walls        { type slip; }
    frontAndBack { type empty; }
}
""")
    setTimes(case, step, end)
    runIn(case, "blockMesh")


def gradedCube(case, cells, half, step, end, shear=None):
    """The cube of periodicArray about the origin, whose sides are walls half
    away from the middle: even cells, so many over 1 m, within 1 m, three times
    as many by grading outside. With a rate of shear the flow starts with it, the
    walls across y move along x, and the other sides are cyclic."""
    copyCase(tests + "analytic/periodicArray", case)
    text = open(case + "/system/blockMeshDict").read()
    outer = round(0.75*cells)
    grading = "(%s)" % " ".join("(%g %d %g)" % row for row in (
        (half - 1, outer, 1/9), (2, 2*cells, 1), (half - 1, outer, 9)))
    n = 2*(outer + cells)
    corners = " ".join("(%g %g %g)" % (a*half, b*half, c*half)
                       for c in (-1, 1) for a, b in
                       ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    sides = text[text.index("boundary"):]
    if shear:
        for old, name in (("front", "bottomWall"), ("back", "topWall")):
            sides = re.sub(r"%s +\{ type cyclic; neighbourPatch \w+;" % old,
                           "%s { type wall;" % name, sides)
    else:
        sides = re.sub(r"type cyclic; neighbourPatch \w+;", "type wall;",
                       sides)
    with open(case + "/system/blockMeshDict", "w") as out:
        out.write(text[:text.index("// A unit cell")] + """
vertices ( %s );
blocks ( hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (%s) );
""" % (corners, n, n, n, " ".join(3*(grading,))) + sides)
    flow = {"U": ("noSlip;", "fixedValue; value uniform (%g 0 0);"),
            "p": ("zeroGradient;", "zeroGradient;")}
    for field, (still, moving) in flow.items():
        file = case + "/0/" + field
        text = open(file).read()
        if shear:
            entries = '".*" { type cyclic; }\n'
            for name, sign in (("bottomWall", -1), ("topWall", 1)):
                entries += "    %s { type %s }\n" % (
                    name, moving % (sign*half*shear) if field == "U" else moving)
        else:
            entries = '".*" { type %s }\n' % still
        with open(file, "w") as out:
            out.write(text.replace('".*" { type cyclic; }\n', entries))
    edit(case, "system/fvSolution", "smoothSolver", "PBiCGStab")
    edit(case, "system/fvSolution", "smoother        symGaussSeidel",
         "preconditioner DILU")
    setEntry(case + "/constant/fvOptions", "drive", None)
    setTimes(case, step, end)
    runIn(case, "blockMesh")
    if shear:
        with open(case + "/system/setExprFieldsDict", "w") as out:
            out.write("""FoamFile
{ version 2.0; format ascii; class dictionary; object setExprFieldsDict; }
expressions
(
    U
    {
        field       U;
        dimensions  [0 1 -1 0 0 0 0];
        condition   "";
        expression  "vector(%g*pos().y(), 0, 0)";
        keepPatches true;
    }
);
""" % shear)
        runIn(case, "setExprFields")


def writeSpheroid(file, a, c, around=32, along=16):
    """A spheroid about z with the semi-axes a, a, c as an STL surface."""
    def point(i, j):
        t, p = math.pi*i/along, 2*math.pi*j/around
        return (a*math.sin(t)*math.cos(p), a*math.sin(t)*math.sin(p),
                c*math.cos(t))

    with open(file, "w") as out:
        out.write("solid spheroid\n")
        for i in range(along):
            for j in range(around):
                top, low = point(i, j), point(i + 1, j)
                triangles = []
                if i < along - 1:
                    triangles.append((top, low, point(i + 1, j + 1)))
                if i > 0:
                    triangles.append((top, point(i + 1, j + 1) if i < along - 1
                                      else low, point(i, j + 1)))
                for triangle in triangles:
                    out.write("facet normal 0 0 0\nouter loop\n")
                    for corner in triangle:
                        out.write("vertex %.12g %.12g %.12g\n" % corner)
                    out.write("endloop\nendfacet\n")
        out.write("endsolid spheroid\n")


def releasedPlate(ratio, levels, steps, dt=1e-3, ranks=1):
    """Accelerations, after the first step and over the closed form, of a flat
    spheroid of 20 by 2 mm that is released broadside in a still fluid, the
    mesh refined levels times; at ratio 1 over that of gravity."""
    a, c, rho, g = 0.01, 0.001, 1000, 9.81
    case = copyCase(tests + "analytic/releasedSphere",
                    "levels%d_%g_%d" % (levels, ratio, ranks))
    writeSpheroid(case + "/constant/plate.stl", a, c)
    with open(case + "/constant/plate.multisphere", "w") as out:
        out.write("FoamFile { version 2.0; format ascii; class dictionary;"
                  " object plate; }\nspheres\n(\n    ((0 0 0) 1e-3)"
                  " ((6e-3 0 0) 8e-4) ((-6e-3 0 0) 8e-4)\n);\n")
    properties = case + "/constant/demCloudProperties"
    setEntry(properties, "shapes/sphere", '{ type multisphere;'
             ' file "plate.multisphere"; geometry surface;'
             ' surface "plate.stl"; }')
    setEntry(properties, "materials/light/density", "%g" % (rho*ratio))
    setEntry(case + "/constant/dynamicMeshDict", "maxRefinement",
             "%d" % levels)
    setTimes(case, dt, steps*dt)
    runIn(case, "blockMesh")
    shutil.copy(tests + "analytic/periodicArray/system/decomposeParDict",
                case + "/system")
    log = (runIn(case, "pimpleFoam") if ranks == 1 else
           runParallel(case, ranks, "pimpleFoam"))
    speed = [r["fastest"] for r in ledger(log)]

    # Lamb, article 114, for an oblate spheroid along its axis
    e = math.sqrt(1 - (c/a)**2)
    alpha = 2/e**2*(1 - c/a*math.asin(e)/e)
    exact = g*abs(ratio - 1)/(ratio + alpha/(2 - alpha))
    return [(v - u)/dt/(exact or g) for u, v in zip(speed, speed[1:])]
