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
#     Draws the case that it stands in: the block's spheres, the water and its
#     surface. Takes the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

from paraview.simple import Show
from styxScene import (
    balls, glassWater, headings, openCase, part, plain, run, save)


def main(png, time=None):
    reader, view, time = openCase((1600, 1200), "lagrangian/demCloudSpheres",
                                  time, sky=True)
    reader.MeshRegions = ["internalMesh", "lagrangian/demCloudSpheres"]
    reader.CellArrays = ["alpha.water"]
    reader.UpdatePipeline(time)

    glassWater(reader, view)

    # The block
    spheres = balls(part(reader, "/Root/lagrangian"), corners=48)
    wood = plain(Show(spheres, view), [0.72, 0.50, 0.28])
    wood.Specular, wood.SpecularPower = 0.15, 12

    headings("A block of half the density of water floats",
             f"t = {time:.2f} s    interFoam, Styx", view)
    save(png, view, [0.20, -0.26, 0.115], [0.06, 0.06, 0.046], 24)


run(main)
