#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Cases of demFoam that run on 1 and on 2 ranks, for hardRows.py.
#     The middle of a case is at the point middle, its floor at z = 0; bodies
#     are shared out between the ranks in two halves.
#         both = onRanks("row02", head(...) + bodies(...), step, end)
#         figureRanks("hard02", both, 0.01)         paths, 2 ranks against 1
#         both.states("2")        (time, positions, velocities) of each write
#------------------------------------------------------------------------------
import glob
import os
import re
import subprocess

import numpy as np

from cases import setEntry
from cloudCase import copyCase, distance, onRanks as command, readBodies, \
    runIn
from figure import figure
from sceneCases import makeCase

middle = np.array((0.2, 0.2, 0))
g = 9.81


def text(values):
    return "(%s)" % " ".join("%.17g" % v for v in values)


def head(E, pair, contact="", density=2500, control="type contact;"):
    """Contacts, material, steps."""
    return """demSolver hades; coupling none;
contact { %s }
materials { s { density %g; youngsModulus %g; poissonsRatio 0.3; } }
pairs { s-s { %s } }
stepControl { %s }
""" % (contact, density, E, pair, control)


def boxWalls(low, high, more=""):
    return ("walls { box { type box; min %s; max %s; side inside; material s;"
            " } %s }\n" % (text(middle + low), text(middle + high), more))


floor = ("walls { floor { type plane; point (0 0 0); normal (0 0 1);"
         " material s; } }\n")


def bodies(*rows):
    """Rows of (shape, position from the middle, velocity, spin)."""
    out = "bodies\n{\n"
    for n, row in enumerate(rows):
        shape, x, v, w = (*row, *((0, 0, 0),)*(4 - len(row)))
        out += ("b%d { shape %s; material s; position %s; velocity %s;"
                " angularVelocity %s; }\n" % (
                    n, shape, text(middle + x), text(v), text(w)))
    return out + "}\n"


def lattice(shape, d, pitch, n, low, random):
    """n spheres each way, shaken by a twentieth of their diameter."""
    cells = [(i, j, k) for k in range(n[2]) for j in range(n[1])
             for i in range(n[0])]
    return [(shape, low + d*(pitch*(np.array(c) + 0.5)
                             + 0.05*random.uniform(-1, 1, 3))) for c in cells]


def boxOfSpheres(name, d, pitch, n):
    return "%s { type multisphere; spheres (%s); }\n" % (name, " ".join(
        "(%s %.17g)" % (text(pitch*d*np.array((i, j, k))), 0.5*d)
        for k in range(n[2]) for j in range(n[1]) for i in range(n[0])))


class Both:
    """A case on 1 and on 2 ranks, and what the two have written."""

    def __init__(self, name, end):
        self.case = {"1": name, "2": name + "_2"}
        self.end = "%.12g" % end

    def log(self, ranks):
        with open(self.case[ranks] + "/log.demFoam") as stream:
            return stream.read()

    def overlap(self, ranks):
        """Largest of the run [%]."""
        return float(re.search(r"Largest overlap (\S+) %", self.log(ranks))
                     .group(1))

    def last(self, ranks, *fields):
        return readBodies(self.case[ranks], self.end, *fields)

    def states(self, ranks, *more):
        """Time, positions, velocities and other fields of each write after
        the start."""
        part = {"1": "", "2": "/processor0"}[ranks]
        times = [os.path.basename(path) for path in
                 glob.glob(self.case[ranks] + part + "/[0-9]*")]
        for time in sorted(times, key=float):
            found = readBodies(self.case[ranks], time, "position", "velocity",
                               *more)
            if found:
                yield (float(time), *(
                    np.array([found[k][field] for k in sorted(found)])
                    for field in ("position", "velocity", *more)))


def template():
    """The mesh of all rows, decomposed: two cells, in patches that bodies may
    pass."""
    if not os.path.exists("mesh"):
        case = makeCase("mesh", edge=(0.4, 0.4, 0.8), n=(2, 1, 1),
                        kind="patch", properties="demSolver hades;\n")
        setEntry(case + "/system/controlDict", "writeFormat", "binary")
        runIn(case, "blockMesh")
        runIn(case, "decomposePar")
    return "mesh"


def prepare(name, properties, step, end, gravity, writes, triangles):
    case = copyCase(template(), name)
    with open(case + "/constant/demCloudProperties", "a") as out:
        out.write(properties.replace("demSolver hades; ", "", 1))
    control = case + "/system/controlDict"
    for key, value in (("deltaT", step), ("endTime", end),
                       ("writeInterval", step*writes)):
        setEntry(control, key, "%.12g" % value)
    if not gravity:
        os.remove(case + "/constant/g")
    if triangles is not None:
        os.makedirs(case + "/constant/triSurface")
        with open(case + "/constant/triSurface/wall.obj", "w") as out:
            for n, corners in enumerate(triangles):
                for x in corners:
                    out.write("v %.17g %.17g %.17g\n" % tuple(middle + x))
                out.write("f %d %d %d\n" % tuple(3*n + i for i in (1, 2, 3)))
    return case


def onRanks(name, properties, step, end, gravity=False, writes=1,
            triangles=None):
    """Run a case on 1 and on 2 ranks. It is written each so many steps."""
    both = Both(name, end)
    prepare(name, properties, step, end, gravity, writes, triangles)
    copyCase(name, both.case["2"])
    for part in glob.glob(name + "/processor*"):
        subprocess.check_call(["rm", "-r", part])
    runIn(both.case["1"], "demFoam")
    runIn(both.case["2"], *command(2, "demFoam"), log="log.demFoam")
    return both


def figureRanks(name, both, size, bound=1e-9, meet=True):
    """Paths of 2 ranks against 1, over a size [m], and how many bodies a rank
    had copies of to meet its own, where they do."""
    a, b = (both.last(ranks, "position", "velocity") for ranks in "12")
    figure(name + "_ranks", distance(a, b, "position")/size, None, bound, "d",
           "%d bodies, 2 ranks against 1" % len(a))
    if meet:
        copies = re.search(r"own and (\d+) copies", both.log("2"))
        figure(name + "_copies", int(copies.group(1)) if copies else 0, 1,
               len(a) - 1, "bodies", "of the other rank at most")
