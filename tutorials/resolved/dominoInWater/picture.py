# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Usage
#     styxRender ../../picture.py FILE.png [time]       in the folder of a run
#
# Description
#     Draws the columns by their spheres, and the water's speed with the refined
#     mesh in the plane in the middle, of the written time next to the one named
#     (else the last).
# -----------------------------------------------------------------------------
import os

from paraview.simple import (
    ExtractBlock, GetColorTransferFunction, GetScalarBar, Outline,
    Show, Slice)
from styxScene import balls, coloured, heading, openCase, run, save


def main(png, time=None):
    reader, view, time = openCase((1500, 760), "lagrangian/demCloudSpheres",
                                  time)
    mesh = ExtractBlock(Input=reader, Selectors=["/Root/internalMesh"])
    plane = Slice(Input=mesh)
    plane.SliceType.Origin = [0, 0.001, 0]
    plane.SliceType.Normal = [0, 1, 0]
    plane.Triangulatetheslice = 0
    shown = Show(plane, view)
    coloured(shown, view, ("CELLS", "U"), "Magnitude", (0, 0.4), "Blues",
             "water: speed [m/s]", [0.66, 0.80], horizontal=True)
    table = GetColorTransferFunction("U")
    table.InvertTransferFunction()
    bar = GetScalarBar(table, view)
    bar.UseCustomLabels, bar.CustomLabels = 1, [0, 0.2, 0.4]
    bar.AddRangeLabels, bar.LabelFormat = 0, "%.1f"
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.75, 0.80, 0.86]
    shown.Ambient, shown.Diffuse = 1, 0

    spheres = ExtractBlock(Input=reader, Selectors=["/Root/lagrangian"])
    shown = Show(balls(spheres, 0.01), view)
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = [0.85, 0.55, 0.25]
    Show(Outline(Input=mesh), view).DiffuseColor = [0.3, 0.3, 0.3]

    name = os.path.basename(os.getcwd()).split("_")
    heading(f"Five columns in water, {name[0]} cluster, t = {time:.3g} s", view,
            place=(0.03, 0.93))

    save(png, view, [0.14, -0.75, 0.30], [0.14, 0, 0.085], 17)


run(main)
