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
#     Draws the beads by their velocity upwards, and beside them the void
#     fraction, at the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

import os
import sys

from paraview.simple import (
    ColorBy, CreateView, ExtractBlock, GetColorTransferFunction, GetScalarBar,
    Glyph, OpenFOAMReader, Outline, SaveScreenshot, Show, Text, Transform)


def coloured(shown, view, field, component, low, high, scheme, title, place):
    shown.Representation = "Surface"
    ColorBy(shown, field + component)
    table = GetColorTransferFunction(field[1])
    table.ApplyPreset(scheme, True)
    table.RescaleTransferFunction(low, high)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.WindowLocation, bar.Position = "Any Location", place
    bar.ScalarBarLength = 0.3
    bar.TitleFontSize = bar.LabelFontSize = 22
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
    view.ViewSize = [1400, 1200]
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    reader.UpdatePipeline(time)

    beads = Glyph(Input=ExtractBlock(Input=reader,
                                     Selectors=["/Root/lagrangian"]),
                  GlyphType="Sphere")
    beads.GlyphType.Radius = 0.00125
    beads.GlyphType.ThetaResolution = beads.GlyphType.PhiResolution = 16
    beads.ScaleArray = ["POINTS", "No scale array"]
    beads.ScaleFactor = 1
    beads.GlyphMode = "All Points"
    coloured(Show(beads, view), view, ("POINTS", "velocity"), ("Z",), -0.5,
             0.5, "Cool to Warm", "velocity upwards [m/s]", [0.87, 0.55])

    mesh = ExtractBlock(Input=reader, Selectors=["/Root/internalMesh"])
    aside = Transform(Input=mesh)
    aside.Transform.Translate = [0, 0.18, 0]
    coloured(Show(aside, view), view, ("CELLS", "voidFraction"), (), 0.4, 1,
             "Viridis (matplotlib)", "void fraction [-]", [0.87, 0.15])
    Show(Outline(Input=mesh), view).DiffuseColor = [0.3, 0.3, 0.3]

    title = Show(Text(Text=f"24,750 beads of glass, t = {time:.3g} s"), view)
    title.WindowLocation, title.Position = "Any Location", [0.03, 0.965]
    title.FontSize, title.Color = 30, [0.1, 0.1, 0.1]

    view.CameraPosition = [1.35, 0.11, 0.225]
    view.CameraFocalPoint = [0, 0.11, 0.225]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 20
    SaveScreenshot(png, view, ImageResolution=[1400, 1200])
    print(f"{png}: t = {time:g} s")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit("Usage: pvbatch picture.py FILE.png [time]")
    main(sys.argv[1], *(float(word) for word in sys.argv[2:]))
