# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Chooses the tests, runs each in a scratch copy, prints their figures in
#     order and counts them. Started by ./Alltest; see tests/README.md.
# -----------------------------------------------------------------------------
"""Usage: alltest.py [-list] [-tests FOLDER] [quick | full | NAME ...]"""

import fcntl
import os
import re
import shutil
import signal
import subprocess
import sys
import threading

STYX = os.environ["STYX_DIR"]
GROUPS = ("unit analytic validation parallel restart input hard scenes "
          "tutorials").split()
FIGURE = re.compile(r"^(PASS|FAIL) (\S+): .+ \(.+\)$")
UNIT = os.environ.get("STYX_UNIT_TESTS",
                      os.path.join(STYX, "build", "styxUnitTests"))
CORES = min(2, os.cpu_count() or 1)

# Freed memory is filled with 0xfe, new memory with 0x01 (by glibc), and what is
# at least a double in OpenFOAM's programs with NaN: absurd as a number, as an
# index and as an address
POISON = {"MALLOC_PERTURB_": "254", "FOAM_SETNAN": "true"}


class Test:
    """One folder with a `run`, or one command that prints figures."""

    def __init__(self, group, name, source=None, command=None):
        self.group, self.name, self.source = group, name, source
        self.command = command or ["./run"]
        self.speed, self.limit, self.cores = "quick", None, 1
        if source and os.path.exists(os.path.join(source, "speed")):
            with open(os.path.join(source, "speed")) as file:
                words = file.read().split()
            if not words or words[0] not in ("quick", "full"):
                sys.exit(f"{source}/speed: first word is none of quick full")
            self.speed = words[0]
            self.limit = float(words[1]) if len(words) > 1 else None
            self.cores = int(words[2]) if len(words) > 2 else 1
        self.limit = self.limit or (300 if self.speed == "quick" else 3600)
        self.cores = min(self.cores, CORES)
        self.lines, self.done = [], threading.Event()

    def path(self):
        return f"{self.group}/{self.name}" if self.group else self.name

    def run(self, build):
        """Runs in a fresh copy; leaves the figure lines in self.lines."""
        scratch = os.path.join(build, self.path())
        os.makedirs(os.path.dirname(scratch), exist_ok=True)
        with open(scratch + ".lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            shutil.rmtree(scratch, ignore_errors=True)
            if self.source:
                shutil.copytree(self.source, scratch, symlinks=True)
            else:
                os.makedirs(scratch)
            log = scratch + ".log"
            trouble = self.execute(scratch, log)
            with open(log, errors="replace") as file:
                text = file.read().splitlines()
        self.lines = [line for line in text if FIGURE.match(line)]
        if not trouble and not self.lines:
            trouble = "printed no figure"
        failed = any(line.startswith("FAIL") for line in self.lines)
        if failed or trouble:
            self.lines = ["    | " + line for line in text[-15:]
                          if not FIGURE.match(line)] + self.lines
        if trouble and not (failed and trouble == "exit status 1"):
            self.lines.append(f"FAIL {self.name}: {trouble} "
                              f"(none, {os.path.relpath(log, STYX)})")

    def execute(self, scratch, log):
        """Returns what went wrong, or nothing."""
        lib = os.path.join(STYX, "tests", "lib")
        environment = dict(POISON, **os.environ)
        environment.update(PYTHONPATH=lib, PYTHONUNBUFFERED="1",
                           PYTHONDONTWRITEBYTECODE="1")
        with open(log, "w") as out:
            limit = self.limit*float(os.environ.get("STYX_TEST_LIMITS", 1))
            process = subprocess.Popen(
                self.command, cwd=scratch, env=environment, stdout=out,
                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                start_new_session=True)
            try:
                status = process.wait(timeout=limit)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                return f"{limit:g} s and not done"
        if status < 0:
            return f"killed by {signal.Signals(-status).name}"
        return f"exit status {status}" if status else None


def unitTest(only=None, full=False):
    """The GoogleTest program; tests whose names end in Full are slow."""
    chosen = only or ("*" if full else "*-*Full:*Full/*")
    name = re.sub(r"\W+", "_", only or "all").strip("_")[:60]
    test = Test("unit", name, command=[UNIT, "--gtest_filter=" + chosen])
    test.limit = 3600 if full else 600
    return test


def discover(folder):
    tests = []
    for group in GROUPS:
        parent = os.path.join(folder, group)
        names = sorted(os.listdir(parent)) if os.path.isdir(parent) else []
        for name in names:
            source = os.path.join(parent, name)
            if os.access(os.path.join(source, "run"), os.X_OK):
                tests.append(Test(group, name, source))
    return tests


def mentions(folder, word):
    """Does a text file in a test's folder hold this word?"""
    pattern = re.compile(r"(?<!\w)" + re.escape(word) + r"(?!\w)")
    for root, _, files in os.walk(folder):
        for name in files:
            try:
                with open(os.path.join(root, name)) as file:
                    if pattern.search(file.read()):
                        return True
            except (UnicodeDecodeError, OSError):
                pass
    return False


def unitFilter(folder, word):
    """GoogleTest's filter for a suite, a test or a figure; or nothing."""
    chosen = []
    for root, _, files in os.walk(os.path.join(folder, "unit")):
        for name in sorted(f for f in files if f.endswith(".C")):
            with open(os.path.join(root, name)) as file:
                parts = re.split(r"(?m)^TEST(?:_\w+)?\((\w+),\s*(\w+)\)",
                                 file.read())
            for suite, test, body in zip(*(iter(parts[1:]),) * 3):
                if word in (suite, f"{suite}.{test}") or f'"{word}"' in body:
                    chosen += [f"*{suite}.{test}", f"*{suite}.{test}/*"]
    return ":".join(chosen)


def choose(folder, names):
    """The tests in the order of their groups."""
    found = discover(folder)
    style = Test("", "style", command=["/bin/bash", "-c", STYLE])
    own = folder == os.path.join(STYX, "tests")
    if names in (["quick"], ["full"]):
        full = names == ["full"]
        tests = [t for t in found if full or t.speed == "quick"]
        return ([style, unitTest(full=full)] if own else []) + tests
    tests = []
    for name in names:
        if name == "style":
            matched = [style]
        elif name in GROUPS:
            matched = [t for t in found if t.group == name]
            matched += [unitTest(full=True)] if name == "unit" else []
        else:
            matched = [t for t in found if name in (t.name, t.path())]
            only = unitFilter(folder, name) if not matched else ""
            matched += [unitTest(only)] if only else []
            if not matched:
                matched = [t for t in found if mentions(t.source, name)]
        if not matched:
            sys.exit(f"Alltest: '{name}' is no group, test or figure; "
                     "see ./Alltest -list")
        tests += [t for t in matched if t.path() not in
                  [other.path() for other in tests]]
    return tests


STYLE = r"""
n=$("$STYX_DIR/bin/checkStyle" | tee breaks | wc -l); cat breaks
. "$STYX_DIR/tests/lib/figure"
figure style "$n" 0 0 breaks "bin/checkStyle"
"""


def main(arguments):
    folder = os.path.join(STYX, "tests")
    if "-tests" in arguments:
        at = arguments.index("-tests")
        folder = os.path.abspath(arguments[at + 1])
        del arguments[at:at + 2]
    if "-list" in arguments:
        for test in discover(folder):
            print(f"{test.path():40} {test.speed:6} {test.limit:g} s limit, "
                  f"{test.cores} cores")
        return 0
    build = os.path.join(STYX, "build", "tests")
    if folder != os.path.join(STYX, "tests"):
        build = os.path.join(folder, "build")

    tests = choose(folder, arguments or ["quick"])
    free = threading.Semaphore(CORES)
    turn = threading.Lock()

    def work(test):
        try:
            test.run(build)
        except Exception as error:
            test.lines = [f"FAIL {test.name}: {error} (none, alltest.py)"]
        finally:
            test.done.set()
            free.release(test.cores)

    def dispatch():
        for test in tests:
            with turn:
                for _ in range(test.cores):
                    free.acquire()
            threading.Thread(target=work, args=(test,), daemon=True).start()

    threading.Thread(target=dispatch, daemon=True).start()
    count = {"PASS": 0, "FAIL": 0}
    for test in tests:
        test.done.wait()
        for line in test.lines:
            print(line, flush=True)
            if FIGURE.match(line):
                count[line[:4]] += 1
    print(f"{count['PASS']} passed, {count['FAIL']} failed")
    return 0 if count["FAIL"] == 0 and count["PASS"] > 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
