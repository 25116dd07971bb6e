#------------------------------------------------------------------------------
#  Styx: rigid particles in OpenFOAM flows
#  Copyright (C) 2026 The Styx founders
#------------------------------------------------------------------------------
# License
#     This file is part of Styx, which is free software: GPL-3.0-or-later,
#     without any warranty. See the file COPYING.
#
# Description
#     What the benchmarks of doc/accuracy share: a ladder of runs by
#     styxAccuracy, its table and its plot.
#         rows = accuracy(case, "-quantity", "mean position z", "-knob", ...)
#         save("skin", "what the case is", "the columns", rows)
#         draw("skin", "x", "y", [("label", [(x, y, "text"), ...])])
#         seconds = timed(case, "demFoam")    of the processor, for one run
#------------------------------------------------------------------------------
import os
import subprocess

from cloudCase import runIn

styx = os.environ["STYX_DIR"]
pages = styx + "/doc/accuracy"
os.makedirs(pages, exist_ok=True)


def accuracy(case, *arguments):
    """Runs styxAccuracy; the rows of its table."""
    with open("log.accuracy." + os.path.basename(case), "a") as log:
        subprocess.run([styx + "/bin/styxAccuracy", "-case", case,
                        *arguments], stdout=log, stderr=log, check=True)
    with open(case + "/styxAccuracy/accuracy.dat") as stream:
        return [line.split() for line in stream if line[0] != "#"]


def timed(case, program):
    before = os.times()
    runIn(case, program)
    after = os.times()
    return (after.children_user + after.children_system
            - before.children_user - before.children_system)


def save(name, title, head, rows):
    with open("%s/%s.dat" % (pages, name), "w") as stream:
        stream.write("# %s\n# %s\n" % (title, head))
        for row in rows:
            stream.write(" ".join(str(w) for w in row) + "\n")


def draw(name, xLabel, yLabel, lines, logX=True, logY=True):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(6.5, 4.5))
    for label, points in lines:
        axes.plot([p[0] for p in points], [p[1] for p in points], "o-",
                  label=label)
        for p in points:
            axes.annotate(p[2], p[:2], textcoords="offset points",
                          xytext=(4, 4), fontsize=7)
    times = [p[0] for _, points in lines for p in points]
    if logX and max(times) > 5*min(times):
        axes.set_xscale("log")
    if logY:
        axes.set_yscale("log")
    axes.set_xlabel(xLabel)
    axes.set_ylabel(yLabel)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig("%s/%s.png" % (pages, name), dpi=110)
    plt.close(figure)
