#!/usr/bin/python3
#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Usage
#     fuzz.py TARGET N [SEED [FIRST]]
#
# Description
#     Runs N spoilt inputs through TARGET (see fuzzTarget.C) and prints the
#     figures. Input n of a seed is always the same, so that
#         fuzz.py TARGET 1 SEED n
#     repeats it. Failures stay in the folder failures: the input and what was
#     said.
#
#     A failure is
#     - a crash: a signal, a report of a sanitizer, or an exit that is none of
#       the target's own;
#     - a hang: ten seconds of computing;
#     - a run that goes on with a broken value: with a state that is none, with
#       a dictionary that mutate.reasonToReject finds wrong, or, from a spoilt
#       file of a restart, with another state than from the whole one.
#------------------------------------------------------------------------------
import os
import random
import re
import subprocess
import sys
from collections import Counter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.environ["STYX_DIR"] + "/tests/lib")
import mutate
from corpus import makeCorpus
from figure import figure

SEED = 20240607


class Target:
    """A process that forks one for each input."""

    def __init__(self, program, case, *options):
        self.case = case
        # OpenFOAM's LList deletes its links as their base class: no error of
        # size on the heap, and not ours
        env = dict(os.environ, PWD=os.path.abspath(case), FOAM_SIGFPE="true",
                   ASAN_OPTIONS="detect_leaks=0:exitcode=99:"
                   "new_delete_type_mismatch=0",
                   UBSAN_OPTIONS="print_stacktrace=1")
        self.process = subprocess.Popen(
            [program, *options], cwd=case, env=env, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL)
        for line in self.process.stdout:
            if line.strip() == "ready":
                return
        sys.exit("%s does not start in %s" % (program, case))

    def ask(self, line="case"):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().split()
        if not answer:
            sys.exit("the target has died in " + self.case)
        with open(self.case + "/log", errors="replace") as log:
            return answer[0], float(answer[-1]), log.read()


def hashOf(log):
    match = re.search(r"^hash (\S+)", log, re.M)
    return match.group(1) if match else None


def judge(item, data, answer, log, mustReject):
    """What is wrong with an answer, or None."""
    if "Sanitizer" in log or "runtime error:" in log:
        return "crash"
    if answer in ("crash", "hang", "broken"):
        return answer
    if answer != "accepted":
        return None
    if mustReject:
        return "accepted: " + mustReject
    if item.kind == "restart" and hashOf(log) != item.goodHash:
        return "accepted: another state"
    return None


def main(program, n, seed=SEED, first=0):
    n, seed, first = int(n), int(seed), int(first)
    program = os.path.abspath(program)
    os.makedirs("failures", exist_ok=True)
    corpus = makeCorpus("corpus")
    targets, counts, kinds, slowest = {}, Counter(), Counter(), 0
    shown = 0

    for item in corpus:
        if item.target not in targets:
            targets[item.target] = Target(program, item.case, *item.options)
        answer, _, log = targets[item.target].ask(item.question)
        if answer != "accepted":
            sys.exit("the good input %s: %s\n%s" % (item.name, answer, log))
        item.goodHash = hashOf(log)

    total = sum(item.share for item in corpus)
    for i in range(first, first + n):
        chance = random.Random("%d/%d" % (seed, i))
        pick = chance.random()*total
        for item in corpus:
            pick -= item.share
            if pick < 0:
                break
        mustReject = None
        if item.kind == "dictionary":
            data, mustReject = mutate.dictionary(item.text(), chance)
        elif item.kind == "surface":
            data = mutate.surface(item.data, chance)
        else:
            data = mutate.savedFile(item.data, chance)

        item.write(data)
        answer, seconds, log = targets[item.target].ask(item.question)
        item.write(item.data)

        wrong = judge(item, data, answer, log, mustReject)
        if data == item.data and answer == "accepted":
            wrong = None
        counts[answer] += 1
        kinds[item.kind] += 1
        slowest = max(slowest, seconds)
        if wrong:
            counts["failure " + wrong.split(":")[0]] += 1
            name = "failures/%d-%s" % (i, item.name.replace("/", "_"))
            with open(name, "wb") as out:
                out.write(data)
            with open(name + ".log", "w") as out:
                out.write(wrong + "\n" + log)
            if shown < 200:
                shown += 1
                print("input %d, %s: %s" % (i, item.name, wrong), flush=True)

    print("%d inputs: %s; %s; slowest %.2f s" % (
        n, ", ".join("%d %s" % (k, name) for name, k in counts.items()),
        ", ".join("%d %s" % (k, name) for name, k in kinds.items()), slowest))
    prefix = os.environ.get("FUZZ_NAME", "fuzz")
    source = "seed %d" % seed
    figure(prefix + "Inputs", n, n, n, "inputs", source)
    figure(prefix + "Crashes", counts["failure crash"], 0, 0, "crashes", source)
    figure(prefix + "Hangs", counts["failure hang"], 0, 0, "hangs", source)
    figure(prefix + "Broken", counts["failure broken"]
           + counts["failure accepted"], 0, 0,
           "runs with a broken value", source)
    figure(prefix + "Accepted", counts["accepted"]/n, 0.01, 0.6, "of all",
           "neither all harmless nor all refused")
    for target in targets.values():
        target.process.stdin.close()
        target.process.wait()


if __name__ == "__main__":
    main(*sys.argv[1:])
