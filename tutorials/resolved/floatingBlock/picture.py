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
#     Draws the case that it stands in: the block's spheres, the water and its
#     surface. Takes the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

import os
import sys

from paraview.simple import (
    CellDatatoPointData, Clip, Contour, CreateView, ExtractBlock, Glyph,
    OpenFOAMReader, Outline, SaveScreenshot, Show, Text)


def part(reader, selector):
    return ExtractBlock(Input=reader, Selectors=[selector])


def plain(shown, colour, opacity=1):
    shown.Representation = "Surface"
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = shown.AmbientColor = colour
    shown.Opacity = opacity
    return shown


def main(png, time=None):
    case = os.path.basename(os.getcwd()) + ".foam"
    open(case, "a").close()
    reader = OpenFOAMReader(FileName=case)
    if os.path.isdir("processor0"):
        reader.CaseType = "Decomposed Case"
    reader.MeshRegions = ["internalMesh", "lagrangian/demCloudSpheres"]
    reader.CellArrays = ["alpha.water"]
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    time = min(times, key=lambda t: abs(t - time)) if time else times[-1]

    view = CreateView("RenderView")
    view.ViewSize = [1600, 1200]
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background2 = [0.80, 0.87, 0.93]
    view.Background = [0.97, 0.98, 0.99]
    view.OrientationAxesVisibility = 0
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

    # The block
    spheres = Glyph(Input=part(reader, "/Root/lagrangian"),
                    GlyphType="Sphere")
    spheres.GlyphType.Radius = 0.5
    spheres.GlyphType.ThetaResolution = 48
    spheres.GlyphType.PhiResolution = 48
    spheres.ScaleArray = ["POINTS", "diameter"]
    spheres.ScaleFactor = 1
    spheres.GlyphMode = "All Points"
    wood = plain(Show(spheres, view), [0.72, 0.50, 0.28])
    wood.Specular, wood.SpecularPower = 0.15, 12

    title = Show(Text(Text="A block of half the density of water floats"), view)
    title.WindowLocation, title.Position = "Any Location", [0.03, 0.935]
    title.FontSize, title.Bold, title.Color = 34, 1, [0.08, 0.12, 0.18]
    line = Show(Text(Text=f"t = {time:.2f} s    interFoam, Styx"), view)
    line.WindowLocation, line.Position = "Any Location", [0.03, 0.895]
    line.FontSize, line.Color = 24, [0.25, 0.30, 0.36]

    view.CameraPosition = [0.20, -0.26, 0.115]
    view.CameraFocalPoint = [0.06, 0.06, 0.046]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 24
    SaveScreenshot(png, view, ImageResolution=[1600, 1200])
    print(f"{png}: t = {time:g} s")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit("Usage: pvbatch picture.py FILE.png [time]")
    main(sys.argv[1], *(float(word) for word in sys.argv[2:]))
