#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     What tests of restarts and of ranks share: cases that are copied and
#     decomposed, and the fields of the cloud in a time directory.
#         bodies = readBodies(case, "0.06", "position", "velocity")
#             a dictionary of ids, of each the fields as arrays
#         distance(a, b, "position")     the largest difference of two such
#         case = restartAt("through", "0.02", "restarted")
#         runParallel(case, 2, "demFoam")
#------------------------------------------------------------------------------
import glob
import gzip
import os
import re
import shutil
import subprocess
import sys

import numpy as np

from cases import setEntry


def readField(file):
    """An IOField of a cloud, ASCII, binary or packed: an array, a row a
    body."""
    packed = not os.path.exists(file)
    with gzip.open(file + ".gz") if packed else open(file, "rb") as stream:
        data = stream.read()
    header = data[:data.index(b"}")].decode()
    kind = re.search(r"class\s+(\w+);", header).group(1)
    columns = 3 if kind.startswith("vector") else 1
    number = np.int32 if kind.startswith("label") else np.float64
    binary = "binary" in re.search(r"format\s+(\w+);", header).group(1)
    text = data[data.index(b"}") + 1:]
    text = re.sub(rb"\A\s*//[^\n]*\n", b"", text)

    match = re.match(rb"\s*(\d+)\s*([({])?", text)
    n = int(match.group(1))
    if n == 0:
        return np.zeros((0, columns))
    if binary:
        size = n*columns*np.dtype(number).itemsize
        values = np.frombuffer(text[match.end():match.end() + size], number)
    else:
        words = re.sub(rb"//.*|[(){}]", b" ", text[match.end():]).split()
        values = np.array([float(word) for word in words])
        if match.group(2) == b"{":
            values = np.tile(values, n)
    return values.reshape(n, columns)


def readLists(case, time, field):
    """All numbers of a CompactIOField of labels, of all ranks of the case."""
    numbers = []
    for part in glob.glob("%s/processor[0-9]*" % case) or [case]:
        file = "%s/%s/lagrangian/demCloud/%s" % (part, time, field)
        if not os.path.exists(file):
            continue
        with open(file, "rb") as stream:
            text = stream.read()
        text = re.sub(rb"\A\s*//[^\n]*\n", b"", text[text.index(b"}") + 1:])

        # Two binary lists: where each body's numbers start, and the numbers
        for _ in range(2):
            match = re.match(rb"\s*(\d+)\s*(\()?", text)
            size = 4*int(match.group(1)) if match.group(2) else 0
            values = np.frombuffer(text[match.end():match.end() + size],
                                   np.int32)
            text = text[match.end() + size + (1 if match.group(2) else 0):]
        numbers += list(values)
    return numbers


def readBodies(case, time, *fields):
    """The fields of all bodies by id, from all ranks of the case."""
    parts = glob.glob("%s/processor[0-9]*" % case) or [case]
    bodies = {}
    for part in parts:
        folder = "%s/%s/lagrangian/demCloud/" % (part, time)
        if not glob.glob(folder + "id*"):
            continue
        ids = readField(folder + "id")[:, 0].astype(int)
        values = {field: readField(folder + field) for field in fields}
        for row, number in enumerate(ids):
            if number in bodies:
                sys.exit("body %d is twice in %s" % (number, case))
            bodies[number] = {
                field: values[field][row] for field in fields}
    return bodies


def distance(a, b, field):
    """Largest difference of a field; infinite if the bodies differ."""
    if sorted(a) != sorted(b) or not a:
        return float("inf")
    return max(float(np.linalg.norm(a[i][field] - b[i][field])) for i in a)


def copyCase(source, target):
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target, symlinks=True)
    return target


def restartAt(source, time, target):
    """A copy of a case that goes on from a time: all later ones are gone."""
    copyCase(source, target)
    for folder in glob.glob(target + "/[0-9]*"):
        if float(os.path.basename(folder)) > float(time) + 1e-9:
            shutil.rmtree(folder)
    setEntry(target + "/system/controlDict", "startTime", time)
    return target


def runIn(case, *command, log=None):
    """Run a program in a case; stop the test if it fails."""
    log = os.path.join(case, log or "log." + os.path.basename(command[0]))
    with open(log, "w") as out:
        status = subprocess.call(command, stdout=out, stderr=out, cwd=case,
                                 env=dict(os.environ, PWD=os.path.abspath(case)))
    if status:
        with open(log) as text:
            print("".join(text.readlines()[-40:]))
        sys.exit("%s failed: see %s" % (" ".join(command), log))
    return log


def runParallel(case, ranks, program, blocks=None):
    """Decompose a case, along x or in blocks such as "(2 2 1)", and run a
    program on its ranks."""
    file = case + "/system/decomposeParDict"
    setEntry(file, "numberOfSubdomains", str(ranks))
    setEntry(file, "simpleCoeffs/n", blocks or "(%d 1 1)" % ranks)
    runIn(case, "decomposePar", "-force")
    return runIn(case, *onRanks(ranks, program), log="log." + program)


def onRanks(ranks, program):
    """The command of a program on ranks. More of them than there are cores leave
    the core to others while they wait; else waiting is shorter than coming
    back, where other programs want the cores. mpirun itself is not poisoned:
    when ranks end with an error it uses memory that it has freed."""
    shared = ranks > (os.cpu_count() or 1)
    poison = "MALLOC_PERTURB_"
    return (["env", "-u", poison, "mpirun", "--oversubscribe"]
            + (["-x", poison + "=" + os.environ[poison]]
               if poison in os.environ else [])
            + (["--mca", "mpi_yield_when_idle", "1"] if shared else [])
            + ["-np", str(ranks), program, "-parallel"])


def meshChanges(log):
    """What a log tells of the cells that were refined and merged."""
    with open(log) as text:
        return [line for line in text if re.match(
            r"(Selected \d+ (cells for|split points)|(Un)?[Rr]efined from)",
            line)]
