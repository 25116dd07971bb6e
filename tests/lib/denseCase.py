#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Cases for styxFoam: a box of water, closed above and below and cyclic at
#     its sides, with glass spheres of 1 mm.
#         case = prepare("name", size, cells, centres, "type centroid;")
#         terminal()          velocity of one of them [m/s]
#         fastest(case, (0.1, 0.2))       of the fluid, at these times [m/s]
#         centres = cloud(55, (6e-3, 6e-3), (14e-3, 22e-3))
#         bedBesideWater("A", ranks=2)    hard case 20, prints its figures
#         addStone(case, (8e-3, 8e-3, 17e-3), 8e-3, "immersed { ... } ...")
#------------------------------------------------------------------------------
import glob
import os
import re

import numpy as np

from badInput import edit
from cases import ledger, setEntry
from cloudCase import copyCase, runIn, runParallel
from figure import figure

tutorial = os.environ["STYX_DIR"] + "/tutorials/unresolved/ergunBed"
properties = "constant/demCloudProperties"
d, density, rho, nu, g = 1e-3, 2500.0, 1000.0, 1e-6, 9.81


def terminal():
    """Of one sphere, Schiller and Naumann [m/s]."""
    low, high = 0.0, 1.0
    for _ in range(100):
        v = (low + high)/2
        Re = v*d/nu
        drag = 18*nu*v/d**2*(1 + 0.15*Re**0.687)
        low, high = (v, high) if drag < (density/rho - 1)*g else (low, v)
    return low


def prepare(name, size, cells, centres, voidFraction, solver="hades",
            forces="drag gidaspow; buoyancy yes; pressureGradient yes;",
            equations="A", dt=2e-4, end=0.1, sides="cyclic"):
    """A box of water, closed above and below, with spheres of 1 mm."""
    case = copyCase(tutorial, name)
    os.rename(case + "/0.orig", case + "/0")
    corners = " ".join("(%.9g %.9g %.9g)" % c for c in (
        (x, y, z) for z in (0, size[2]) for x, y in (
            (0, 0), (size[0], 0), (size[0], size[1]), (0, size[1]))))
    more = {"cyclic": ("", ""), "cyclicAMI": (
        " transform translational; separationVector (%g 0 0);" % size[0],
        " transform translational; separationVector (%g 0 0);" % -size[0])
        }[sides]
    with open(case + "/system/blockMeshDict", "w") as out:
        out.write("""FoamFile { version 2.0; format ascii; class dictionary;
    object blockMeshDict; }
scale 1;
vertices (%s);
blocks (hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (1 1 1));
boundary
(
    bottom { type wall; faces ((0 3 2 1)); }
    top    { type wall; faces ((4 5 6 7)); }
    left   { type %s; neighbourPatch right;%s faces ((3 0 4 7)); }
    right  { type %s; neighbourPatch left;%s faces ((1 2 6 5)); }
    front  { type cyclic; neighbourPatch back; faces ((0 1 5 4)); }
    back   { type cyclic; neighbourPatch front; faces ((2 3 7 6)); }
);
""" % (corners, *cells, sides, more[0], sides, more[1]))
    for field, kind in (("U", "noSlip"), ("p", "zeroGradient")):
        with open("%s/0/%s" % (case, field)) as text:
            head = text.read().split("dimensions")[0]
        with open("%s/0/%s" % (case, field), "w") as out:
            out.write(head + "dimensions [%s];\ninternalField uniform %s;\n"
                      "boundaryField { \"top|bottom\" { type %s; }"
                      " \"left|right\" { type %s; }"
                      " \"front|back\" { type cyclic; } }\n"
                      % (("0 1 -1 0 0 0 0", "(0 0 0)", kind, sides)
                         if field == "U" else
                         ("0 2 -2 0 0 0 0", "0", kind, sides)))
    with open(case + "/constant/bed", "w") as out:
        out.write("bodies\n{\n")
        for n, x in enumerate(centres):
            out.write("    s%d { shape sphere; material glass; position"
                      " (%.9g %.9g %.9g); }\n" % (n, *x))
        out.write("}\n")
    path = case + "/" + properties
    with open(path) as text:
        all_ = text.read()
    all_ = re.sub(r"forces\n\{.*?\n\}\n", "forces { %s interpolation cell; }\n"
                  "walls { floor { type patch; patches (\"top|bottom\");"
                  " material glass; } }\n" % forces, all_, flags=re.S)
    for old, new in (
            (r"demSolver .*", "demSolver %s;" % solver),
            (r"fluid  .*", "fluid { rho %g; }" % rho),
            (r"voidFraction  .*", "voidFraction { %s }" % voidFraction),
            (r"equations A", "equations " + equations),
            (r"density 2000", "density %g" % density)):
        all_ = re.sub(old, new, all_, count=1)
    with open(path, "w") as out:
        out.write(all_)
    setEntry(case + "/constant/transportProperties", "nu", "%g" % nu)
    control = case + "/system/controlDict"
    setEntry(control, "deltaT", "%g" % dt)
    setEntry(control, "endTime", "%g" % end)
    setEntry(control, "writeInterval", "%d" % max(1, round(end/dt/5)))
    solution = case + "/system/fvSolution"
    setEntry(solution, "PIMPLE/pRefCell", "0")
    setEntry(solution, "PIMPLE/pRefValue", "0")
    runIn(case, "blockMesh")
    return case


def fastest(case, times):
    """Largest velocity of the fluid at the ends of these times [m/s]."""
    most = 0
    parts = glob.glob(case + "/processor[0-9]*") or [case]
    for file in ["%s/%g/U" % (part, time) for part in parts for time in times]:
        with open(file) as text:
            body = text.read().split("internalField")[1].split(
                "boundaryField")[0]
        rows = re.findall(r"\(([-+0-9.e]+) ([-+0-9.e]+) ([-+0-9.e]+)\)", body)
        most = max([most] + [np.linalg.norm([float(w) for w in row])
                             for row in rows])
    return most


def cloud(number, across, heights):
    """Centres at random between two heights, that do not touch."""
    across, random = np.array(across), np.random.default_rng(3)
    centres = []
    while len(centres) < number:
        x = random.uniform((0, 0, heights[0]), (*across, heights[1]))
        away = np.array(centres).reshape(-1, 3) - x
        away[:, :2] -= across*np.round(away[:, :2]/across)
        if not centres or np.min(np.linalg.norm(away, axis=1)) > 1.02*d:
            centres.append(x)
    return centres


def bedBesideWater(equations, ranks=1, end=0.3):
    """Hard case 20: four spheres a cell on a lattice, layers on the floor, and
    still water above, with the bed fixed and held by its contacts. Ranks meet
    in the middle of the bed."""
    a = 1.4412e-3
    bed = [((i + x)*a, (j + y)*a, k*a + z*a/2 + 0.5*d)
           for k in range(8) for j in range(5) for i in range(5)
           for x, y, z in ((0.25, 0.25, 0), (0.75, 0.75, 0),
                           (0.75, 0.25, 1), (0.25, 0.75, 1))]
    box, fall = ((5*a, 5*a, 16*a), (5, 5, 16)), terminal()
    forces = "drag gidaspow; buoyancy yes;" + (
        " pressureGradient yes;" if equations == "A" else "")
    name, number = ("hard20_" + equations,
                    "" if ranks == 1 else str(ranks))

    def solve(case):
        return (runIn(case, "styxFoam") if ranks == 1 else
                runParallel(case, ranks, "styxFoam"))

    case = prepare("fixed%s%s" % (equations, number), *box, bed,
                   "type centroid;", "fixed", forces, equations, end=0.02)
    with open(solve(case)) as text:
        least = re.findall(r"void fraction from ([0-9.]+)", text.read())
    figure(name + "_void" + number, float(least[-1]), 0.295, 0.305,
           "-", "four spheres a cell, next to cells without, %d ranks" % ranks)
    figure(name + "_fixed" + number,
           fastest(case, (0.004, 0.02))/fall, None, 0.01, "of terminal",
           "the fluid stays still, hard case 20")
    case = prepare("held%s%s" % (equations, number), *box, bed,
                   "type centroid;", "hades", forces, equations, end=end,
                   dt=5e-4)
    log = solve(case)
    figure(name + "_held" + number,
           fastest(case, (0.8*end, end))/fall, None, 0.01, "of terminal",
           "a bed that its contacts hold, at rest")
    figure(name + "_bed" + number,
           max(s["fastest"] for s in ledger(log)[-50:])/fall, None, 0.01,
           "of terminal", "the spheres, at rest")


def addStone(case, x, diameter, more="", density=2500):
    """Add a sphere that is resolved, if more says so."""
    edit(case, properties, "shapes\n{", "shapes\n{\n    stone { type sphere;"
         " diameter %g; }" % diameter)
    edit(case, properties, "materials\n{", "materials\n{\n    heavy { density"
         " %g; youngsModulus 5e6; poissonsRatio 0.45; }" % density)
    edit(case, properties, "pairs\n{", "pairs\n{\n"
         "    heavy-heavy { restitution 0.3; friction 0.5; }\n"
         "    glass-heavy { restitution 0.3; friction 0.5; }")
    edit(case, "constant/bed", "bodies\n{", "bodies\n{\n    stone { shape"
         " stone; material heavy; position (%g %g %g); }" % x)
    with open(case + "/" + properties, "a") as out:
        out.write(more)
