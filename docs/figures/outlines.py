#!/usr/bin/python3
"""Draws a run's cells at COUNT (10) equally spaced times, with vessel and thrombi, as one SVG.

usage: docs/figures/outlines.py ARCHIVE.h5 OUT.svg [COUNT]

Needs python3-h5py alone. Lengths in the picture are micrometres.
"""
import json
import sys

import h5py
import numpy as np

MARGIN = 3.0
PIXELS_PER_MICROMETRE = 10


def vessel_svg(case):
    length = 1e6 * case["vessel"]["length"]
    height = 1e6 * case["vessel"]["diameter"]
    parts = [f'<rect width="{length:g}" height="{height:g}" fill="#fbf3df"/>']
    for thrombus in case.get("thrombi", []):
        x, r = 1e6 * thrombus["x"], 1e6 * thrombus["radius"]
        y, sweep = (0, 0) if thrombus["wall"] == "lower" else (height, 1)
        arc = f"M{x - r:g} {y:g} A{r:g} {r:g} 0 0 {sweep} {x + r:g} {y:g} Z"
        parts.append(f'<path d="{arc}" fill="#b08968"/>')
    for y in (0, height):
        parts.append(f'<line x2="{length:g}" y1="{y:g}" y2="{y:g}" stroke="#5c4a3d" stroke-width="0.25"/>')
    return length, height, parts


def outline_svg(nodes, shade):
    points = " ".join(f"{x:.3f},{y:.3f}" for x, y in 1e6 * nodes)
    style = f'fill="#c1121f" fill-opacity="{shade:.2f}" stroke="#780000" stroke-width="0.15"'
    return f'<polygon points="{points}" {style}/>'


def draw(archive, count):
    case = json.loads(archive["parameters/case_resolved"].asstr()[()])
    length, height, parts = vessel_svg(case)
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
    notes.append(f'<text x="{length:g}" y="{height + 2:g}" text-anchor="end">ms</text>')
    arrow = f"M1 {height / 2:g} h4 m-1.2 -0.7 l1.2 0.7 l-1.2 0.7"
    notes.append(f'<path d="{arrow}" fill="none" stroke="#5c4a3d" stroke-width="0.25"/>')
    notes.append(f'<text x="3" y="{height / 2 - 1:g}" text-anchor="middle">flow</text>')
    notes.append('<path d="M0 -0.9 v-0.6 h10 v0.6" fill="none" stroke="#333333" stroke-width="0.15"/>')
    notes.append('<text x="10.6" y="-0.9">10 µm</text>')
    width, tall = length + 2 * MARGIN, height + 2 * MARGIN
    # The picture's y runs downwards, the scene's upwards.
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS_PER_MICROMETRE * width:g}" '
            f'viewBox="{-MARGIN:g} {-MARGIN:g} {width:g} {tall:g}">',
            f'<rect x="{-MARGIN:g}" y="{-MARGIN:g}" width="{width:g}" height="{tall:g}" fill="#ffffff"/>',
            f'<g transform="translate(0 {height:g}) scale(1 -1)">',
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
