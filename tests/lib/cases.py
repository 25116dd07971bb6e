#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs OpenFOAM programs in the present folder and reads the ledger lines
#     of their logs.
#         run("blockMesh")                  log.blockMesh; leaves on an error
#         setEntry("constant/x", "a/b", "3")
#         lines = ledger("log.pimpleFoam")  one record a fluid step
#------------------------------------------------------------------------------
import re
import subprocess
import sys

number = r"[-+0-9.e]+"


def run(*command, log=None):
    """Run a program; stop the test if it fails."""
    log = log or "log." + command[0]
    with open(log, "w") as out:
        status = subprocess.call(command, stdout=out, stderr=out)
    if status:
        with open(log) as text:
            print("".join(text.readlines()[-40:]))
        sys.exit("%s failed: see %s" % (" ".join(command), log))
    return log


def setEntry(file, key, value):
    """Set an entry of a dictionary, or remove it if the value is None;
    sub-dictionaries by a slash."""
    what = ["-remove"] if value is None else ["-set", value]
    subprocess.check_call(
        ["foamDictionary", "-entry", key.replace("/", ".")] + what + [file],
        stdout=subprocess.DEVNULL)


def vector(text):
    return [float(x) for x in text.split()]


def ledger(log):
    """The ledger lines of a log: a list of dictionaries."""
    records = []
    with open(log) as lines:
        for line in lines:
            if not re.match(r"demCloud: \d+ bodies, ", line):
                continue
            record = {
                "bodies": int(re.search(r"(\d+) bodies", line).group(1)),
                "contacts": int(re.search(r"(\d+) contacts", line).group(1)),
                "fastest": float(
                    re.search(r"fastest (%s)" % number, line).group(1))}
            match = re.search(r"to bodies \(([^)]*)\)", line)
            if match:
                record["toBodies"] = vector(match.group(1))
                record["mismatch"] = float(
                    re.search(r"mismatch (%s)" % number, line).group(1))
                record["volumeError"] = float(
                    re.search(r"volume error (%s)" % number, line).group(1))
            records.append(record)
    return records


def shares(log):
    """Shares of wall time in the summary of a log [%], by name."""
    with open(log) as text:
        summary = text.read().split("demCloud: summary")[-1]
    return {name.strip(): float(percent) for name, percent in re.findall(
        r"^ {8}(.*?): %s s, (%s) %%" % (number, number), summary, re.M)}
