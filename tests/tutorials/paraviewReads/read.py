#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Usage
#     xvfb-run -a pvbatch read.py CASE ...
#
# Description
#     What ParaView sees at the last time of each case, to the file read.json:
#     points and velocities of both clouds by OpenFOAM's reader, and of both
#     .vtp files by their collections.
#------------------------------------------------------------------------------
import json
import os
import sys

import numpy
from paraview.simple import OpenFOAMReader, PVDReader
from paraview.servermanager import Fetch
from paraview.vtk.numpy_interface import dataset_adapter


def leaves(data):
    """The data sets in blocks of blocks."""
    if data is None:
        return []
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    return [leaf for k in range(data.GetNumberOfBlocks())
            for leaf in leaves(data.GetBlock(k))]


def seen(source, time, field):
    """Of the data sets that have a field."""
    source.UpdatePipeline(time)
    points, velocity = [], []
    for leaf in leaves(Fetch(source)):
        if leaf.GetPointData().HasArray(field) and leaf.GetNumberOfPoints():
            data = dataset_adapter.WrapDataObject(leaf)
            points += numpy.asarray(data.Points, float).tolist()
            velocity += numpy.asarray(
                data.PointData["velocity"], float).tolist()
    return {"points": points, "velocity": velocity}


found = {}
for case in sys.argv[1:]:
    found[case] = {}
    for cloud, field in (("demCloud", "id"), ("demCloudSpheres", "body")):
        series = PVDReader(FileName=os.path.abspath(
            "%s/postProcessing/demCloud/%s.pvd" % (case, cloud)))
        times = list(series.TimestepValues)
        found[case]["times"] = times
        found[case][cloud + ".vtp"] = seen(series, times[-1], field)

        file = os.path.abspath("%s/%s.foam" % (case, case))
        open(file, "a").close()
        reader = OpenFOAMReader(FileName=file)
        if os.path.isdir(case + "/processor0"):
            reader.CaseType = "Decomposed Case"
        # Of a decomposed case ParaView 5.11 shows all clouds, if any
        reader.MeshRegions = ["lagrangian/" + cloud]
        reader.UpdatePipelineInformation()
        found[case][cloud] = seen(
            reader, list(reader.TimestepValues)[-1], field)

with open("read.json", "w") as out:
    json.dump(found, out)
