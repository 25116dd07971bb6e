#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The hard cases that are restarted in the middle (hard case 16), by their
#     row: 1 (steel spheres that fall into a box), 6 (a wall that closes on a
#     packed bed), 9 (a tower of cubes), 17 (a light sphere released in a still
#     fluid), 20 (a bed in water that ends between two cells) and 24 (two bodies
#     that come to lie on each other in a fluid).
#         compare(6)              run through, against restarted at half
#         compare(6, ranks=2)     the same on 2 ranks
#------------------------------------------------------------------------------
import glob
import os
import re
import shutil

from cases import setEntry
from cloudCase import copyCase, distance, onRanks, readBodies, restartAt, runIn
from denseCase import prepare
from figure import figure
from sceneCases import makeCase


def restart(case, middle):
    """A copy that goes on from its middle."""
    again = restartAt(case, middle, case + "Again")
    for folder in glob.glob(again + "/processor*/[0-9]*"):
        if float(os.path.basename(folder)) > float(middle) + 1e-9:
            shutil.rmtree(folder)
    return again


def solve(case, solver, ranks):
    return (runIn(case, solver) if ranks == 1 else
            runIn(case, *onRanks(ranks, solver), log="log." + solver))


def compare(row, ranks=1):
    """A run that goes through, against one that goes on from its middle; the
    distance over the size of a body [m]."""
    case, middle, end, size, solver = rows[row]()
    if ranks > 1:
        runIn(case, "decomposePar")
    log = solve(case, solver, ranks)
    again = restart(case, middle)
    solve(again, solver, ranks)
    a, b = (readBodies(c, end, "position", "velocity") for c in (case, again))
    with open(log) as text:
        contacts = re.findall(r"(\d+) contacts", text.read())
    figure("hard16_row%d" % row + ("" if ranks == 1 else "_ranks"),
           distance(a, b, "position")/size, None, 1e-9, "d",
           "a restart at half of the run, %s contacts at the end, %d ranks"
           % (contacts[-1], ranks))


def bodies(shape, material, places, velocity="(0 0 0)"):
    return "bodies { %s }\n" % "".join(
        "b%d { shape %s; material %s; position (%.10g %.10g %.10g); velocity"
        " %s; }\n" % (i, shape, material, *x, velocity)
        for i, x in enumerate(places))


def dry(row, edge, properties, step, middle, end, size):
    case = makeCase("row%d" % row, edge=edge, n=(4, 4, 4), deltaT=step,
                    endTime=float(end), kind="patch",
                    properties="demSolver hades; coupling none;\n"
                    + properties)
    setEntry(case + "/system/controlDict", "writeInterval", middle)
    runIn(case, "blockMesh")
    return case, middle, end, size, "demFoam"


def wet(row, edge, n, places, properties, end, **more):
    case = makeCase("row%d" % row, edge=edge, n=n, rho=1000, deltaT=5e-4,
                    endTime=end, properties="""
demSolver hades; coupling twoWay;
pairs { s-s { restitution 0.8; friction 0.3; } }
shapes { ball { type sphere; diameter 0.01; } }
walls { tank { type patch; material s; } }
stepControl { type hades; }
immersed { type implicitForcing; }
""" + properties + bodies("ball", "s", places), **more)
    setEntry(case + "/system/controlDict", "writeInterval", "%g" % (end/2))
    runIn(case, "blockMesh")
    return case, "%g" % (end/2), "%g" % end, 0.01, "pimpleFoam"


box = """walls { box { type box; min (0 0 0); max (%g %g %g); side inside;
    material s; } %s }
stepControl { type hades; }
"""
cube = """(
    (( 0.0000  0.0000  0.0000) 0.0065)
    (( 0.0032  0.0032 -0.0032) 0.00365) ((-0.0032 -0.0032 -0.0032) 0.00365)
    ((-0.0032  0.0032 -0.0032) 0.00365) (( 0.0032 -0.0032 -0.0032) 0.00365)
    (( 0.0032  0.0032  0.0032) 0.00365) ((-0.0032 -0.0032  0.0032) 0.00365)
    ((-0.0032  0.0032  0.0032) 0.00365) (( 0.0032 -0.0032  0.0032) 0.00365)
)"""


def steel():
    """200 of the 1000 spheres."""
    return dry(1, (0.008, 0.008, 0.04), """
materials { s { density 7800; youngsModulus 2e11; poissonsRatio 0.3; } }
pairs { s-s { restitution 0.8; friction 0.3; } }
shapes { ball { type sphere; diameter 0.001; } }
""" + box % (0.008, 0.008, 0.04, "") + bodies("ball", "s", [
        (0.001 + 0.0012*(i % 6) + 1e-5*(i % 7), 0.001 + 0.0012*(i//6 % 6),
         0.001 + 0.0013*(i//36)) for i in range(200)]),
        1e-3, "0.01", "0.02", 1e-3)


def closing():
    """The ceiling comes down on what lies at the floor."""
    return dry(6, (0.04, 0.04, 0.06), """
materials { s { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }
pairs { s-s { restitution 0.5; friction 0.5; } }
shapes { ball { type sphere; diameter 0.01; } }
""" + box % (0.04, 0.04, 0.06, """
    lid { type plane; point (0 0 0.0505); normal (0 0 -1); material s;
        motion { type translate; velocity (0 0 -1); stop 0.002; } }""")
        + bodies("ball", "s", [
            (0.005 + 0.01*(i % 4), 0.005 + 0.01*(i//4 % 4),
             0.005 + 0.01*(i//16)) for i in range(80)]),
        1e-4, "0.001", "0.002", 0.01)


def tower():
    return dry(9, (0.1, 0.1, 0.4), """
materials { s { density 1000; youngsModulus 1e7; poissonsRatio 0.3; } }
pairs { s-s { restitution 0.5; friction 0.5; } }
shapes { cube { type multisphere; spheres %s; } }
walls { floor { type plane; point (0 0 0); normal (0 0 1); material s; } }
stepControl { type contact; }
""" % cube + bodies("cube", "s", [
        (0.05, 0.05, 0.00685 + 0.0137*k) for k in range(27)]),
        5e-3, "0.05", "0.1", 0.012)


def light():
    """Density ratio 0.1."""
    return wet(17, (0.04, 0.04, 0.06), (32, 32, 48), [(0.02, 0.02, 0.02)], """
materials { s { density 100; youngsModulus 1e7; poissonsRatio 0.3; } }
""", 0.02)


def bedInWater():
    a, d = 1.4412e-3, 1e-3
    bed = [((i + x)*a, (j + y)*a, k*a + z*a/2 + 0.5*d)
           for k in range(8) for j in range(5) for i in range(5)
           for x, y, z in ((0.25, 0.25, 0), (0.75, 0.75, 0),
                           (0.75, 0.25, 1), (0.25, 0.75, 1))]
    case = prepare("row20", (5*a, 5*a, 16*a), (5, 5, 16), bed,
                   "type centroid;", dt=5e-4, end=0.02)
    for key, value in (("writeInterval", "20"), ("writePrecision", "17"),
                       ("timePrecision", "12")):
        setEntry(case + "/system/controlDict", key, value)
    return case, "0.01", "0.02", d, "styxFoam"


def pressed():
    """Two that fall come to lie on each other."""
    return wet(24, (0.04, 0.04, 0.06), (24, 24, 36),
               [(0.02, 0.02, 0.0052), (0.0201, 0.02, 0.0158)], """
materials { s { density 2650; youngsModulus 1e7; poissonsRatio 0.3; } }
""", 0.05)


rows = {1: steel, 6: closing, 9: tower, 17: light, 20: bedInWater, 24: pressed}
