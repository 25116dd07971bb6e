# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Twelve scenes of which is known which effects matter, as cases: a box, a
#     fluid and its velocity, bodies.
#
#     from sceneCases import scenes, makeCase
#     makeCase("1_dust", **scenes["1_dust"]["case"])
#     scenes["1_dust"]["on"], scenes["1_dust"]["off"]
# -----------------------------------------------------------------------------

import math
import os

header = """FoamFile
{ version 2.0; format ascii; class %s; object %s; }
"""


def write(case, name, kind, text):
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as stream:
        stream.write(header % (kind, os.path.basename(name)) + text)


def velocityField(n, profile, edge):
    """The internal field: a vector, or of a function of the height."""
    if not callable(profile):
        return "uniform %s" % profile
    values = []
    for k in range(n[2]):
        u = profile((k + 0.5)*edge[2]/n[2])
        values += ["(%.9g 0 0)" % u]*(n[0]*n[1])
    return "nonuniform List<vector>\n%d\n(\n%s\n)" % (
        len(values), "\n".join(values))


def makeCase(name, edge, n, properties, rho=None, nu=1e-6, U="(0 0 0)",
             wall="fixedValue; value uniform (0 0 0)", deltaT=1e-4,
             endTime=1e-3, gravity=True, options="", kind="wall", levels=0):
    """A box with an edge and n cells in each direction, which the mesh can
    halve so many times; without rho there is no fluid."""
    faces = ("(0 4 7 3)", "(1 2 6 5)", "(0 1 5 4)", "(3 7 6 2)", "(0 3 2 1)",
             "(4 5 6 7)")
    x, y, z = edge
    write(name, "system/blockMeshDict", "dictionary", """
vertices ( (0 0 0) ({x} 0 0) ({x} {y} 0) (0 {y} 0)
           (0 0 {z}) ({x} 0 {z}) ({x} {y} {z}) (0 {y} {z}) );
blocks ( hex (0 1 2 3 4 5 6 7) ({n}) simpleGrading (1 1 1) );
boundary ( walls {{ type {kind}; faces ( {faces} ); }} );
""".format(x=x, y=y, z=z, n=" ".join(map(str, n)), faces=" ".join(faces),
           kind=kind))
    write(name, "system/controlDict", "dictionary", """
application {app}; libs (styx);
startFrom startTime; startTime 0; stopAt endTime; endTime {end};
deltaT {dt}; writeControl runTime; writeInterval {end};
writeFormat ascii; writePrecision 17; timePrecision 12; {options}
""".format(app="demFoam" if rho is None else "pimpleFoam", dt=deltaT,
           end=endTime, options=options))
    write(name, "system/fvSchemes", "dictionary", """
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""")
    write(name, "system/fvSolution", "dictionary", """
solvers
{
    "p.*" { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0; }
}
PIMPLE { pRefCell 0; pRefValue 0; nCorrectors 2; }
""")
    write(name, "system/decomposeParDict", "dictionary", """
numberOfSubdomains 2; method simple;
simpleCoeffs { n (2 1 1); delta 0.001; }
""")
    if levels:
        write(name, "constant/dynamicMeshDict", "dictionary", """
dynamicFvMesh dynamicRefineFvMesh;
dynamicRefineFvMeshCoeffs
{ refineInterval 1; maxRefinement %d; maxCells 2000000; }
""" % levels)
    if gravity:
        write(name, "constant/g", "uniformDimensionedVectorField",
              "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n")
    if rho is not None:
        write(name, "constant/transportProperties", "dictionary",
              "transportModel Newtonian; nu %g;\n" % nu)
        write(name, "constant/turbulenceProperties", "dictionary",
              "simulationType laminar;\n")
        write(name, "constant/fvOptions", "dictionary",
              "particles { type demCloud; }\n")
        write(name, "0/U", "volVectorField", """
dimensions [0 1 -1 0 0 0 0]; internalField %s;
boundaryField { walls { type %s; } }
""" % (velocityField(n, U, edge), wall))
        write(name, "0/p", "volScalarField", """
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { walls { type zeroGradient; } }
""")
        properties = "fluid { rho %g; }\n" % rho + properties
    write(name, "constant/demCloudProperties", "dictionary", properties)
    return name


def dem(density, d, bodies, pairs="", material="", contact="", walls=False,
        effects="effects auto;\n"):
    """What the particles are: the entry bodies or generators is given."""
    return effects + """
demSolver hades;
materials {{ grain {{ density {rho}; youngsModulus 1e8; poissonsRatio 0.3;
    {material} }} }}
pairs {{ grain-grain {{ restitution 0.8; friction 0.3; {pairs} }} }}
shapes {{ ball {{ type sphere; diameter {d}; }} }}
{contact}
{walls}
stepControl {{ type hades; }}
{bodies}
""".format(rho=density, d=d, bodies=bodies, pairs=pairs, material=material,
           contact=contact,
           walls="walls { all { type patch; material grain; } }"
           if walls else "")


def spread(number, edge, velocity="(0 0 0)", margin=0.1):
    """So many bodies somewhere in the box, at the start."""
    low = " ".join("%g" % (margin*e) for e in edge)
    high = " ".join("%g" % ((1 - margin)*e) for e in edge)
    return """generators {{ all {{ type fill; shape ball; material grain;
    number {n}; region {{ box ({low}) ({high}); }} velocity {v}; }} }}
""".format(n=number, low=low, high=high, v=velocity)


def one(position, velocity="(0 0 0)", spin="(0 0 0)"):
    return """bodies {{ a {{ shape ball; material grain; position ({x});
    velocity {v}; angularVelocity {w}; }} }}
""".format(x=" ".join("%g" % c for c in position), v=velocity, w=spin)


def edgeFor(number, d, fraction):
    """Edge of the cube in which so many spheres have that fraction."""
    return (number*math.pi/6*d**3/fraction)**(1/3)


points = ["drag", "buoyancy", "pressureGradient", "viscous", "virtualMass",
          "basset", "saffman", "magnus", "rotationalDrag"]
fluid = points + ["exchange", "averaging", "immersed", "refinement",
                  "lubrication"]


def cloud(number, d, density, fraction, rho, nu, cells, **more):
    """Bodies somewhere in a cube."""
    e = edgeFor(number, d, fraction)
    walls = more.pop("walls", False)
    velocity = more.pop("velocity", "(0 0 0)")
    return dict(edge=(e, e, e), n=(cells, cells, cells), rho=rho, nu=nu,
                properties=dem(density, d, spread(number, (e, e, e), velocity),
                               walls=walls), **more)


def alone(number, d, fraction, **more):
    """Powder of 1500 kg/m3 without a fluid, in a box with walls."""
    e = edgeFor(number, d, fraction)
    return dict(edge=(e, e, e), n=(4, 4, 4),
                properties=dem(1500, d, spread(number, (e, e, e)), walls=True,
                               **more))


# Surface tension for a Bond number of 10 at 100 um, and a charge for a force
# that is the weight at a spacing of two diameters
weight = 1500*math.pi/6*1e-12*9.81
tension = 10*weight/(2*math.pi*50e-6)
charge = math.sqrt(weight*(2e-4)**2*4*math.pi*8.8541878128e-12)
sigma = charge/(4*math.pi*(50e-6)**2)

bedEdge = (0.15, 0.015, 0.15)

scenes = {
    "1_dust": dict(
        case=cloud(100, 50e-6, 2500, 1e-7, 1.2, 1.5e-5, 8),
        on=["drag"],
        off=["contacts", "virtualMass", "basset", "pressureGradient",
             "saffman", "magnus", "rotation", "exchange"]),
    "2_sand": dict(
        case=cloud(100, 0.5e-3, 2650, 1e-4, 1000, 1e-6, 8),
        on=["drag", "buoyancy", "virtualMass", "basset", "exchange"],
        off=["contacts", "saffman", "magnus", "rotation"]),
    "3_pneumaticLine": dict(
        case=cloud(400, 200e-6, 2500, 5e-4, 1.2, 1.5e-5, 6, walls=True,
                   U=lambda z: 3000*z, velocity="(8 0 0)",
                   wall="zeroGradient"),
        on=["drag", "exchange", "saffman", "walls"],
        off=["virtualMass", "basset", "buoyancy", "contacts"]),
    "4_fluidisedBed": dict(
        case=dict(edge=bedEdge, n=(15, 2, 30), rho=1.2, nu=1.5e-5,
                  U="(0 0 1.25)", wall="zeroGradient",
                  properties=dem(2526, 2.5e-3, spread(
                      10000, (0.15, 0.015, 0.15), "(0 0 0)", 0.02),
                      walls=True)),
        on=["drag", "denseDrag", "pressureGradient", "contacts", "friction",
            "rotation", "walls", "exchange", "averaging"],
        off=["virtualMass", "basset", "saffman", "lubrication", "immersed"]),
    "5_sphereInTank": dict(
        case=dict(edge=(0.1, 0.1, 0.16), n=(10, 10, 16), rho=962,
                  nu=0.113/962, levels=3, properties=dem(
                      1120, 0.015, one((0.05, 0.05, 0.12)))),
        on=["immersed", "refinement"],
        off=points + ["averaging", "contacts"]),
    "6_beadInShear": dict(
        case=dict(edge=(0.04, 0.04, 0.04), n=(10, 10, 10), rho=1260, nu=1e-3,
                  U=lambda z: 10*(z - 0.02), wall="zeroGradient",
                  properties=dem(1260, 1e-3, one((0.021, 0.021, 0.0201)))),
        on=["drag", "pressureGradient", "virtualMass", "basset",
            "rotationalDrag", "rotation"],
        off=["contacts", "magnus", "saffman"]),
    "7_spinningBall": dict(
        case=dict(edge=(2, 2, 2), n=(10, 10, 10), rho=1.2, nu=1.5e-5,
                  properties=dem(2.7e-3/(math.pi/6*0.04**3), 0.04, one(
                      (0.5, 1, 1), "(10 0 0)", "(0 300 0)"))),
        on=["drag", "magnus", "rotation", "rotationalDrag"],
        off=["virtualMass", "basset", "saffman", "contacts"]),
    "8_stickyPowder": dict(
        case=alone(100, 100e-6, 0.1, pairs="surfaceTension %g; "
                   "contactAngle 0; bridgeVolume 0.01;" % tension),
        on=["contacts", "friction", "rotation", "capillary", "walls"],
        off=fluid + ["electrostatic"]),
    "9_chargedPowder": dict(
        case=alone(100, 100e-6, math.pi/6/8,
                   material="surfaceCharge %g;" % sigma,
                   contact="contact { chargeCutOff 1e-3; }"),
        on=["contacts", "friction", "rotation", "electrostatic"],
        off=fluid + ["capillary"]),
    "10_hopper": dict(
        case=alone(500, 6e-3, 0.2),
        on=["contacts", "friction", "rotation", "walls"],
        off=fluid + ["capillary", "vanDerWaals", "simplifiedJKR",
                     "electrostatic"]),
    "11_rocks": dict(
        case=dict(edge=(0.16, 0.16, 0.16), n=(64, 64, 64), rho=1000, nu=1e-6,
                  properties=dem(2650, 0.02, spread(
                      8, (0.16, 0.16, 0.16)), walls=True)),
        on=["immersed", "contacts", "friction", "rotation", "walls",
            "refinement"],
        off=points + ["averaging"]),
    "12_lightSpheres": dict(
        case=cloud(100, 1e-3, 100, 1e-4, 1000, 1e-6, 8),
        on=["drag", "buoyancy", "virtualMass", "basset", "exchange"],
        off=["contacts", "saffman", "magnus"]),
}
