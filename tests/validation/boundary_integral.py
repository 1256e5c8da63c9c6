#!/usr/bin/python3
"""References for an elastic ring in shear, by means that share nothing with the engine.

usage: tests/validation/boundary_integral.py SCENE...

For each SCENE, a ring among the references "elastic_ring_in_shear" of references.json, prints its deformation,
inclination over pi and perimeter over that at rest. Needs python3-numpy. Half a minute a ring.

The velocity of the ring in unbounded Stokes flow, the same fluid on both sides, is that of the shear and of the
line of forces that it exerts: u(x) = G y + 1/(4 pi mu) integral of (-ln r + r r / r^2) f ds (Pozrikidis, Boundary
Integral and Singularity Methods, 1992), by the trapezoidal rule; the node itself stands for -ln(h/(2 pi)), with
which the rule is of third order for a logarithm. Units: mu, G and the radius at rest.
"""
import json
import pathlib
import sys

import numpy as np

NODES = 64
DURATION = 10.0


def forces(z, stretch_modulus, bend_modulus, conservative):
    """Of the nodes on the fluid; tension E_s (stretch - 1), bending moment B times the curvature, or times the turn
    of the tangent per unstretched length, which is the derivative of an energy."""
    rest = 2 * np.pi / NODES
    link = np.roll(z, -1) - z
    before = np.roll(link, 1)
    tension = stretch_modulus * (abs(link) / rest - 1) * link / abs(link)
    turn = np.angle(link / before)
    length = rest if conservative else (abs(link) + abs(before)) / 2
    moment = bend_modulus * turn / length
    # The gradient of the turn by the node before, the node, and the one after.
    first, second = 1j * before / abs(before) ** 2, 1j * link / abs(link) ** 2
    bending = -np.roll(moment * first, -1) + moment * (first + second) - np.roll(moment * second, 1)
    return tension - np.roll(tension, 1) + bending


def velocities(z, force):
    length = (abs(np.roll(z, -1) - z) + abs(z - np.roll(z, 1))) / 2
    tangent = np.roll(z, -1) - np.roll(z, 1)
    apart = z[:, None] - z[None, :]
    distance = abs(apart)
    np.fill_diagonal(distance, length / (2 * np.pi))
    direction = apart / distance
    np.fill_diagonal(direction, tangent / abs(tangent))
    along = direction.real * force.real + direction.imag * force.imag
    return z.imag + (-np.log(distance) @ force + (direction * along).sum(axis=1)) / (4 * np.pi)


def steady_ring(capillary, bending, conservative):
    stretch_modulus, bend_modulus = 1 / capillary, bending / capillary
    z = np.exp(2j * np.pi * np.arange(NODES) / NODES)
    wave_number = NODES / 2
    step = min(0.02, 4.8 / (stretch_modulus * wave_number + bend_modulus * wave_number**3))
    for _ in range(round(DURATION / step)):
        middle = z + step / 2 * velocities(z, forces(z, stretch_modulus, bend_modulus, conservative))
        z = z + step * velocities(middle, forces(middle, stretch_modulus, bend_modulus, conservative))
        z = z - z.mean()
        # The trapezoidal rule loses a little area.
        z = z * np.sqrt(np.pi / (0.5 * np.sum((np.conj(z) * np.roll(z, -1)).imag)))
    return z


def seen(z):
    x, y = z.real, z.imag
    next_x, next_y = np.roll(x, -1), np.roll(y, -1)
    twice = x * next_y - next_x * y
    xx = (twice * (x * x + x * next_x + next_x * next_x)).sum() / 12
    yy = (twice * (y * y + y * next_y + next_y * next_y)).sum() / 12
    xy = (twice * (2 * x * y + x * next_y + next_x * y + 2 * next_x * next_y)).sum() / 24
    mean, half = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    longest, shortest = np.sqrt(mean + half), np.sqrt(mean - half)
    perimeter = abs(np.roll(z, -1) - z).sum() / (2 * np.pi)
    return (longest - shortest) / (longest + shortest), np.arctan2(2 * xy, xx - yy) / (2 * np.pi), perimeter


def main():
    path = pathlib.Path(__file__).with_name("references.json")
    rings = json.loads(path.read_text())["elastic_ring_in_shear"]
    for name in sys.argv[1:]:
        ring = rings[name]
        for law in ("",) if "conservative" not in ring else ("", ", conservative"):
            z = steady_ring(ring["Ca"], ring["Bn"], bool(law))
            print(f"{name}{law}: deformation %.4f, inclination %.4f, perimeter %.4f" % seen(z), flush=True)


if __name__ == "__main__":
    main()
