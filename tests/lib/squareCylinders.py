#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs of the tutorial squareCylinder.
#         table = compare(8, ["30"], ["fitted", "surface"])
#             of each shape and Reynolds number the drag coefficient and the
#             length of the recirculation over D
#         for Re, found in shedding(12, 0.02, ["200"], ["fitted", "surface"], 6)
#             where vortices are shed, second order in time, on cells that are
#             0.02 of the edge at the square's sides: of each shape the mean drag
#             coefficient and the Strouhal number of the last four whole periods
#             of 6 s, an even number as they may alternate; one Reynolds number
#             after the other, as they are done. The runs go on from a flow that
#             sheds, of the surface on even cells
#------------------------------------------------------------------------------
import glob
import os
import re
import subprocess

from badInput import edit
from cases import setEntry
from cloudCase import copyCase, runIn

tutorial = "/tutorials/resolved/squareCylinder"


def compare(cells, numbers, shapes, folder="square"):
    case = copyCase(os.environ["STYX_DIR"] + tutorial, folder)
    for Re in numbers:
        for shape in shapes:
            run = makeCase(folder, shape, Re, cells)
            runIn(run, "blockMesh")
            runIn(run, "pimpleFoam")
    out = subprocess.check_output(["./results"], cwd=case).decode()
    print(out)

    rows = out.splitlines()
    names = rows[0].split()[1:1 + len(shapes)]
    table = {}
    for row in rows[1:]:
        pairs = re.findall(r"(\S+) \( *([-0-9.]+)\)", row)
        for name, (drag, wake) in zip(names, pairs):
            table[name, float(row.split()[0])] = (float(drag), float(wake))
    return table


def makeCase(folder, shape, Re, *mesh):
    run = "runs/%s_%s" % (shape, Re)
    subprocess.check_call(["./makeCase", shape, Re, str(mesh[0]), run,
                           *map(str, mesh[1:])], cwd=folder)
    return folder + "/" + run


def makeShedding(run, endTime):
    """Second order in time, with the flux of the step itself."""
    for key in ("endTime", "writeInterval"):
        setEntry(run + "/system/controlDict", key, "%g" % endTime)
    setEntry(run + "/system/fvSchemes", "ddtSchemes/default", "backward")
    setEntry(run + "/system/fvSolution", "PIMPLE/nOuterCorrectors", "2")


def shedding(cells, smallest, numbers, shapes, endTime):
    for folder in ("start", "square"):
        copyCase(os.environ["STYX_DIR"] + tutorial, folder)
    start = makeCase("start", "surface", "200", cells)
    makeShedding(start, 9)
    edit(start, "0/U", "uniform (0.0667 0 0)", "uniform (0.0667 0.03 0)")
    runIn(start, "blockMesh")
    runIn(start, "pimpleFoam")

    for Re in numbers:
        found = {}
        for shape in shapes:
            run = makeCase("square", shape, Re, cells, smallest)
            makeShedding(run, endTime)
            runIn(run, "blockMesh")
            mapFrom(start, run, shape)
            runIn(run, "pimpleFoam")
            found[shape] = periods(run)
            print("%-10s Re %s: mean drag %.4f, St %.4f" % (
                shape, Re, *found[shape]))
        yield Re, found


def mapFrom(start, run, shape):
    """The last fields of another mesh as those to start from."""
    with open(run + "/system/controlDict") as text:
        head = text.read().split("application")[0]
    with open(run + "/system/mapFieldsDict", "w") as out:
        out.write(head.replace("controlDict", "mapFieldsDict") + "patchMap (%s"
                  ");\ncuttingPatches (%s);\n" % (
                      " ".join("%s %s" % (name, name) for name in (
                          "inlet", "outlet", "walls", "frontAndBack")),
                      "square" if shape == "fitted" else ""))
    runIn(run, "mapFields", os.path.abspath(start), "-sourceTime",
          "latestTime")
    for left in ("lagrangian", "uniform", "U_0"):
        subprocess.check_call(["rm", "-rf", run + "/0/" + left])


def forces(run):
    """Times, drag and lift [N] of each step."""
    number = r"[-+0-9.e]+"
    for file in glob.glob(run + "/postProcessing/force/0/force.dat"):
        with open(file) as rows:
            return [tuple(float(row.replace("(", " ").split()[k])
                          for k in range(3))
                    for row in rows if not row.startswith("#")]
    with open(run + "/system/controlDict") as text:
        step = float(re.search(r"deltaT\s+(%s)" % number,
                               text.read()).group(1))
    with open(run + "/log.pimpleFoam") as text:
        return [(step*(k + 1), float(x)/step, float(y)/step)
                for k, (x, y) in enumerate(re.findall(
                    r"^demCloud: .*to bodies \((%s) (%s) " % (number, number),
                    text.read(), re.M))]


def periods(run, last=4):
    """Mean drag coefficient and Strouhal number of the last whole periods."""
    rows = forces(run)
    late = [row[2] for row in rows[len(rows)//2:]]
    mean = sum(late)/len(late)
    ups = [k for k in range(1, len(rows))
           if rows[k - 1][2] < mean <= rows[k][2]][-last - 1:]
    if len(ups) < last + 1:
        return float("nan"), float("nan")
    drags = [row[1] for row in rows[ups[0]:ups[-1]]]
    return (sum(drags)/len(drags)/(0.5*0.1**2*0.01*0.005),
            last*0.01/0.1/(rows[ups[-1]][0] - rows[ups[0]][0]))
