# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Usage
#     ../../../bin/styxRender picture.py FILE.png [time]
#
# Description
#     Draws the case that it stands in: the rock, the water and its
#     surface. Takes the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

import os
import sys
import tempfile

from paraview.simple import STLReader, Show
from styxScene import glassWater, headings, openCase, plain, run, save

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from rock import placed     # beside this file


def write(triangles, stl):
    stl.write("solid rock\n")
    for corners in triangles:
        stl.write("facet normal 0 0 0\nouter loop\n")
        for corner in corners:
            stl.write("vertex %.9g %.9g %.9g\n" % tuple(corner))
        stl.write("endloop\nendfacet\n")
    stl.write("endsolid rock\n")


def main(png, time=None):
    reader, view, time = openCase((1600, 1200), "lagrangian/demCloudSpheres",
                                  time, sky=True)
    reader.MeshRegions = ["internalMesh", "lagrangian/demCloudSpheres"]
    reader.CellArrays = ["alpha.water"]
    reader.UpdatePipeline(time)

    glassWater(reader, view)

    # The rock as the water sees it
    with tempfile.NamedTemporaryFile("w", suffix=".stl") as stl:
        write(placed("%g" % time)[0], stl)
        stl.flush()
        surface = STLReader(FileNames=[stl.name])
        surface.UpdatePipeline()
        rock = plain(Show(surface, view), [0.66, 0.62, 0.56])
    rock.Interpolation = "Flat"

    headings("Pumice floats: a rock of 640 kg/m3",
             f"t = {time:.2f} s    interFoam, Styx", view)
    save(png, view, [0.20, -0.26, 0.115], [0.06, 0.06, 0.046], 24)


run(main)
