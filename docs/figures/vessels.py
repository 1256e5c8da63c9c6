#!/usr/bin/python3
"""Draws the vessels of cases, one beneath another, as one SVG.

usage: docs/figures/vessels.py CASE.json... OUT.svg

Needs python3 alone. Lengths in the picture are micrometres.
"""
import json
import math
import sys

MARGIN = 3.0
TITLE = 6.0
PIXELS_PER_MICROMETRE = 5
WALL = 'fill="none" stroke="#5c4a3d" stroke-width="0.25"'
PLANE = 'fill="none" stroke="#2a6f97" stroke-width="0.2" stroke-dasharray="1.2 0.8"'


def parallel_walls(length, height, ends):
    a, b, c, d = (0, 0), (length, 0), (length, height), (0, height)
    if ends == "closed":
        return [[a, b, c, d, a]], []
    return [[a, b], [c, d]], [[d, a], [b, c]]


def bifurcation(vessel):
    """Walls and planes; the inner walls run beside the outer ones and meet in the apex."""
    length, height = 1e6 * vessel["trunk"]["length"], 1e6 * vessel["trunk"]["diameter"]
    given = vessel["branches"]
    lower, upper = given if isinstance(given, list) else (given, given)
    angle = math.radians(vessel.get("half_angle", 30))
    c, s = math.cos(angle), math.sin(angle)

    def ends(branch, corner, up):
        span, width = 1e6 * branch["length"], 1e6 * branch["diameter"]
        outer = (corner[0] + span * c, corner[1] + up * span * s)
        return outer, (outer[0] + width * s, outer[1] - up * width * c)

    lower_outer, lower_inner = ends(lower, (length, 0), -1)
    upper_outer, upper_inner = ends(upper, (length, height), 1)
    # The lower inner wall falls by tan(angle), the upper one rises by it.
    slope = s / c
    x = (lower_inner[0] + upper_inner[0] - (upper_inner[1] - lower_inner[1]) / slope) / 2
    apex = (x, lower_inner[1] + (lower_inner[0] - x) * slope)
    walls = [
        [(0, 0), (length, 0), lower_outer],
        [lower_inner, apex, upper_inner],
        [upper_outer, (length, height), (0, height)],
    ]
    return walls, [[(0, height), (0, 0)], [lower_outer, lower_inner], [upper_inner, upper_outer]]


def walls_and_planes(vessel):
    """Walls with the fluid on their left, and the planes that join their ends, all as lists of points."""
    shape = vessel.get("shape", "straight")
    if shape == "bifurcation":
        return bifurcation(vessel)
    if shape == "box":
        size, ends = (vessel["width"], vessel["height"]), vessel.get("ends", "closed")
        walls, planes = parallel_walls(1e6 * size[0], 1e6 * size[1], ends)
        return ([], walls + planes) if ends == "periodic" else (walls, planes)
    return parallel_walls(1e6 * vessel["length"], 1e6 * vessel["diameter"], vessel.get("ends", "open"))


def thrombus_arc(thrombus, walls):
    """A semicircle on the outer wall at the thrombus's x, as an SVG path."""
    x, radius = 1e6 * thrombus["x"], 1e6 * thrombus["radius"]
    wall = walls[0] if thrombus["wall"] == "lower" else walls[-1]
    for (x0, y0), (x1, y1) in zip(wall, wall[1:]):
        if min(x0, x1) <= x <= max(x0, x1):
            y, span = y0 + (y1 - y0) * (x - x0) / (x1 - x0), math.hypot(x1 - x0, y1 - y0)
            dx, dy = radius * (x1 - x0) / span, radius * (y1 - y0) / span
            start, end = f"{x - dx:g} {y - dy:g}", f"{x + dx:g} {y + dy:g}"
            return f"M{start} A{radius:g} {radius:g} 0 0 0 {end} Z"
    raise ValueError(f"the thrombus at {x:g} um stands on no wall")


def vessel_svg(case):
    """The vessel's bounds (x0, y0, x1, y1) and its drawing, y upwards."""
    walls, planes = walls_and_planes(case["vessel"])
    around = [point for line in (walls or planes) for point in line]
    bounds = [f(point[k] for point in around) for f in (min, max) for k in (0, 1)]

    def line(points, style):
        return f'<polyline points="{" ".join(f"{x:g},{y:g}" for x, y in points)}" {style}/>'

    parts = [line(around, 'fill="#fbf3df"')]
    for thrombus in case.get("thrombi", []):
        parts.append(f'<path d="{thrombus_arc(thrombus, walls)}" fill="#b08968"/>')
    parts += [line(wall, WALL) for wall in walls] + [line(plane, PLANE) for plane in planes]
    return bounds, parts


def draw(cases):
    drawings, top, width = [], 0.0, 0.0
    for case in cases:
        (x0, y0, x1, y1), parts = vessel_svg(case)
        title = f'<text x="{x0:g}" y="-1.5">{case.get("name", "")}</text>'
        upright = f'<g transform="translate(0 {y1:g}) scale(1 -1)">'
        drawings += [f'<g transform="translate({-x0:g} {top + TITLE:g})">', title, upright, *parts, "</g></g>"]
        top += TITLE + y1 - y0
        width = max(width, x1 - x0)
    w, h = width + 2 * MARGIN, top + 2 * MARGIN
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{PIXELS_PER_MICROMETRE * w:g}" '
            f'viewBox="{-MARGIN:g} {-MARGIN:g} {w:g} {h:g}" font-family="sans-serif" font-size="3">',
            f'<rect x="{-MARGIN:g}" y="{-MARGIN:g}" width="{w:g}" height="{h:g}" fill="#ffffff"/>',
            *drawings,
            "</svg>",
            "",
        ]
    )


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    cases = []
    for path in sys.argv[1:-1]:
        with open(path) as file:
            cases.append(json.load(file))
    with open(sys.argv[-1], "w") as out:
        out.write(draw(cases))


if __name__ == "__main__":
    main()
