# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     A figure line of a test, from Python or as a command (see tests/README.md)
#         PASS|FAIL name: figure unit (bar, source)
# -----------------------------------------------------------------------------
"""Usage: figure.py name value low high unit source        ('-': no bar)
       figure.py -near name value expected relTol unit source"""

import math
import sys


def _print(passed, name, value, unit, bar, source):
    shown = f"{value:.6g}" if isinstance(value, (int, float)) else str(value)
    print(f"{'PASS' if passed else 'FAIL'} {name}: "
          f"{shown} {unit}".rstrip(), f"({bar}, {source})", flush=True)
    return passed


def figure(name, value, low, high, unit, source):
    """Prints the line; low or high may be None. A NaN fails."""
    value = float(value)
    low = -math.inf if low is None else float(low)
    high = math.inf if high is None else float(high)
    if low == high:
        bar = f"{low:.6g}"
    elif low == -math.inf:
        bar = f"at most {high:.6g}"
    elif high == math.inf:
        bar = f"at least {low:.6g}"
    else:
        bar = f"{low:.6g} to {high:.6g}"
    passed = low <= value <= high and math.isfinite(value)
    return _print(passed, name, value, unit, bar, source)


def figureNear(name, value, expected, relTol, unit, source):
    """Prints the line; the bar is |value - expected| <= relTol |expected|."""
    value, expected, relTol = float(value), float(expected), float(relTol)
    passed = abs(value - expected) <= relTol * abs(expected)
    bar = f"{expected:.6g} within {100 * relTol:.4g} %"
    return _print(passed, name, value, unit, bar, source)


def figureTrue(name, passed, found, bar, source):
    """Prints the line of a figure that is no number."""
    return _print(bool(passed), name, found, "", bar, source)


def _main(words):
    near = words[:1] == ["-near"]
    words = words[1:] if near else words
    if len(words) != 6:
        sys.exit(__doc__)
    number = [None if word == "-" else float(word) for word in words[1:4]]
    (figureNear if near else figure)(words[0], *number, words[4], words[5])


if __name__ == "__main__":
    _main(sys.argv[1:])
