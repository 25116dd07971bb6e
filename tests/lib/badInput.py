# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     For tests of wrong input: copy a good case, spoil one thing in it, run it
#     and see that it stops with words that help.
#
#     from badInput import copyCase, edit, lineOf, expectFailure
#     case = copyCase("box", "negativeDensity")
#     edit(case, "constant/demCloudProperties", "2650", "-2650")
#     expectFailure("negativeDensity", case, ["demFoam"],
#                   ["density", "-2650", lineOf(case, "constant/...", "-2650")])
# -----------------------------------------------------------------------------

import os
import re
import shutil
import subprocess

from figure import figureTrue


def copyCase(source, target):
    """A fresh copy of a case folder; returns its path."""
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target, symlinks=True)
    return target


def edit(case, file, old, new, count=1):
    """Replaces text in a file of the case; the text must be there."""
    path = os.path.join(case, file)
    with open(path) as stream:
        text = stream.read()
    if old not in text:
        raise ValueError(f"{path} does not hold '{old}'")
    with open(path, "w") as stream:
        stream.write(text.replace(old, new, count))


def lineOf(case, file, text):
    """'at line N': how OpenFOAM names the first line that holds the text."""
    path = os.path.join(case, file)
    with open(path) as stream:
        for number, line in enumerate(stream, 1):
            if text in line:
                return f"at line {number}"
    raise ValueError(f"{path} does not hold '{text}'")


def expectFailure(name, caseDir, command, mustContain, seconds=60):
    """Runs the command in the case and prints a figure line. It passes if the
    command stops by itself with a non-zero exit status, neither by a signal
    nor by the clock, and says all of mustContain (white space is one blank).
    Where one of several wordings will do, give a tuple of them."""
    try:
        run = subprocess.run(command, cwd=caseDir, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, timeout=seconds,
                             stdin=subprocess.DEVNULL)
        status, output = run.returncode, run.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired as late:
        status, output = None, (late.stdout or b"").decode(errors="replace")

    said = re.sub(r"\s+", " ", output)
    missing = []
    for words in mustContain:
        choices = words if isinstance(words, tuple) else (words,)
        if not any(re.sub(r"\s+", " ", w) in said for w in choices):
            missing.append(" | ".join(choices))

    if status is None:
        found = f"still running after {seconds} s"
    elif status == 0:
        found = "no error"
    elif status < 0:
        found = f"died of signal {-status}"
    elif missing:
        found = "message lacks: " + "; ".join(missing)
    else:
        found = f"stops, says all {len(mustContain)} words"
    program = next(w for w in command if os.path.basename(w) not in (
        "env", "-u", "MALLOC_PERTURB_"))
    passed = status is not None and status > 0 and not missing
    if not passed:
        print(output[-3000:])
    return figureTrue(name, passed, found, "stops and says why",
                      f"issue 2: {program}")
