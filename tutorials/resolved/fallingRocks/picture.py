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
#     Draws the case that it stands in: the rocks with the surface that they
#     were made from, the water's speed and the refined mesh in a plane through
#     the pipe. Takes the written time next to the one named (else the last).
#     A rock's place is found from its spheres: the rotation and shift that
#     bring those of its template onto those in lagrangian/demCloudSpheres.
# -----------------------------------------------------------------------------

import re

import numpy
from paraview.simple import (
    ColorBy, FeatureEdges, GetColorTransferFunction, GetOpacityTransferFunction,
    GetScalarBar, Plane, Show, Slice, TrivialProducer)
from paraview.vtk import (
    vtkCellArray, vtkPoints, vtkPolyData, vtkUnsignedCharArray)
from paraview.vtk.numpy_interface import dataset_adapter
from paraview.servermanager import Fetch
from styxScene import headings, openCase, part, plain, run, save

SLICE_Y = 0.012         # between the pipe's axis and its rear wall [m]
TOP_SPEED = 0.8         # where the colours end [m/s]
STONES = ((0.55, 0.50, 0.44), (0.62, 0.57, 0.50), (0.47, 0.45, 0.43),
          (0.66, 0.60, 0.48), (0.52, 0.46, 0.40))


def readTemplate(file):
    """Centres of the template's spheres, in the frame of its surface."""
    number = r"\s*([-+.\deE]+)\s*"
    with open(file) as stream:
        text = stream.read()
    text = text[text.index("spheres"):]
    found = re.findall(r"\(\s*\(" + r"\s".join([number]*3) + r"\)" + number
                       + r"\)", text)
    return numpy.array(found, dtype=float)[:, :3]


def readSurface(file):
    """Corners of the triangles of an ASCII STL, three by three."""
    with open(file) as stream:
        corners = [line.split()[1:] for line in stream if "vertex" in line]
    return numpy.array(corners, dtype=float)


def rigidMotion(source, target):
    """Rotation and shift that bring points onto others (Kabsch 1976)."""
    a, b = source.mean(axis=0), target.mean(axis=0)
    u, _, vt = numpy.linalg.svd((source - a).T @ (target - b))
    mirror = numpy.sign(numpy.linalg.det(u @ vt))
    rotation = vt.T @ numpy.diag([1, 1, mirror]) @ u.T
    return rotation, b - rotation @ a


def posedRocks(cloud, template, surface):
    """One surface of all rocks, a colour each."""
    data = dataset_adapter.WrapDataObject(cloud)
    points = numpy.asarray(data.Points)
    body = numpy.asarray(data.PointData["body"]).astype(int)
    corners, colours = vtkPoints(), vtkUnsignedCharArray()
    faces = vtkCellArray()
    colours.SetNumberOfComponents(3)
    colours.SetName("stone")
    for label in numpy.unique(body):
        rotation, shift = rigidMotion(template, points[body == label])
        stone = [int(255*c) for c in STONES[label % len(STONES)]]
        for n, corner in enumerate(surface @ rotation.T + shift):
            index = corners.InsertNextPoint(corner)
            if n % 3 == 0:
                faces.InsertNextCell(3)
                colours.InsertNextTuple3(*stone)
            faces.InsertCellPoint(index)
    rocks = vtkPolyData()
    rocks.SetPoints(corners)
    rocks.SetPolys(faces)
    rocks.GetCellData().SetScalars(colours)
    return rocks, len(numpy.unique(body))


def main(png, time=None):
    reader, view, time = openCase((1600, 1200), "lagrangian/demCloudSpheres",
                                  time, sky=True)
    reader.MeshRegions = ["internalMesh", "patch/tank", "patch/pipe",
                          "lagrangian/demCloudSpheres"]
    reader.CellArrays = ["U"]
    reader.Decomposepolyhedra = 0
    reader.UpdatePipeline(time)

    # The water: its speed and the mesh, in a plane
    plane = Slice(Input=part(reader, "/Root/internalMesh"))
    plane.SliceType.Origin = [0, SLICE_Y, 0]
    plane.SliceType.Normal = [0, 1, 0]
    plane.Triangulatetheslice = 0
    shown = Show(plane, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.22, 0.32, 0.42]
    shown.LineWidth = 0.6
    shown.Ambient, shown.Diffuse = 0.9, 0.1
    ColorBy(shown, ("CELLS", "U", "Magnitude"))
    speed = GetColorTransferFunction("U")
    speed.RGBPoints = [
        0.00*TOP_SPEED, 0.90, 0.95, 0.98, 0.10*TOP_SPEED, 0.66, 0.84, 0.92,
        0.35*TOP_SPEED, 0.20, 0.58, 0.78, 0.70*TOP_SPEED, 0.05, 0.27, 0.55,
        1.00*TOP_SPEED, 0.02, 0.07, 0.28]
    speed.ColorSpace = "RGB"
    speed.EnableOpacityMapping = 1      # no rock is hidden
    GetOpacityTransferFunction("U").Points = [
        0, 0.6, 0.5, 0, TOP_SPEED, 0.75, 0.5, 0]
    bar = GetScalarBar(speed, view)
    bar.Title, bar.ComponentTitle = "water: speed [m/s]", ""
    bar.WindowLocation = "Any Location"
    bar.Position = [0.90, 0.30]
    bar.ScalarBarLength = 0.4
    bar.TitleColor = bar.LabelColor = [0.1, 0.15, 0.2]
    bar.TitleFontSize, bar.LabelFontSize = 20, 18
    bar.UseCustomLabels = 1
    bar.CustomLabels = [0.25*n*TOP_SPEED for n in range(5)]
    bar.AddRangeLabels = 0
    bar.RangeLabelFormat = bar.LabelFormat = "%.1f"
    shown.SetScalarBarVisibility(view, True)

    # The walls: their edges, the bed, and the pipe as if of glass
    for name, colour, width in (("tank", [0.30, 0.34, 0.38], 2),
                                ("pipe", [0.55, 0.30, 0.12], 3)):
        edges = FeatureEdges(Input=part(reader, "/Root/boundary/" + name))
        edges.FeatureAngle = 60
        plain(Show(edges, view), colour).LineWidth = width
    glass = plain(Show(part(reader, "/Root/boundary/pipe"), view),
                  [0.80, 0.50, 0.28])
    glass.Opacity = 0.10
    tank = part(reader, "/Root/boundary/tank")
    tank.UpdatePipeline(time)
    x0, x1, y0, y1, z0, _ = tank.GetDataInformation().GetBounds()
    bed = Plane(Origin=[x0, y0, z0 - 1e-4], Point1=[x1, y0, z0 - 1e-4],
                Point2=[x0, y1, z0 - 1e-4])
    plain(Show(bed, view), [0.86, 0.80, 0.66]).Specular = 0

    # The rocks
    spheres = Fetch(part(reader, "/Root/lagrangian"))
    while spheres.IsA("vtkMultiBlockDataSet"):
        spheres = spheres.GetBlock(0)
    rocks, count = posedRocks(spheres, readTemplate("constant/rock.multisphere"),
                              readSurface("constant/rock.stl"))
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(rocks)
    drawn = Show(producer, view)
    drawn.Representation = "Surface"
    ColorBy(drawn, ("CELLS", "stone"))
    drawn.MapScalars = 0
    drawn.Specular, drawn.SpecularPower = 0.15, 12
    drawn.Interpolation = "Flat"

    headings("Rocks fall through a pipe to the bed of a tank",
             f"t = {time:.2f} s    {count} rocks    pimpleFoam, Styx", view)
    save(png, view, [-0.42, -1.25, 0.60], [0.008, 0, 0.190], 24)


run(main)
