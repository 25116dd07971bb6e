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
#         plain(Show(...), [0.7, 0.5, 0.3], 0.5)      one colour, half opaque
#         glassWater(reader, view)    what alpha.water is, its surface, the box
#         coloured(Show(...), view, ("CELLS", "U"), "X", (0, 1), "Blues",
#                  "water [m/s]", [0.6, 0.06], horizontal=True)
#         heading("A bed", view)
#         save(png, view, [0, -1, 0], [0, 0, 0], 20)
#     and at the end of the script  run(main),  with main(png, time=None).
# -----------------------------------------------------------------------------
import os
import sys

from paraview.simple import (
    CellDatatoPointData, Clip, ColorBy, Contour, CreateView, ExtractBlock,
    GetColorTransferFunction, GetScalarBar, Glyph, OpenFOAMReader, Outline,
    SaveScreenshot, Show, Text)

dark = [0.1, 0.1, 0.1]


def openCase(size, cloud, time=None, sky=False):
    """The case of this folder with its mesh and a cloud, a view of it on
    white or before a sky, and the written time next to the one named (else the
    last)."""
    case = os.path.basename(os.getcwd()) + ".foam"
    open(case, "a").close()
    reader = OpenFOAMReader(FileName=case)
    if os.path.isdir("processor0"):
        reader.CaseType = "Decomposed Case"
    reader.MeshRegions = ["internalMesh", cloud]
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    time = min(times, key=lambda t: abs(t - time)) if time else times[-1]

    view = CreateView("RenderView")
    view.ViewSize = list(size)
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    if sky:
        view.BackgroundColorMode = "Gradient"
        view.Background, view.Background2 = [0.97, 0.98, 0.99], [0.8, 0.87, 0.93]
    view.OrientationAxesVisibility = 0
    reader.UpdatePipeline(time)
    return reader, view, time


def part(reader, *selectors):
    return ExtractBlock(Input=reader, Selectors=list(selectors))


def plain(shown, colour, opacity=1):
    """In one colour."""
    shown.Representation = "Surface"
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = shown.AmbientColor = colour
    shown.Opacity = opacity
    return shown


def glassWater(reader, view):
    """The water of the field alpha.water, its surface, and the edges of the
    domain."""
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


def balls(source, diameter=None, corners=20):
    """Spheres at points, of one diameter or each of its own."""
    glyph = Glyph(Input=source, GlyphType="Sphere")
    glyph.GlyphType.Radius = diameter/2 if diameter else 0.5
    glyph.GlyphType.ThetaResolution = glyph.GlyphType.PhiResolution = corners
    glyph.ScaleArray = [
        "POINTS", "No scale array" if diameter else "diameter"]
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


def headings(title, line, view):
    """What it is, and in a line below when and by which solver."""
    shown = Show(Text(Text=title), view)
    shown.WindowLocation, shown.Position = "Any Location", [0.03, 0.935]
    shown.FontSize, shown.Bold, shown.Color = 34, 1, [0.08, 0.12, 0.18]
    shown = Show(Text(Text=line), view)
    shown.WindowLocation, shown.Position = "Any Location", [0.03, 0.895]
    shown.FontSize, shown.Color = 24, [0.25, 0.30, 0.36]


def save(png, view, position, focus, angle):
    """A picture from a position to a focus, the angle of view in degrees."""
    view.CameraPosition, view.CameraFocalPoint = position, focus
    view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], angle
    SaveScreenshot(png, view, ImageResolution=list(view.ViewSize))
    print(f"{png}: t = {view.ViewTime:g} s")


def run(main):
    """Call main with the arguments of the script: FILE.png [time]."""
    if not 2 <= len(sys.argv) <= 3:
        sys.exit("Usage: styxRender picture.py FILE.png [time]")
    main(sys.argv[1], *(float(word) for word in sys.argv[2:]))
