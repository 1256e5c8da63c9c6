#!/usr/bin/python3
"""References for two vesicles that adhere to one another, by means that share nothing with the engine.

usage: tests/validation/adhering_vesicles.py ALPHA ADHESION...

Prints for vesicles of the reduced area ALPHA, and each adhesion energy w R^2/B of the pair (B the bending modulus,
R the radius of the circle with their perimeter), the shape that minimises bending energy less w times the length of
contact: the length of contact, the width (across the contact) and the height of one vesicle, and the curvature at the
edge of the contact times R. Half a second each.

Seifert, Phys. Rev. A 43, 6803 (1991): in two dimensions, with a potential of no range. By symmetry each of two
equal vesicles sits on a flat wall with half of the energy. Its free part has kappa'' = -kappa^3/2 + sigma kappa - p
(B = 1), begins tangentially to the wall with the curvature sqrt(2 (w/2)/B) (Seifert and Lipowsky, Phys. Rev. A 42,
4768 (1990)) and ends at the top, where the shape is symmetric: five unknowns, kappa' at the edge, sigma, p, the length
of the free part and that of contact, by shooting and Newton's method. Units: B and R.
"""
import math
import sys

STEPS = 400


def arc(edge_curvature, unknowns):
    """The end of the free part, from the edge of the contact to the top: x, y, angle, curvature, its slope, area."""
    slope, sigma, p, length, contact = unknowns

    def rate(state):
        x, y, angle, curvature, turn, _ = state
        return (
            math.cos(angle),
            math.sin(angle),
            curvature,
            turn,
            -(curvature**3) / 2 + sigma * curvature - p,
            (x * math.sin(angle) - y * math.cos(angle)) / 2,
        )

    state = (contact / 2, 0.0, 0.0, edge_curvature, slope, 0.0)
    h = length / STEPS
    widest = state[0]
    for _ in range(STEPS):
        k1 = rate(state)
        k2 = rate([s + h / 2 * k for s, k in zip(state, k1)])
        k3 = rate([s + h / 2 * k for s, k in zip(state, k2)])
        k4 = rate([s + h * k for s, k in zip(state, k3)])
        state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
        widest = max(widest, state[0])
    return state, widest


def residual(alpha, edge_curvature, unknowns):
    (x, _, angle, _, turn, area), _ = arc(edge_curvature, unknowns)
    half = unknowns[4] / 2 + unknowns[3]
    return [x, angle - math.pi, turn, half - math.pi, 2 * area - alpha * math.pi]


def solve(matrix, right):
    n = len(right)
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    for k in reversed(range(n)):
        rows[k][n] = (rows[k][n] - sum(rows[k][j] * rows[j][n] for j in range(k + 1, n))) / rows[k][k]
    return [row[n] for row in rows]


def newton(alpha, edge_curvature, unknowns):
    for _ in range(60):
        here = residual(alpha, edge_curvature, unknowns)
        size = max(map(abs, here))
        if size < 1e-10:
            return unknowns
        columns = []
        for k in range(5):
            moved = list(unknowns)
            moved[k] += 1e-6
            columns.append([(a - b) / 1e-6 for a, b in zip(residual(alpha, edge_curvature, moved), here)])
        step = solve([list(row) for row in zip(*columns)], here)
        share = min(1.0, 0.3 / max(map(abs, step)))
        unknowns = [u - share * s for u, s in zip(unknowns, step)]
    raise ArithmeticError("no convergence")


def main():
    alpha, adhesions = float(sys.argv[1]), sorted(map(float, sys.argv[2:]))
    # From a circle that just touches the wall, nearly: more area is taken out and adhesion added step by step.
    unknowns, at_alpha, at_curvature = [0.0, 0.5, 0.0, math.pi * 0.95, 0.1 * math.pi], 0.99, 1.1
    unknowns = newton(at_alpha, at_curvature, unknowns)
    for adhesion in adhesions:
        goal = math.sqrt(adhesion)
        while (at_alpha, at_curvature) != (alpha, goal):
            at_alpha = max(alpha, at_alpha - 0.005)
            at_curvature = min(goal, at_curvature + 0.02) if at_alpha == alpha else at_curvature
            unknowns = newton(at_alpha, at_curvature, unknowns)
        (_, height, *_), widest = arc(goal, unknowns)
        print(
            f"w R^2/B {adhesion}: contact {unknowns[4]:.4f} R, across {height:.4f} R, along {2 * widest:.4f} R,"
            f" edge curvature {goal:.4f}/R"
        )


if __name__ == "__main__":
    main()
