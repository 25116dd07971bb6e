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
#     Draws the grains by their velocity along the stream, and behind them the
#     water's, at the written time next to the one named (else the last).
# -----------------------------------------------------------------------------

from paraview.simple import (
    ExtractBlock, Show, Slice, Transform)
from styxScene import balls, coloured, heading, openCase, run, save


def main(png, time=None):
    reader, view, time = openCase((1400, 900), "lagrangian/demCloud", time)
    grains = balls(ExtractBlock(Input=reader, Selectors=["/Root/lagrangian"]),
                   0.001)
    coloured(Show(grains, view), view, ("POINTS", "velocity"), "X", (0, 0.5),
             "Inferno (matplotlib)", "grains, along the stream [m/s]",
             [0.12, 0.06], horizontal=True)

    cut = Slice(Input=ExtractBlock(Input=reader,
                                   Selectors=["/Root/internalMesh"]))
    cut.SliceType.Origin = [0.024, 0.0119, 0.012]
    cut.SliceType.Normal = [0, 1, 0]
    behind = Transform(Input=cut)
    behind.Transform.Translate = [0, 0.001, 0]
    coloured(Show(behind, view), view, ("CELLS", "U"), "X", (0, 1),
             "Blues", "water, along the stream [m/s]", [0.6, 0.06],
             horizontal=True)

    heading(f"2,970 grains of sand, {time - 0.2:.3g} s after the current has"
            " come", view, (0.03, 0.95), 26)

    save(png, view, [0.024, -0.11, 0.035], [0.024, 0.006, 0.0095], 20)


run(main)
