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
#     Draws the beads by their velocity upwards, and beside them the void
#     fraction, at the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

from paraview.simple import (
    ExtractBlock, Outline, Show, Transform)
from styxScene import balls, coloured, heading, openCase, run, save


def main(png, time=None):
    reader, view, time = openCase((1400, 1200), "lagrangian/demCloud", time)
    beads = balls(ExtractBlock(Input=reader, Selectors=["/Root/lagrangian"]),
                  0.0025)
    coloured(Show(beads, view), view, ("POINTS", "velocity"), "Z", (-0.5, 0.5),
             "Cool to Warm", "velocity upwards [m/s]", [0.87, 0.55])

    mesh = ExtractBlock(Input=reader, Selectors=["/Root/internalMesh"])
    aside = Transform(Input=mesh)
    aside.Transform.Translate = [0, 0.18, 0]
    coloured(Show(aside, view), view, ("CELLS", "voidFraction"), "", (0.4, 1),
             "Viridis (matplotlib)", "void fraction [-]", [0.87, 0.15])
    Show(Outline(Input=mesh), view).DiffuseColor = [0.3, 0.3, 0.3]

    heading(f"24,750 beads of glass, t = {time:.3g} s", view, (0.03, 0.965))

    save(png, view, [1.35, 0.11, 0.225], [0, 0.11, 0.225], 20)


run(main)
