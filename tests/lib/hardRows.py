#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The hard cases of bodies alone on 2 ranks: each function runs a row on 1
#     and on 2 ranks, prints the number that the row must hold as the 2 ranks
#     have it, and the distance between the paths of 2 ranks and of 1.
#         steel("hard01_few", 4, 0.01, 0.06)      row 1, 4^3 spheres, from 10 mm
#------------------------------------------------------------------------------
import re
import subprocess

import numpy as np

from cloudCase import onRanks as command
from figure import figure, figureTrue
from hardCase import bodies, boxOfSpheres, boxWalls, figureRanks, floor, g, \
    head, lattice, middle, onRanks, prepare, text

shape = "shapes { %s { type sphere; diameter %g; } }\n"
grains = """shapes { grain { type sphere; diameter 1e-5; }
    ball { type sphere; diameter 1e-3; } }
"""
cubeOfNine = """shapes { cube { type multisphere; spheres (
    (( 0.0000  0.0000  0.0000) 0.0065)
    (( 0.0032  0.0032 -0.0032) 0.00365) ((-0.0032 -0.0032 -0.0032) 0.00365)
    ((-0.0032  0.0032 -0.0032) 0.00365) (( 0.0032 -0.0032 -0.0032) 0.00365)
    (( 0.0032  0.0032  0.0032) 0.00365) ((-0.0032 -0.0032  0.0032) 0.00365)
    ((-0.0032  0.0032  0.0032) 0.00365) (( 0.0032 -0.0032  0.0032) 0.00365)
); } }
"""
lossless = "damping none; tangential none;"


def spring(E, r, overlap):
    """Energy of Hertz contacts of an effective radius [J]."""
    return 8/15*E/(2*(1 - 0.3**2))*np.sqrt(r)*np.maximum(overlap, 0)**2.5


def springs(E, r, x, low, high):
    """Energy of all contacts of spheres with each other and a box [J]."""
    i, j = np.triu_indices(len(x), 1)
    gap = np.linalg.norm(x[i] - x[j], axis=1)
    return (spring(E, r/2, 2*r - gap).sum()
            + spring(E, r, r - (x - low)).sum()
            + spring(E, r, r - (high - x)).sum())


def steel(name, n, fall, end):
    """1: steel spheres of 1 mm dropped into a box from a height [m]."""
    d, w = 1e-3, 1.3e-3*n
    low, high = np.array((-w/2, -w/2, 0)), np.array((w/2, w/2, 0.5))
    balls = lattice("ball", d, 1.3, (n, n, n), low + (0, 0, fall),
                    np.random.default_rng(3))
    both = onRanks(name, head(2e11, "restitution 0.7; friction 0.3;",
                              density=7800)
                   + shape % ("ball", d) + boxWalls(low, high)
                   + bodies(*balls), 0.002, end, gravity=True)
    mass0 = 7800*np.pi/6*d**3
    start, worst = mass0*g*sum(x[2] for _, x in balls), 0
    for time, x, v, mass, L, w2 in both.states(
            "2", "mass", "angularMomentum", "angularVelocity"):
        height = g*(mass[:, 0]*x[:, 2]).sum()
        kinetic = 0.5*(mass*v**2).sum() + 0.5*(L*w2).sum()
        ratio = kinetic/(start - height)
        worst = max(worst, ratio)
    figure(name + "_energy2", worst, 0.5, 1 + 1e-9, "of what was released",
           "kinetic energy, largest of all times, 2 ranks, hard case 1")
    inside = ((x > middle + low) & (x < middle + high)).all(axis=1)
    figure(name + "_lost2", len(x) - inside.sum(), 0, 0, "spheres",
           "all are in the box")
    if end > 0.9:
        figure(name + "_rest2", ratio, None, 1e-6, "of what was released",
               "at rest at 1 s")
    figureRanks(name, both, d)


def headOn():
    """2: two balls meet at 100 m/s."""
    both = onRanks("hard02", head(1e8, "restitution 0.9; friction 0.5;")
                   + shape % ("ball", 0.01)
                   + bodies(("ball", (-0.01, 0, 0.1), (50, 0, 0)),
                            ("ball", (0.01, 0, 0.1), (-50, 0, 0))),
                   5e-4, 0.002)
    v = both.last("2", "velocity")
    figure("hard02_restitution2",
           (v[1]["velocity"][0] - v[0]["velocity"][0])/100, 0.891, 0.909, "-",
           "0.9 within 1 %, a ball a rank, hard case 2")
    figureRanks("hard02", both, 0.01)


def coarseRests():
    """4: a ball of 1 mm on a layer of 100 grains of 10 um."""
    d, R, pitch = 1e-5, 5e-4, 1.001e-5
    z = 0.5*d + np.sqrt((R + 0.5*d)**2 - pitch**2/2)
    layer = [("grain", (pitch*(k % 10 - 4.5), pitch*(k//10 - 4.5), 0.5*d))
             for k in range(100)]
    both = onRanks("hard04", head(1e9, "restitution 0.3; friction 0.5;")
                   + grains + floor
                   + bodies(*layer, ("ball", (0, 0, z))),
                   1e-4, 0.001, gravity=True)
    figure("hard04_inside2", both.overlap("2")/200, 1e-4, 0.01,
           "d of a grain", "deepest of the run, 2 ranks, hard case 4")
    last = both.last("2", "position")
    ball = last[100]["position"]
    touch = [np.linalg.norm(last[k]["position"] - ball) < R + 0.5*d
             for k in range(100)]
    figure("hard04_carry2", sum(touch), 3, None, "grains", "that carry it")
    figureRanks("hard04", both, d)


def startInOverlap(name, number, w):
    """5: balls at random in a cube, without start relax and with it."""
    random = np.random.default_rng(1)
    properties = (head(1e8, "restitution 0.5; friction 0.5;")
                  + shape % ("ball", 0.01)
                  + bodies(*(("ball", w*(random.uniform(-0.5, 0.5, 3)
                                         + (0, 0, 1)))
                             for _ in range(number))))
    stops(name + "_given", properties, 5e-4, 5e-4,
          ("overlap at the start", "body "), "overlap without start relax")
    both = onRanks(name, "start relax;\n" + properties, 5e-4, 2e-3)
    states = list(both.states("2"))
    figure(name + "_speed2", max(np.linalg.norm(v, axis=1).max()
                                 for _, _, v in states), None, 1, "m/s",
           "2 ms after start relax, 2 ranks, hard case 5")
    figure(name + "_overlap2", both.overlap("2"), None, 1, "%", "the same")
    figure(name + "_lost2", number - len(states[-1][1]), 0, 0, "bodies",
           "all stay")
    figureRanks(name, both, 0.01, meet=False)


def stops(name, properties, step, end, parts, source):
    """On 2 ranks the run stops, and says these parts."""
    case = prepare(name, properties, step, end, True, 1, None)
    log = case + "/log.demFoam"
    with open(log, "w") as out:
        status = subprocess.call(command(2, "demFoam"), cwd=case, stdout=out,
                                 stderr=out)
    with open(log) as stream:
        said = " ".join(stream.read().split())
    missing = [part for part in parts if part not in said]
    figureTrue(name + "_stops2", status != 0 and not missing,
               "status %d, without %s" % (status, missing)
               if missing or not status else "stops and says why",
               "2 ranks stop with the reason", source)


def wallIntoBed():
    """6: a lid at 1 m/s presses 96 balls by 2 %, without losses."""
    E, r, h = 1e8, 0.005, 0.0606
    low, high = np.array((-0.02, -0.02, 0)), np.array((0.02, 0.02, 0.5))
    lid = """lid { type rectangle; corner %s; edge1 (0.04 0 0);
    edge2 (0 0.04 0); material s;
    motion { type translate; velocity (0 0 -1); stop %.17g; } }""" % (
        text(middle + (-0.02, -0.02, h)), 0.02*h)
    rows = [("ball", low + 0.01*np.array((k % 4, k//4 % 4, k//16)) + (
        r, r, r + 1e-4*(k//16))) for k in range(96)]
    dt = 6e-6
    both = onRanks("hard06", head(E, "", lossless) + shape % ("ball", 2*r)
                   + boxWalls(low, high, lid) + bodies(*rows), dt, 202*dt)
    forces, energies = [], []
    for time, x, v, mass in both.states("2", "mass"):
        top = np.array((0.02, 0.02, h - time))
        depth = np.maximum(r - (top - (x - middle))[:, 2], 0)
        forces.append((4/3*E/(2*(1 - 0.09))*np.sqrt(r)*depth**1.5).sum())
        energies.append(springs(E, r, x - middle, low, top)
                        + 0.5*(mass*v**2).sum())
    work = dt*(np.array(forces[1:]) + forces[:-1]).sum()/2
    figure("hard06_energy2", (energies[-1] - energies[0])/work, 0.99, 1.01,
           "-", "of the lid's work, %d balls, 2 ranks, hard case 6" % len(x))
    jump = np.abs(np.diff(forces)).max()/max(forces)
    figure("hard06_smooth2", jump, 1e-4, 0.06, "of the largest force",
           "largest change of the lid's force in 6e-6 s")
    figureRanks("hard06", both, 2*r)


def thousandAtTriangle():
    """7: a ball at 1,000 m/s against a triangle, while another flies away."""
    worst = 0
    for control in ("hades", "contact"):
        name = "hard07_" + control
        both = onRanks(name, head(1e11, "", lossless,
                                  control="type %s;" % control)
                       + shape % ("ball", 0.01)
                       + "walls { w { type triSurface; file \"wall.obj\";"
                       " material s; } }\n"
                       + bodies(("ball", (0.01, 0.02, 0.02), (0, 0, -1000)),
                                ("ball", (-0.01, 0.02, 0.3), (0, 0, 1000))),
                       2e-5, 1e-4,
                       triangles=[((-1, -1, 0), (1, -1, 0), (0, 2, 0))])
        for _, x, v in both.states("2"):
            worst = max(worst, -x[0, 2], 0)
        worst = max(worst, abs(v[0, 2]/1000 - 1))
        figureRanks(name, both, 0.01, meet=False)
    figure("hard07_bounce2", worst, None, 0.01, "of 1,000 m/s",
           "comes back as fast, never behind, 2 ranks, hard case 7")


def fixedTooLong():
    """8: a fixed step a hundred times too long."""
    stops("hard08", head(1e8, "restitution 0.5; friction 0.5;",
                         control="type fixed; deltaT 1e-3;")
          + shape % ("ball", 0.01) + floor
          + bodies(("ball", (-0.01, 0, 0.02), (0, 0, -1)),
                   ("ball", (0.01, 0, 0.3), (0, 0, 0))), 0.01, 0.1,
          ("fixed deltaT is 0.001", "body 0", "need"), "hard case 8")


def tower(name, end):
    """9: 27 cubes upon each other."""
    edge = 0.0137
    both = onRanks(name, head(1e9, "restitution 0.5; friction 0.5;",
                              density=1000)
                   + cubeOfNine + floor
                   + bodies(*(("cube", (0, 0, edge*(k + 0.5)))
                              for k in range(27))), end/10, end, gravity=True)
    top = both.last("2", "position")[26]["position"] - middle
    figure(name + "_top2", np.hypot(*top[:2])/edge, None, 0.1, "edges",
           "of the top after %g s, 2 ranks, hard case 9" % end)
    figure(name + "_sinks2", 26.5 - top[2]/edge, 0, 0.5, "edges",
           "they give way to their weight")
    figureRanks(name, both, edge)


def lump():
    """10: a ball hits a lump of 500 spheres off its middle; beyond it another
    lump, so that the ranks are cut between ball and lump."""
    random = np.random.default_rng(2)
    inside = []
    while len(inside) < 500:
        x = random.uniform(-1, 1, 3)
        if x @ x < 1:
            inside.append("(%s 0.001)" % text(0.004*x))
    both = onRanks("hard10", head(
        1e8, "", lossless, 1000,
        "type contact; contactFraction 0.005; rayleighFraction 0.05;")
        + "shapes { lump { type multisphere; spheres (%s); }\n"
        "ball { type sphere; diameter 0.004; } }\n" % " ".join(inside)
        + bodies(("lump", (0, 0, 0.1)),
                 ("ball", (0.001, 0.0005, 0.09), (0, 0, 1)),
                 ("lump", (0, 0, 0.07))), 2e-3, 0.01)
    p, spin, energy = [], [], []
    for _, x, v, mass, L, w in both.states("2", "mass", "angularMomentum",
                                           "angularVelocity"):
        p.append((mass*v).sum(axis=0))
        spin.append((L + np.cross(x - middle, mass*v)).sum(axis=0))
        energy.append(0.5*(mass*v**2).sum() + 0.5*(L*w).sum())
    figure("hard10_moved2", np.linalg.norm(v[0]), 0.01, None, "m/s", "the lump")
    figure("hard10_momentum2", np.linalg.norm(p[-1] - p[0])
           / np.linalg.norm(p[0]), None, 1e-12, "-",
           "exact, ball and lump on 2 ranks, hard case 10")
    figure("hard10_angular2", np.linalg.norm(spin[-1] - spin[0])
           / np.linalg.norm(spin[0]), None, 1e-10, "-", "exact")
    figure("hard10_energy2", abs(energy[-1]/energy[0] - 1), None, 1e-3, "-",
           "without a loss")
    figureRanks("hard10", both, 0.008)


def tumble():
    """11: a plate and a needle of 1:20 tumble in a box without losses."""
    both = onRanks("hard11", head(1e7, "", lossless, 1000, "type contact;")
                   + "shapes { %s %s }\n" % (
                       boxOfSpheres("plate", 1e-3, 1, (20, 20, 1)),
                       boxOfSpheres("needle", 1e-3, 0.5, (39, 1, 1)))
                   + boxWalls(np.array((-0.025, -0.025, 0)),
                              np.array((0.025, 0.025, 0.05)))
                   + bodies(("plate", (-0.001, 0, 0.026), (0.7, 0.4, 0.9),
                             (60, 40, 20)),
                            ("needle", (0.001, 0.01, 0.04), (-0.7, 0.4, 0.9),
                             (60, 40, 20))), 1e-3, 0.1)
    energy = []
    contacts = [int(word) for word in
                re.findall(r"(\d+) contacts", both.log("2"))]
    for n, (_, _, v, mass, L, w) in enumerate(
            both.states("2", "mass", "angularMomentum", "angularVelocity")):
        if contacts[n] == 0:
            energy.append(0.5*(mass*v**2).sum() + 0.5*(L*w).sum())
    figure("hard11_energy2", max(abs(e/energy[0] - 1) for e in energy), None,
           1e-4, "-", "of plate and needle, 2 ranks, hard case 11")
    figure("hard11_free2", len(energy), 5, len(contacts) - 2, "times",
           "without a contact, of %d" % len(contacts))
    figureRanks("hard11", both, 0.02)


def rod(name, turns):
    """12: rods that spin about their middle axes."""
    both = onRanks(name, head(1e7, "", lossless, 1000,
                              "type fixed; deltaT 2.5e-6;")
                   + "shapes { %s }\n" % boxOfSpheres("rod", 1e-3, 0.8,
                                                      (5, 2, 1))
                   + bodies(("rod", (-0.02, 0, 0.1), (0, 0, 0),
                             (0.6, 628.3, 0.6)),
                            ("rod", (0.02, 0, 0.1), (0, 0, 0),
                             (0.6, -628.3, 0.6))),
                   0.01, 0.01*turns, writes=max(1, turns//20))
    energy, spin, up = [], [], []
    for _, L, w in ((t, *rest[2:]) for t, *rest in both.states(
            "2", "angularMomentum", "angularVelocity")):
        energy.append(0.5*(L*w).sum(axis=1))
        spin.append(L)
    energy, spin = np.array(energy), np.array(spin)
    figure(name + "_energy2", np.abs(energy/energy[0] - 1).max(), None, 1e-6,
           "-", "%d turns about the middle axis, 2 ranks, hard case 12" % turns)
    figure(name + "_spin2", (np.linalg.norm(spin - spin[0], axis=2)
                             / np.linalg.norm(spin[0], axis=1)).max(), None,
           1e-10, "-", "angular momentum")
    a, b = (both.last(r, "angularVelocity") for r in "12")
    figure(name + "_turned2", max(np.linalg.norm(
        a[k]["angularVelocity"] - b[k]["angularVelocity"])/628.3 for k in a),
        None, 1e-9, "-", "spin, 2 ranks against 1")
    figureRanks(name, both, 4e-3, meet=False)


def leftAlone(name, n, steps):
    """13: a bed that has settled for 0.6 s, and so many steps after that; the
    run is written each twentieth of these, and at its end."""
    d = 2e-3
    w, dt = 1.1*d*n, 1e-5
    low, high = np.array((-w/2, -w/2, 0)), np.array((w/2, w/2, 0.5))
    part = steps*dt/20
    start = part*np.ceil(0.6/part - 1e-9)
    both = onRanks(name, head(5e6, "restitution 0.5; friction 0.5;",
                              control="type fixed; deltaT 1e-5;")
                   + shape % ("ball", d) + boxWalls(low, high)
                   + bodies(*lattice("ball", d, 1.1, (n, n, n), low,
                                     np.random.default_rng(3))),
                   part, start + steps*dt, gravity=True)
    top, kinetic = [], []
    for time, x, v, mass, L, w in both.states("2", "mass", "angularMomentum",
                                              "angularVelocity"):
        if time > start - 1e-9:
            top.append(x[:, 2].max())
            kinetic.append(0.5*(mass*v**2).sum() + 0.5*(L*w).sum())
    figure(name + "_top2", abs(top[-1] - top[0])/d, None, 1e-3, "d",
           "how far the top moves in %d steps, 2 ranks, hard case 13" % steps)
    least = 1e-5*g*mass[0, 0]*d
    half = len(kinetic)//2
    figure(name + "_growth2", max(kinetic[half:])/max(*kinetic[:half], least),
           None, 1.05, "-",
           "kinetic energy of the second half over that of the first")
    figureRanks(name, both, d)


def coarseOnFine():
    """3: a ball of 1 mm on 500 loose grains of 10 um in a cup."""
    d, R, cup = 1e-5, 5e-4, 1.05e-4
    random = np.random.default_rng(5)
    first = ("start relax;\n" + head(2e9, "restitution 0.5; friction 0.5;")
             + grains + """walls
{
    floor { type plane; point (0 0 0); normal (0 0 1); material s; }
    cup { type cylinder; point %s; axis (0 0 1); radius %g; length 3e-5;
        ends open; material s; }
}
""" % (text(middle + (0, 0, -1e-5)), cup))
    places = [1.3*d*np.array((k % 16 - 7.5, k//16 % 16 - 7.5, k//256 + 0.6))
              + 0.1*d*random.uniform(-1, 1, 3) for k in range(768)]
    places = [x for x in places if np.hypot(*x[:2]) < cup - 0.6*d]
    bed = onRanks("hard03_bed", first + bodies(*(("grain", x) for x in places)),
                  3e-4, 3e-3, gravity=True)
    figureRanks("hard03_bed", bed, d, meet=False)
    settled = bed.last("2", "position")
    places = [settled[k]["position"] - middle for k in sorted(settled)]
    low = max(x[2] + np.sqrt((R + d/2)**2 - x[0]**2 - x[1]**2) for x in places)
    both = onRanks("hard03", first + bodies(
        *(("grain", x) for x in places), ("ball", (0, 0, low + 0.02*d))),
        1e-4, 5e-3, gravity=True)
    figure("hard03_overlap2", both.overlap("2"), 0.01, 5, "%",
           "of a grain's radius, largest, 2 ranks, hard case 3")
    z = both.last("2", "position")[len(places)]["position"][2]
    figure("hard03_stays2", (z - R)/d, 0.9, (low - R)/d + 1, "d of a grain",
           "height of the ball's lowest point")
    figureRanks("hard03", both, d, meet=False)


def gas(name, steps):
    """14: 1,000 spheres in a box without losses."""
    w, r, E, dt = 0.02, 0.001, 1e7, 1e-6
    random = np.random.default_rng(1)
    low, high = np.array((-w, -w, 0)), np.array((w, w, 2*w))
    rows = [("ball", 0.0036*(np.array((k % 10, k//10 % 10, k//100)) - 4.5)
             + 0.0007*random.uniform(-1, 1, 3) + (0, 0, w),
             random.uniform(-1, 1, 3)) for k in range(1000)]
    both = onRanks(name, head(E, "", lossless,
                              control="type fixed; deltaT 1e-6;")
                   + shape % ("ball", 2*r) + boxWalls(low, high)
                   + bodies(*rows), steps*dt/20, steps*dt)
    energy = [0.5*(mass*v**2).sum() + springs(E, r, x - middle, low, high)
              for _, x, v, mass in both.states("2", "mass")]
    figure(name + "_energy2", max(abs(e/energy[0] - 1) for e in energy), None,
           1e-3, "-", "drift in %d steps, 2 ranks, hard case 14" % steps)
    figureRanks(name, both, 2*r)
