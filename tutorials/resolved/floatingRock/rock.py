# -----------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
# -----------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     The triangles of the rock where it is at a written time, for draft and for
#     the picture.
# -----------------------------------------------------------------------------
import numpy as np


def numbers(file, columns):
    """The first row of a list; those of one value alone are in braces."""
    with open(file) as text:
        lines = text.read().split("// * *")[-1].split("\n", 1)[1]
    for sign in "(){}":
        lines = lines.replace(sign, " ")
    values = [float(x) for x in lines.split() if x[0] in "-0123456789"]
    return np.array(values[1:1 + columns])


def triangles(file):
    with open(file) as stl:
        corners = [[float(x) for x in line.split()[1:]]
                   for line in stl if line.split()[0] == "vertex"]
    return np.array(corners).reshape(-1, 3, 3)


def centred(rock):
    """About the centre of mass, and the volume."""
    parts = np.einsum("ij,ij->i", rock[:, 0],
                      np.cross(rock[:, 1], rock[:, 2]))/6
    centre = (parts[:, None]*rock.sum(axis=1)/4).sum(axis=0)/parts.sum()
    return rock - centre, parts.sum()


def turned(points, v, w):
    """By the quaternion with the vector v and the scalar w."""
    t = 2*np.cross(v, points)
    return points + w*t + np.cross(v, t)


def placed(time):
    """Its triangles at a time, the centre of mass and the volume."""
    cloud = time + "/lagrangian/demCloud/"
    own, volume = centred(triangles("constant/rock.stl"))
    centre = numbers(cloud + "positions", 3)
    return centre + turned(own, numbers(cloud + "orientation", 3),
                           numbers(cloud + "orientationW", 1)[0]), \
        centre, volume
