#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     Runs of the tutorial resolved/draftingKissingTumbling.
#         found, log = draft(endTime="1")
#             a dictionary of its results, and the solver's log
#------------------------------------------------------------------------------
import os
import subprocess

from cases import setEntry
from cloudCase import copyCase


def draft(endTime=None):
    case = copyCase(os.environ["STYX_DIR"]
                    + "/tutorials/resolved/draftingKissingTumbling", "pair")
    subprocess.check_call(["./Allclean"], cwd=case)
    if endTime:
        setEntry(case + "/system/controlDict", "endTime", endTime)
    subprocess.check_call(["./Allrun"], cwd=case)
    out = subprocess.check_output(["./results"], cwd=case).decode()
    found = {name: float(value) for name, value in
             (row.split() for row in out.splitlines())}
    return found, case + "/log.pimpleFoam"
