#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The case of tests/restart/restartDem in a drum of triangles that turns,
#     over a plate that vibrates, with a shelf that opens at one of the times
#     that are written and a lid that closes.
#------------------------------------------------------------------------------
import math
import os
import re

from cloudCase import copyCase, runIn

walls = """walls
{
    drum
    {
        type triSurface; file "drum.stl"; scale 0.001; material stone;
        motion
        {
            type rotate; origin (0.025 0.025 0); axis (0 0 1); omega 20;
            start 0.01;
        }
    }
    plate
    {
        type box; min (-1 -1 -1); max (1 1 0.002); side outside;
        material stone;
        motion { type vibrate; amplitude (0 0 5e-4); frequency 60; }
    }
    shelf
    {
        type rectangle; corner (0 0 0.004); edge1 (0.05 0 0);
        edge2 (0 0.05 0); material stone; open 0.03;
    }
    lid
    {
        type plane; point (0 0 0.0595); normal (0 0 -1); material stone;
        close 0.02;
    }
    sides { type patch; material stone; }
}"""


def movingWalls(name):
    """Make the case with its mesh."""
    case = copyCase(os.environ["STYX_DIR"] + "/tests/restart/restartDem", name)
    file = case + "/constant/demCloudProperties"
    with open(file) as stream:
        text = stream.read()
    with open(file, "w") as stream:
        stream.write(re.sub(r"walls +\{.*?\n", walls + "\n", text))

    # An open tube of 60 facets, in mm
    os.mkdir(case + "/constant/triSurface")
    with open(case + "/constant/triSurface/drum.stl", "w") as stream:
        stream.write("solid drum\n")
        rim = [(25 + 25.5*math.cos(math.pi*k/30),
                25 + 25.5*math.sin(math.pi*k/30)) for k in range(61)]
        for a, b in zip(rim, rim[1:]):
            for corners in (((a, 0), (b, 0), (b, 60)), ((a, 0), (b, 60), (a, 60))):
                stream.write("facet normal 0 0 0\nouter loop\n")
                for (x, y), z in corners:
                    stream.write("vertex %.9g %.9g %g\n" % (x, y, z))
                stream.write("endloop\nendfacet\n")
        stream.write("endsolid drum\n")
    runIn(case, "blockMesh")
    return case
