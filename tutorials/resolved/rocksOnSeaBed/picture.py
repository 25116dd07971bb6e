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
#     Draws the rocks by their spheres, coloured by their velocity downwards, the
#     pipe, and the water's speed with the refined mesh in the plane in the
#     middle, of the written time next to the one named (else the last).
# -----------------------------------------------------------------------------
from paraview.simple import (
    ExtractBlock, FeatureEdges, GetColorTransferFunction, GetScalarBar, Outline,
    Show, Slice)
from styxScene import balls, coloured, heading, openCase, run, save


def labels(view, name, values, form):
    bar = GetScalarBar(GetColorTransferFunction(name), view)
    bar.UseCustomLabels, bar.CustomLabels = 1, values
    bar.AddRangeLabels, bar.LabelFormat = 0, form


def main(png, time=None):
    reader, view, time = openCase((1400, 1300), "lagrangian/demCloudSpheres",
                                  time)
    reader.MeshRegions = ["internalMesh", "patch/pipe",
                          "lagrangian/demCloudSpheres"]
    reader.UpdatePipeline(time)
    mesh = ExtractBlock(Input=reader, Selectors=["/Root/internalMesh"])
    plane = Slice(Input=mesh)
    plane.SliceType.Origin = [0, 0.201, 0]
    plane.SliceType.Normal = [0, 1, 0]
    plane.Triangulatetheslice = 0
    shown = Show(plane, view)
    coloured(shown, view, ("CELLS", "U"), "Magnitude", (0, 1), "Blues",
             "water: speed [m/s]", [0.86, 0.55])
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.75, 0.80, 0.86]
    shown.Ambient, shown.Diffuse = 1, 0
    GetColorTransferFunction("U").InvertTransferFunction()
    labels(view, "U", [0, 0.5, 1], "%.1f")

    rocks = balls(ExtractBlock(Input=reader, Selectors=["/Root/lagrangian"]))
    coloured(Show(rocks, view), view, ("POINTS", "velocity"), "Z", (-1.5, 0),
             "Viridis (matplotlib)", "rocks: upwards [m/s]", [0.86, 0.15])
    labels(view, "velocity", [-1.5, -0.75, 0], "%.2f")

    edges = FeatureEdges(Input=ExtractBlock(
        Input=reader, Selectors=["/Root/boundary/pipe"]))
    edges.FeatureAngle = 60
    shown = Show(edges, view)
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = shown.AmbientColor = [0.55, 0.30, 0.12]
    shown.LineWidth = 2
    Show(Outline(Input=mesh), view).DiffuseColor = [0.3, 0.3, 0.3]

    heading(f"Rocks fall through a pipe to the sea bed, t = {time:.3g} s", view)
    save(png, view, [-2.6, -10.5, 4.6], [0.3, 0, 1.8], 29)


run(main)
