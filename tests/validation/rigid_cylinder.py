#!/usr/bin/python3
"""References for a rigid cylinder that floats in plane Poiseuille flow, by means that share nothing with the engine.

usage: tests/validation/rigid_cylinder.py

For each entry of "rigid_cylinder_in_channel" in references.json prints the extra drop of pressure in mu U/H and the
cylinder's velocity over U. Needs python3-numpy. A few seconds.

The disturbance of the flow is that of point forces (Stokeslets) inside the cylinder and behind the walls, such that it
vanishes on the walls and, three heights away, across the channel, and with the Poiseuille flow makes a rigid motion on
the cylinder, which feels neither force nor torque: the method of fundamental solutions, by least squares. The extra drop
of pressure is, by the reciprocal theorem, minus the sum of force times Poiseuille velocity over the forces inside the
cylinder. A small cylinder beside the axis has 2 pi (a G)^2, G the shear rate there (Einstein's viscosity in two
dimensions, 1 + 2 phi); one on the axis 72 pi a^4. Units: mu, the height H and the mean velocity U.
"""
import json
import pathlib

import numpy as np

LENGTH = 3.0  # of the channel on either side
BEHIND = 0.2  # the walls, where the forces are
WALL_FORCES = 16  # per height; twice as many points on the walls
CYLINDER_POINTS = 160  # half as many forces
DEPTH = 0.6  # of the forces in the cylinder, over its radius


def frame(offset, per_height):
    """Points around the channel, at a distance behind its walls."""
    h = 1 / per_height
    x = np.arange(-LENGTH - offset + h / 2, LENGTH + offset, h)
    y = np.arange(-offset + h / 2, 1 + offset, h)
    return np.concatenate(
        [np.c_[x, 0 * x - offset], np.c_[x, 0 * x + 1 + offset], np.c_[0 * y - LENGTH - offset, y],
         np.c_[0 * y + LENGTH + offset, y]])


def stokeslets(points, sources):
    r = points[:, None, :] - sources[None, :, :]
    r2 = (r**2).sum(axis=-1)
    matrix = np.zeros((len(points), 2, len(sources), 2))
    for i in range(2):
        for j in range(2):
            matrix[:, i, :, j] = (r[..., i] * r[..., j] / r2 - (i == j) * 0.5 * np.log(r2)) / (4 * np.pi)
    return matrix.reshape(2 * len(points), 2 * len(sources))


def poiseuille(y):
    return 6 * y * (1 - y)


def floating(radius, y):
    angle = 2 * np.pi * (np.arange(CYLINDER_POINTS) + 0.5) / CYLINDER_POINTS
    circle = np.c_[np.cos(angle), np.sin(angle)]
    surface = radius * circle + [0, y]
    inside = DEPTH * radius * circle[::2] + [0, y]
    matrix = stokeslets(np.concatenate([surface, frame(0, 2 * WALL_FORCES)]),
                        np.concatenate([inside, frame(BEHIND, WALL_FORCES)]))
    forces, on_surface = matrix.shape[1], 2 * len(surface)
    # Beside the forces the cylinder's velocity along and across and its rotation; no force, no torque.
    system = np.zeros((len(matrix) + 3, forces + 3))
    system[:-3, :forces] = matrix
    system[0:on_surface:2, -3] = system[1:on_surface:2, -2] = -1
    system[0:on_surface:2, -1] = surface[:, 1] - y
    system[1:on_surface:2, -1] = -surface[:, 0]
    n = 2 * len(inside)
    system[-3, 0:n:2] = system[-2, 1:n:2] = 1
    system[-1, 0:n:2] = y - inside[:, 1]
    system[-1, 1:n:2] = inside[:, 0]
    right = np.zeros(len(system))
    right[0:on_surface:2] = -poiseuille(surface[:, 1])
    found = np.linalg.lstsq(system, right, rcond=1e-14)[0]
    return -(found[0:n:2] * poiseuille(inside[:, 1])).sum(), found[-3]


def main():
    path = pathlib.Path(__file__).with_name("references.json")
    for name, entry in json.loads(path.read_text())["rigid_cylinder_in_channel"].items():
        if isinstance(entry, dict):
            print(name + ": extra pressure drop %.5f, velocity %.5f" % floating(entry["radius"], entry["y"]))


if __name__ == "__main__":
    main()
