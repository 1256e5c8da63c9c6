#!/usr/bin/env pvpython
"""Opens an archive's XDMF sidecar in ParaView and checks what it sees. Not in CTest: ParaView is a large package.

    apt-get install --no-install-recommends paraview python3-paraview
    pvpython tests/storage/open_in_paraview.py OUT.xdmf
"""

import sys

from paraview.simple import XDMFReader, servermanager


def blocks_at(reader, time):
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    return [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]


reader = XDMFReader(FileNames=[sys.argv[1]])
reader.UpdatePipeline()
times = list(reader.TimestepValues)
assert times == sorted(times) and times, "no frames, or out of order"
missing = {"velocity", "pressure", "species", "alive", "cell", "id"} - set(reader.PointData.keys())
assert not missing, f"arrays missing: {missing}"

first, last = blocks_at(reader, times[0]), blocks_at(reader, times[-1])
for before, after in zip(first, last):
    assert before.GetNumberOfPoints() == after.GetNumberOfPoints() > 0
for before, after in zip(first[1:], last[1:]):
    assert after.GetBounds()[0] > before.GetBounds()[0], "a cell that did not move along the vessel"
print(f"{len(times)} frames, {first[0].GetNumberOfPoints()} particle slots, {len(first) - 1} cell outlines")
