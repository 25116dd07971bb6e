# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Usage
#     xvfb-run -a pvbatch picture.py FILE.png [time]
#
# Description
#     Draws the grains by their velocity along the stream, and behind them the
#     water's, at the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

import os
import sys

from paraview.simple import (
    ColorBy, CreateView, ExtractBlock, GetColorTransferFunction, GetScalarBar,
    Glyph, OpenFOAMReader, SaveScreenshot, Show, Slice, Text, Transform)


def coloured(shown, view, field, high, scheme, title, place):
    shown.Representation = "Surface"
    ColorBy(shown, field + ("X",))
    table = GetColorTransferFunction(field[1])
    table.ApplyPreset(scheme, True)
    table.RescaleTransferFunction(0, high)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.WindowLocation, bar.Position = "Any Location", place
    bar.Orientation = "Horizontal"
    bar.ScalarBarLength = 0.3
    bar.TitleFontSize = bar.LabelFontSize = 20
    shown.SetScalarBarVisibility(view, True)


def main(png, time=None):
    case = os.path.basename(os.getcwd()) + ".foam"
    open(case, "a").close()
    reader = OpenFOAMReader(FileName=case)
    reader.MeshRegions = ["internalMesh", "lagrangian/demCloud"]
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    time = min(times, key=lambda t: abs(t - time)) if time else times[-1]

    view = CreateView("RenderView")
    view.ViewSize = [1400, 900]
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    reader.UpdatePipeline(time)

    grains = Glyph(Input=ExtractBlock(Input=reader,
                                      Selectors=["/Root/lagrangian"]),
                   GlyphType="Sphere")
    grains.GlyphType.Radius = 0.0005
    grains.GlyphType.ThetaResolution = grains.GlyphType.PhiResolution = 16
    grains.ScaleArray = ["POINTS", "No scale array"]
    grains.ScaleFactor = 1
    grains.GlyphMode = "All Points"
    coloured(Show(grains, view), view, ("POINTS", "velocity"), 0.5,
             "Inferno (matplotlib)", "grains, along the stream [m/s]",
             [0.12, 0.06])

    cut = Slice(Input=ExtractBlock(Input=reader,
                                   Selectors=["/Root/internalMesh"]))
    cut.SliceType.Origin = [0.024, 0.0119, 0.012]
    cut.SliceType.Normal = [0, 1, 0]
    behind = Transform(Input=cut)
    behind.Transform.Translate = [0, 0.001, 0]
    coloured(Show(behind, view), view, ("CELLS", "U"), 1.0,
             "Blues", "water, along the stream [m/s]", [0.6, 0.06])

    title = Show(Text(Text=f"2,970 grains of sand, {time - 0.2:.3g} s after"
                           " the current has come"), view)
    title.WindowLocation, title.Position = "Any Location", [0.03, 0.95]
    title.FontSize, title.Color = 26, [0.1, 0.1, 0.1]

    view.CameraPosition = [0.024, -0.11, 0.035]
    view.CameraFocalPoint = [0.024, 0.006, 0.0095]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 20
    SaveScreenshot(png, view, ImageResolution=[1400, 900])
    print(f"{png}: t = {time:g} s")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit("Usage: pvbatch picture.py FILE.png [time]")
    main(sys.argv[1], *(float(word) for word in sys.argv[2:]))
