#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     A settled bed of spheres on five planes in demFoam, from the same state
#     as LIGGGHTS, by turns on the same core:
#         run("bed10k", 10000, 0.042, instructions="auto")
#     Hertz-Mindlin with history, friction 0.5, restitution 0.5, E 5 MPa,
#     spheres of 2 mm, steps of 1e-5 s (8 % of Rayleigh's). Both warm up
#     first; times are of the steps alone. LIGGGHTS may be missing: there is
#     no ratio then, and the bar is missed.
#------------------------------------------------------------------------------
import gzip
import os
import re
import shutil
import statistics
import subprocess
import sys

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
deltaT = 1e-5
warmUp, steps = 1000, 4000

head = "FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n"

properties = """
coupling    none;
demSolver   hades;
materials   { s { density 2500; youngsModulus 5e6; poissonsRatio 0.25; } }
pairs       { s-s { restitution 0.5; friction 0.5; } }
shapes      { ball { type sphere; diameter 0.002; } }
contact     { instructions %s; }
walls
{
    x1 { type plane; material s; point (0 0 0); normal (1 0 0); }
    x2 { type plane; material s; point (%g 0 0); normal (-1 0 0); }
    y1 { type plane; material s; point (0 0 0); normal (0 1 0); }
    y2 { type plane; material s; point (0 %g 0); normal (0 -1 0); }
    z1 { type plane; material s; point (0 0 0); normal (0 0 1); }
}
stepControl { type fixed; deltaT %g; }
neighbours  { type verletList; skin 0.3; }
"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as stream:
        stream.write(text)


def controlDict(case, start, end, format):
    write(case + "/system/controlDict", head % "controlDict" + """
application demFoam; libs (styx);
startFrom latestTime; startTime %g; stopAt endTime; endTime %.10g;
deltaT %g; writeControl runTime; writeInterval %.10g;
writeFormat %s; writePrecision 17; timeFormat general; timePrecision 8;
""" % (start, end, end - start if start == 0 else 1000*deltaT, end - start,
       format))


def foam(case, core=None):
    """demFoam on one core; its output."""
    command = ["demFoam", "-case", case]
    if core is not None:
        command = ["taskset", "-c", str(core)] + command
    done = subprocess.run(command, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise SystemExit(done.stdout[-3000:])
    return done.stdout


def setVectors(path, values):
    with open(path) as stream:
        text = stream.read()
    end = text.index("\n", text.index("// * * *"))
    write(path, text[:end] + "\n%d\n(\n" % len(values) + "\n".join(
        "(%.17g %.17g %.17g)" % tuple(v) for v in values) + "\n)\n")


def prepare(case, state, width, instructions):
    """A case whose first time is the settled bed: bodies on a lattice make
    the files, into which the state goes."""
    shutil.rmtree(case, ignore_errors=True)
    corners = [(x*width, y*width, z*0.2) for z in (0, 1)
               for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    write(case + "/system/blockMeshDict", head % "blockMeshDict" + """
vertices (%s);
blocks (hex (0 1 2 3 4 5 6 7) (2 2 4) simpleGrading (1 1 1));
boundary (sides { type patch; faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (1 2 6 5)
    (2 3 7 6) (3 0 4 7)); });
""" % " ".join("(%g %g %g)" % c for c in corners))
    for name in ("fvSchemes", "fvSolution"):
        write(case + "/system/" + name, head % name + {"fvSchemes": "".join(
            "%sSchemes {}\n" % s for s in ("ddt", "grad", "div", "laplacian",
                                           "interpolation", "snGrad")),
            "fvSolution": ""}[name])
    write(case + "/constant/g", """FoamFile { version 2.0; format ascii;
class uniformDimensionedVectorField; object g; }
dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);
""")
    n = len(state)
    row = int(round(width/0.0021))
    bodies = "\n".join(
        "b%d { shape ball; material s; position (%.9g %.9g %.9g); }"
        % (k, 0.0021*(k % row + 0.5), 0.0021*(k//row % row + 0.5),
           0.0021*(k//row**2 + 0.5)) for k in range(n))
    common = head % "demCloudProperties" + properties % (
        instructions, width, width, deltaT)
    write(case + "/constant/demCloudProperties",
          common + "bodies {\n" + bodies + "\n}\n")
    controlDict(case, 0, deltaT, "ascii")
    subprocess.run(["blockMesh", "-case", case], check=True,
                   stdout=subprocess.DEVNULL)
    foam(case)

    first = "%s/%g" % (case, deltaT)
    cloud = first + "/lagrangian/demCloud/"
    inertia = 0.4*2500*np.pi*0.002**3/6*0.001**2
    for field, values in (("position", state[:, :3]),
                          ("velocity", state[:, 3:6]),
                          ("angularVelocity", state[:, 6:9]),
                          ("angularMomentum", inertia*state[:, 6:9])):
        setVectors(cloud + field, values)
    counters = first + "/uniform/demCloudProperties"
    with open(counters) as stream:
        text = stream.read()
    text = re.sub(r"checksums\s*\{.*?\}", "checksums {}", text, flags=re.S)
    write(counters, re.sub(r"\nchecksum .*", "", text))
    return first


def styx(case, first, core):
    """Seconds of the steps after the warm-up, kinetic energy, contacts."""
    for name in os.listdir(case):
        if re.match(r"[0-9]", name) and name not in (
                "0", os.path.basename(first)):
            shutil.rmtree(case + "/" + name)
    start = float(os.path.basename(first))

    # The second run goes on from the first, and has a clock of its own
    for n in (warmUp, steps):
        controlDict(case, start, start + n*deltaT, "ascii")
        log = foam(case, core)
        last = max((d for d in os.listdir(case) if re.match(r"[0-9]", d)),
                   key=float)
        start = float(last)
    seconds = float(re.search(
        r"bodies \(contacts, motion\): ([0-9.e-]+) s", log).group(1))

    cloud = case + "/" + last + "/lagrangian/demCloud/"
    with open(cloud + "velocity") as stream:
        v = np.array(re.findall(r"\(([0-9.e+-]+) ([0-9.e+-]+) ([0-9.e+-]+)\)",
                                stream.read()), dtype=float)
    with open(cloud + "contactSlip", "rb") as stream:
        data = stream.read()
    # Where each body's list begins, then the slips themselves, binary
    head = rb"\n(\d+)\n\("
    begins = re.search(head, data)
    contacts = int(re.compile(head).search(
        data, begins.end() + 4*int(begins.group(1))).group(1))
    energy = 0.5*2500*np.pi*0.002**3/6*(v**2).sum()
    return seconds, energy, contacts


def measured(command, path):
    """The command, started by a small process that writes the kB of its peak
    into a file: a child of this one would begin with the peak of this one."""
    code = ("import os, sys; "
            "p = os.spawnvp(os.P_NOWAIT, sys.argv[2], sys.argv[2:]); "
            "_, s, u = os.wait4(p, 0); "
            "open(sys.argv[1], 'w').write(str(u.ru_maxrss)); "
            "sys.exit(os.waitstatus_to_exitcode(s))")
    return [sys.executable, "-S", "-c", code, path] + command


def runLiggghts(folder, state, width, core, warmUp, steps):
    """The same by LIGGGHTS: its output and the kB of its process."""
    lines = ["granular spheres\n\n%d atoms\n1 atom types\n" % len(state),
             "-0.0005 %g xlo xhi\n-0.0005 %g ylo yhi\n-0.0005 %g zlo zhi\n"
             % (width + 0.0005, width + 0.0005, state[:, 2].max() + 0.02),
             "Atoms\n"]
    lines += ["%d 1 0.002 2500 %.9g %.9g %.9g" % (k + 1, *p)
              for k, p in enumerate(state[:, :3])]
    lines += ["\nVelocities\n"]
    lines += ["%d %.9g %.9g %.9g %.9g %.9g %.9g" % (k + 1, *v)
              for k, v in enumerate(state[:, 3:9])]
    write(folder + "/bed.data", "\n".join(lines) + "\n")
    peak = folder + "/peak"
    done = subprocess.run(
        measured(["taskset", "-c", str(core), "liggghts",
                  "-in", here + "/peers/liggghtsBed.in",
                  "-var", "data", folder + "/bed.data",
                  "-var", "lx", str(width), "-var", "ly", str(width),
                  "-var", "warm", str(warmUp), "-var", "nt", str(steps),
                  "-var", "np", "1"], peak),
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, env=dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                            OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"))
    with open(peak) as stream:
        return done.stdout, int(stream.read())


def liggghts(folder, state, width, core):
    """Seconds of its steps after the warm-up, kinetic energy, contacts."""
    output, _ = runLiggghts(folder, state, width, core, warmUp, steps)
    times = re.findall(r"Loop time of ([0-9.e-]+) on", output)
    if len(times) < 2:
        raise SystemExit(output[-2000:])
    rows = re.findall(r"\n\s*%d\s+%d\s+([0-9.e-]+)\s+([0-9]+)"
                      % (warmUp + steps, len(state)), output)
    return float(times[1]), float(rows[-1][0]), int(rows[-1][1])//2


def run(name, n, width, bar, instructions="auto", repeats=3):
    with gzip.open("%s/states/bed%dk.txt.gz" % (here, n//1000), "rt") as stream:
        state = np.loadtxt(stream)[:n]
    core = max(os.sched_getaffinity(0))
    first = prepare(os.getcwd() + "/case", state, width, instructions)
    peer = shutil.which("liggghts")
    if not peer:
        print("liggghts is missing: apt-get install liggghts")

    ratios, speeds, peers = [], [], []
    for _ in range(repeats):
        seconds, energy, contacts = styx(os.getcwd() + "/case", first, core)
        speeds.append(n*steps/seconds)
        if peer:
            seconds, energyPeer, contactsPeer = liggghts(
                os.getcwd() + "/peer", state, width, core)
            peers.append(n*steps/seconds)
            ratios.append(speeds[-1]/peers[-1])

    print("particleStepsPerSecond %.4g" % statistics.median(speeds))
    print("kineticEnergy %.3g J" % energy)
    print("contacts %d" % contacts)
    met = False
    ratio = 0
    if peer:
        ratio = statistics.median(ratios)
        same = abs(contacts/contactsPeer - 1)
        print("liggghtsParticleStepsPerSecond %.4g" % statistics.median(peers))
        print("liggghtsKineticEnergy %.3g J" % energyPeer)
        print("liggghtsContacts %d" % contactsPeer)
        print("ratios " + " ".join("%.2f" % r for r in ratios))
        print("contactsOff %.2f %%" % (100*same))
        print("energyOff %.0f %%" % (100*abs(energy/energyPeer - 1)))
        met = (ratio >= bar and same <= 0.01
               and abs(energy/energyPeer - 1) <= 0.2)
    print("%s figure %.2f bar %g %s" % (name, ratio, bar,
                                        "met" if met else "missed"))
    return 0 if met else 1
