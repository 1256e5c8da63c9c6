#!/usr/bin/python3
"""Draws a run's cells at COUNT (10) equally spaced times, with vessel and thrombi, as one SVG.

usage: docs/figures/outlines.py ARCHIVE.h5 OUT.svg [COUNT]

Needs python3-h5py alone; vessels.py draws the vessel. Lengths in the picture are micrometres.
"""
import json
import sys

import h5py
import numpy as np

from vessels import vessel_svg

MARGIN = 3.0
PIXELS_PER_MICROMETRE = 10


def outline_svg(nodes, shade):
    points = " ".join(f"{x:.3f},{y:.3f}" for x, y in 1e6 * nodes)
    style = f'fill="#c1121f" fill-opacity="{shade:.2f}" stroke="#780000" stroke-width="0.15"'
    return f'<polygon points="{points}" {style}/>'


def draw(archive, count):
    case = json.loads(archive["parameters/case_resolved"].asstr()[()])
    (x0, y0, x1, y1), parts = vessel_svg(case)
    height = y1 - y0
    marks = []
    for name in sorted(archive.get("outlines", {})):
        outline = archive["outlines"][name]
        times = outline["time"][:]
        for time in np.linspace(times[0], times[-1], count):
            frame = int(np.argmin(abs(times - time)))
            nodes = outline["value"][frame]
            parts.append(outline_svg(nodes, 0.15 + 0.35 * time / times[-1]))
            marks.append((1e6 * (nodes[:, 0].min() + nodes[:, 0].max()) / 2, 1e3 * times[frame]))
    notes = [f'<text x="{x:.2f}" y="{height + 2:g}" text-anchor="middle">{ms:.1f}</text>' for x, ms in marks]
    notes.append(f'<text x="{x1:g}" y="{height + 2:g}" text-anchor="end">ms</text>')
    if case["vessel"].get("ends", "open") == "open" and case["vessel"].get("shape") != "box":
        trunk = case["vessel"].get("trunk", case["vessel"])
        axis = y1 - 1e6 * trunk["diameter"] / 2
        arrow = f"M1 {axis:g} h4 m-1.2 -0.7 l1.2 0.7 l-1.2 0.7"
        notes.append(f'<path d="{arrow}" fill="none" stroke="#5c4a3d" stroke-width="0.25"/>')
        notes.append(f'<text x="3" y="{axis - 1:g}" text-anchor="middle">flow</text>')
    notes.append('<path d="M0 -0.9 v-0.6 h10 v0.6" fill="none" stroke="#333333" stroke-width="0.15"/>')
    notes.append('<text x="10.6" y="-0.9">10 µm</text>')
    width, tall = x1 - x0 + 2 * MARGIN, height + 2 * MARGIN
    # The picture's y runs downwards, the scene's upwards.
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS_PER_MICROMETRE * width:g}" '
            f'viewBox="{x0 - MARGIN:g} {-MARGIN:g} {width:g} {tall:g}">',
            f'<rect x="{x0 - MARGIN:g}" y="{-MARGIN:g}" width="{width:g}" height="{tall:g}" fill="#ffffff"/>',
            f'<g transform="translate(0 {y1:g}) scale(1 -1)">',
            *parts,
            '</g>',
            '<g font-family="sans-serif" font-size="1.5" fill="#333333">',
            *notes,
            '</g>',
            '</svg>',
            '',
        ]
    )


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    count = int(sys.argv[3]) if len(sys.argv) == 4 else 10
    with h5py.File(sys.argv[1], "r") as archive, open(sys.argv[2], "w") as out:
        out.write(draw(archive, count))


if __name__ == "__main__":
    main()
