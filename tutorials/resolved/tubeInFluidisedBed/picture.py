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
#     Draws the grains of the half behind the tube's axis by their velocity
#     upwards, the tube, and beside them the void fraction in the plane of the
#     axis, at the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

from paraview.simple import (
    Calculator, ColorBy, ExtractBlock, Outline, Show, Slice,
    Threshold, Transform)
from styxScene import balls, coloured, heading, openCase, run, save


def kind(spheres, behind, low, high):
    """Spheres of a diameter; of grains those behind the axis."""
    test = f"(diameter > {low}) * (diameter < {high})"
    if not behind:
        test += " * (coordsY > 0.025)"
    chosen = Calculator(Input=spheres, Function=test, ResultArrayName="chosen")
    part = Threshold(Input=chosen, Scalars=["POINTS", "chosen"])
    part.LowerThreshold, part.UpperThreshold = 0.5, 1.5
    return part


def main(png, time=None):
    reader, view, time = openCase((1300, 1300), "lagrangian/demCloudSpheres",
                                  time)
    spheres = ExtractBlock(Input=reader, Selectors=["/Root/lagrangian"])
    grains = balls(kind(spheres, 0, 0.00249, 0.00251), 0.0025)
    tube = balls(kind(spheres, 1, 0.019, 0.021), 0.02)
    coloured(Show(grains, view), view, ("POINTS", "velocity"), "Z", (-0.3, 0.3),
             "Cool to Warm", "velocity upwards [m/s]", [0.86, 0.55])
    shown = Show(tube, view)
    ColorBy(shown, None)
    shown.DiffuseColor = [0.95, 0.75, 0.2]

    mesh = ExtractBlock(Input=reader, Selectors=["/Root/internalMesh"])
    plane = Slice(Input=mesh)
    plane.SliceType.Origin = [0.025, 0.0251, 0]
    plane.SliceType.Normal = [0, 1, 0]
    aside = Transform(Input=plane)
    aside.Transform.Translate = [0.06, 0, 0]
    coloured(Show(aside, view), view, ("CELLS", "voidFraction"), "", (0.4, 1),
             "Viridis (matplotlib)", "void fraction [-]", [0.86, 0.15])
    Show(Outline(Input=mesh), view).DiffuseColor = [0.3, 0.3, 0.3]

    heading(f"A tube in a fluidised bed, t = {time:.3g} s", view)

    save(png, view, [0.062, -0.49, 0.095], [0.062, 0.025, 0.078], 20)


run(main)
