# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     What pictures of beds share, for ParaView scripts that styxRender runs:
#         reader, view, time = openCase((1400, 1200), "lagrangian/demCloud")
#         balls(source, 0.001)        spheres of one diameter at the points
#         coloured(Show(...), view, ("CELLS", "U"), "X", (0, 1), "Blues",
#                  "water [m/s]", [0.6, 0.06], horizontal=True)
#         heading("A bed", view)
# -----------------------------------------------------------------------------
import os

from paraview.simple import (
    ColorBy, CreateView, GetColorTransferFunction, GetScalarBar, Glyph,
    OpenFOAMReader, Show, Text)

dark = [0.1, 0.1, 0.1]


def openCase(size, cloud, time=None):
    """The case of this folder with its mesh and a cloud, a view of it on
    white, and the written time next to the one named (else the last)."""
    case = os.path.basename(os.getcwd()) + ".foam"
    open(case, "a").close()
    reader = OpenFOAMReader(FileName=case)
    reader.MeshRegions = ["internalMesh", cloud]
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    time = min(times, key=lambda t: abs(t - time)) if time else times[-1]

    view = CreateView("RenderView")
    view.ViewSize = list(size)
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    reader.UpdatePipeline(time)
    return reader, view, time


def balls(source, diameter):
    glyph = Glyph(Input=source, GlyphType="Sphere")
    glyph.GlyphType.Radius = diameter/2
    glyph.GlyphType.ThetaResolution = glyph.GlyphType.PhiResolution = 20
    glyph.ScaleArray = ["POINTS", "No scale array"]
    glyph.ScaleFactor = 1
    glyph.GlyphMode = "All Points"
    return glyph


def coloured(shown, view, field, component, span, scheme, title, place,
             horizontal=False):
    """Colour by a component ("" for a scalar), with a bar at a place."""
    shown.Representation = "Surface"
    ColorBy(shown, field + ((component,) if component else ()))
    table = GetColorTransferFunction(field[1])
    table.ApplyPreset(scheme, True)
    table.RescaleTransferFunction(*span)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = dark
    bar.WindowLocation, bar.Position = "Any Location", place
    bar.Orientation = "Horizontal" if horizontal else "Vertical"
    bar.ScalarBarLength = 0.3
    bar.TitleFontSize = bar.LabelFontSize = 22
    shown.SetScalarBarVisibility(view, True)


def heading(text, view, place=(0.03, 0.955), size=30):
    shown = Show(Text(Text=text), view)
    shown.WindowLocation, shown.Position = "Any Location", list(place)
    shown.FontSize, shown.Color = size, dark
