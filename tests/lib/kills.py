#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs that are killed (signal 9, all ranks) and go on after demRestart,
#     again and again, against one that runs through. Every second kill comes at
#     a random moment, the others as soon as a new time directory is seen, so
#     that they hit the writing.
#         killed("name", "case", "pimpleFoam", ranks=2, kills=7, seed=1)
#     At each restart the state must be, to the last bit, that of the run
#     through at that time, and so must be the end.
#------------------------------------------------------------------------------
import glob
import os
import random
import re
import signal
import subprocess
import time

from cases import setEntry
from cloudCase import copyCase, distance, onRanks, readBodies, runIn
from figure import figure

fields = ("position", "velocity", "rotation", "angularMomentum")


def descendants(pid):
    """A process and all that it has started."""
    found = [pid]
    for task in glob.glob("/proc/%d/task/*/children" % pid):
        try:
            with open(task) as children:
                for child in children.read().split():
                    found += descendants(int(child))
        except OSError:
            pass
    return found


def timesOf(case):
    return {os.path.basename(d) for d in glob.glob(case + "/[0-9]*")
            + glob.glob(case + "/processor0/[0-9]*")}


def runAndKill(case, command, wait):
    """Kill a run after some seconds, or, without them, at its next time.
    False if it ended by itself before."""
    before = timesOf(case)
    with open(case + "/log.killed", "w") as log:
        run = subprocess.Popen(
            command, stdout=log, stderr=log, cwd=case,
            env=dict(os.environ, PWD=os.path.abspath(case)))
    begin = time.time()
    while run.poll() is None:
        if wait is None:
            if timesOf(case) - before:
                break
            time.sleep(0.0002)
        else:
            if time.time() - begin > wait:
                break
            time.sleep(0.002)

    if run.poll() is not None:
        if run.returncode:
            with open(case + "/log.killed") as log:
                print("".join(log.readlines()[-30:]))
            raise SystemExit("%s stops by itself" % case)
        return False
    for pid in descendants(run.pid):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    run.wait()
    return True


def killed(name, source, program, ranks, kills, seed):
    """The figures of one case."""
    moments = random.Random(seed)
    setEntry(source + "/system/controlDict", "startFrom", "latestTime")
    setEntry(source + "/system/controlDict", "writeInterval", "1")
    command = [program]
    if ranks > 1:
        setEntry(source + "/system/decomposeParDict", "numberOfSubdomains",
                 str(ranks))
        setEntry(source + "/system/decomposeParDict", "simpleCoeffs/n",
                 "(%d 1 1)" % ranks)
        runIn(source, "decomposePar", "-force")
        command = onRanks(ranks, program)

    through = copyCase(source, source + "-through")
    begin = time.time()
    runIn(through, *command)
    span = time.time() - begin
    end = max(timesOf(through), key=float)

    case = copyCase(source, source + "-killed")
    worst, aside, done = 0, 0, 0
    while done < kills:
        wait = None if done % 2 else moments.uniform(0, 0.3*span)
        if not runAndKill(case, command, wait):
            copyCase(source, case)
            continue
        done += 1
        with open(runIn(case, "demRestart")) as log:
            text = log.read()
        aside += len(re.findall(r"is not whole: put aside", text))
        found = re.findall(r"goe?s? on from time (\S+)", text)
        last = found[-1] if found else "0"
        if float(last) > 0:
            a = readBodies(through, last, *fields)
            b = readBodies(case, last, *fields)
            worst = max([worst] + [distance(a, b, f) for f in fields])

    runIn(case, *command)
    a = readBodies(through, end, *fields)
    b = readBodies(case, end, *fields)
    figure(name + "_kills", done, kills, kills, "kills",
           "every one goes on from the last whole time")
    figure(name + "_aside", aside, 1, None, "times",
           "begun and put aside by demRestart")
    figure(name + "_restarts", worst, None, 0, "SI",
           "state at each restart against the run through")
    figure(name + "_end", max(distance(a, b, f) for f in fields), None, 0,
           "SI", "position, velocity, rotation, angular momentum at the end")
