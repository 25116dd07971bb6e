#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The good inputs that the fuzzer spoils: dictionaries, a template of
#     spheres, surfaces in three formats, the files of a restart in two.
#------------------------------------------------------------------------------
import math
import os
import shutil
import struct
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)


class Item:
    """A file of a case that is spoilt, and how the target is asked."""

    def __init__(self, kind, target, case, file, share, options=()):
        self.kind, self.target, self.case = kind, target, case
        self.file, self.share, self.options = file, share, options
        self.name = target + "/" + file
        self.question = os.path.abspath(case + "/" + file) \
            if kind == "surface" else "case"
        with open(case + "/" + file, "rb") as stream:
            self.data = stream.read()

    def text(self):
        return self.data.decode("latin-1")

    def write(self, data):
        with open(self.case + "/" + self.file, "wb") as stream:
            stream.write(data)


def run(case, *command):
    with open(case + "/log." + command[0], "w") as log:
        subprocess.check_call(command, cwd=case, stdout=log, stderr=log,
                              env=dict(os.environ, PWD=os.path.abspath(case)))


def copy(source, target):
    shutil.copytree(source, target)
    run(target, "blockMesh")
    return target


def setEntry(file, key, value):
    subprocess.check_call(["foamDictionary", "-entry", key, "-set", value,
                           file], stdout=subprocess.DEVNULL)


def tetrahedra(n):
    """A closed surface: an octahedron with each face cut in n*n."""
    corners = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1.3),
               (0, 0, -0.9)]
    faces = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4),
             (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)]
    triangles = []
    for face in faces:
        a, b, c = (corners[k] for k in face)

        def at(i, j):
            return tuple(a[d] + (b[d] - a[d])*i/n + (c[d] - a[d])*j/n
                         for d in range(3))
        for i in range(n):
            for j in range(n - i):
                triangles.append((at(i, j), at(i + 1, j), at(i, j + 1)))
                if i + j < n - 1:
                    triangles.append(
                        (at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
    return [tuple(tuple(round(x, 6) for x in p) for p in t)
            for t in triangles]


def writeSurfaces(folder):
    triangles = tetrahedra(2)
    with open(folder + "/ascii.stl", "w") as out:
        out.write("solid body\n")
        for t in triangles:
            out.write("facet normal 0 0 0\n outer loop\n")
            for p in t:
                out.write("  vertex %g %g %g\n" % p)
            out.write(" endloop\nendfacet\n")
        out.write("endsolid body\n")
    with open(folder + "/binary.stl", "wb") as out:
        out.write(b"a binary surface".ljust(80)
                  + struct.pack("<I", len(triangles)))
        for t in triangles:
            out.write(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0))
    points = sorted(set(p for t in triangles for p in t))
    with open(folder + "/body.obj", "w") as out:
        out.write("g body\n")
        for p in points:
            out.write("v %g %g %g\n" % p)
        for t in triangles:
            out.write("f %d %d %d\n" % tuple(points.index(p) + 1 for p in t))


def makeCorpus(folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    properties = "constant/demCloudProperties"
    items = []

    # The sphere in water, without and with the fluid
    box = copy(TESTS + "/input/caseInput/box", folder + "/fluid")
    items.append(Item("dictionary", "fluid", box, properties, 15,
                      ("-fluid", "-steps", "1")))

    # All kinds of entries of the bodies alone
    dem = copy(HERE + "/dem", folder + "/dem")
    items.append(Item("dictionary", "dem", dem, properties, 30,
                      ("-steps", "2")))
    items.append(Item("dictionary", "dem", dem, "constant/rock.spheres", 10,
                      ("-steps", "2")))

    # Surfaces
    surfaces = copy(HERE + "/dem", folder + "/surfaces")
    writeSurfaces(surfaces)
    for file in ("ascii.stl", "binary.stl", "body.obj"):
        items.append(Item("surface", "surfaces", surfaces, file, 6,
                          ("-surfaces",)))

    # The files of a restart
    for form in ("ascii", "binary"):
        case = copy(HERE + "/dem", folder + "/restart-" + form)
        control = case + "/system/controlDict"
        setEntry(control, "writeFormat", form)
        setEntry(control, "endTime", "0.02")
        run(case, "demFoam")
        setEntry(control, "startTime", "0.02")
        saved = ["0.02/uniform/demCloudProperties"] + [
            "0.02/lagrangian/demCloud/" + name for name in sorted(
                os.listdir(case + "/0.02/lagrangian/demCloud"))]
        for file in saved:
            items.append(Item("restart", "restart-" + form, case, file,
                              27/2/len(saved), ("-steps", "1")))
    return items
