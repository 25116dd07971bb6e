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

from paraview.simple import (
    CellDatatoPointData, Clip, Contour, ExtractBlock, Outline, STLReader, Show)
from styxScene import headings, openCase, run, save

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from rock import placed     # beside this file


def part(reader, selector):
    return ExtractBlock(Input=reader, Selectors=[selector])


def plain(shown, colour, opacity=1):
    shown.Representation = "Surface"
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = shown.AmbientColor = colour
    shown.Opacity = opacity
    return shown


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

    # The water, as if of glass, and its surface
    mesh = part(reader, "/Root/internalMesh")
    alpha = CellDatatoPointData(Input=mesh)
    water = Clip(Input=alpha)
    water.ClipType = "Scalar"
    water.Scalars = ["POINTS", "alpha.water"]
    water.Value = 0.5
    water.Invert = 0
    plain(Show(water, view), [0.25, 0.55, 0.75], 0.25)
    surface = Contour(Input=alpha)
    surface.ContourBy = ["POINTS", "alpha.water"]
    surface.Isosurfaces = [0.5]
    plain(Show(surface, view), [0.30, 0.62, 0.82], 0.45).Specular = 0.4
    plain(Show(Outline(Input=mesh), view), [0.30, 0.34, 0.38]).LineWidth = 2

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
