"""The scenes of deploy/reproduce plan: those from which the model of cost and error was made, and others that it
has not seen. All are short: a run takes a few seconds, its reference with half of the spacing ten times as long."""

UM = 1e-6


def scene(length, diameter, duration, **parts):
    vessel = {"shape": "straight", "length": length * UM, "diameter": diameter * UM, **parts.pop("vessel", {})}
    return {"version": 1, "vessel": vessel, "duration": duration,
            "output": {"series_interval": duration / 40, "frame_interval": duration / 4}, **parts}


def bump(x, radius, wall="lower"):
    return {"wall": wall, "x": x * UM, "radius": radius * UM}


def cell(x, y, **parts):
    return {"x": x * UM, "y": y * UM, **parts}


def branching(trunk, lower, upper, duration, **parts):
    (length, diameter), (lower_length, lower_diameter), (upper_length, upper_diameter) = trunk, lower, upper
    return scene(length, diameter, duration, **parts) | {"vessel": {
        "shape": "bifurcation",
        "trunk": {"length": length * UM, "diameter": diameter * UM},
        "branches": [{"length": lower_length * UM, "diameter": lower_diameter * UM},
                     {"length": upper_length * UM, "diameter": upper_diameter * UM}]}}


def box(width, height, duration, **parts):
    vessel = {"shape": "box", "width": width * UM, "height": height * UM, "ends": "periodic"}
    return scene(width, height, duration, **parts) | {"vessel": vessel}


PERIODIC = {"ends": "periodic"}
PARABOLIC = {"profile": "parabolic"}


def shear(speed):
    return {"ends": "periodic", "wall_velocity": {"lower": -speed, "upper": speed}}


CALIBRATION = {
    "plug": scene(80, 10, 4e-3),
    "plug_coarse": scene(80, 10, 6e-3, numerics={"spacing": 6.25e-7}),
    "plug_fine": scene(40, 10, 1.5e-3, numerics={"spacing": 2.5e-7}),
    "parabola": scene(80, 10, 4e-3, inflow=PARABOLIC),
    "driven": scene(30, 10, 1e-4, vessel=PERIODIC, body_acceleration=[600, 0], numerics={"time_step": 5e-7}),
    "driven_at_once": scene(30, 10, 5e-5, vessel=PERIODIC, body_acceleration=[600, 0]),
    "couette": scene(30, 10, 1.5e-4, vessel=shear(0.005), numerics={"time_step": 1e-6}),
    "vortices": box(50, 50, 1e-4, numerics={"spacing": 1e-6},
                    initial={"flow": "taylor_green", "velocity": 0.1}),
    "bump_2": scene(80, 10, 2e-3, inflow=PARABOLIC, thrombi=[bump(40, 2)]),
    "bump_3": scene(80, 10, 2e-3, thrombi=[bump(32, 3.2)]),
    "bump_3_coarse": scene(80, 10, 4e-3, thrombi=[bump(32, 3.2)], numerics={"spacing": 6.25e-7}),
    "bump_3_fine": scene(40, 10, 1e-3, thrombi=[bump(20, 3.2)], numerics={"spacing": 2.5e-7}),
    "bump_5": scene(60, 10, 2e-3, inflow=PARABOLIC, thrombi=[bump(30, 5)]),
    "bump_7": scene(60, 10, 1e-3, thrombi=[bump(30, 7, "upper")]),
    "bumps": scene(60, 12, 2e-3, thrombi=[bump(30, 3.5), bump(30, 3.5, "upper")]),
    "branches": branching((40, 12), (30, 9.5), (30, 9.5), 1e-3, inflow=PARABOLIC),
    "branches_bump": branching((40, 10), (30, 7), (30, 8), 1e-3, thrombi=[bump(20, 3)]),
    "pulse": scene(60, 14, 2e-3, inflow={"waveform": [[0, 0.2], [1e-3, 1.5], [2e-3, 0.2]]}),
    "cell_free": scene(80, 10, 3e-3, cells=[cell(16, 5)]),
    "cell_free_coarse": scene(80, 10, 3e-3, cells=[cell(16, 5)], numerics={"spacing": 5e-7}),
    "cell_bump": scene(60, 10, 4e-3, cells=[cell(14, 5)], thrombi=[bump(28, 3.2)]),
    "cell_stiff": scene(60, 10, 3e-3, cells=[cell(14, 5, stretch_modulus=1e-4, bend_modulus=4.8e-17)],
                        inflow=PARABOLIC),
    "cell_limp": scene(60, 10, 2.5e-3, cells=[cell(14, 5, stretch_modulus=3e-6, bend_modulus=1.5e-18)]),
    "cell_shear": scene(20, 20, 2.5e-3, vessel=shear(0.01),
                        cells=[cell(0, 10, angle=45, fill=0.8, stretch_modulus=1e-4)]),
    "cell_viscous": scene(25, 15, 2e-3, vessel=shear(0.005), cells=[cell(0, 7.5, fill=0.7, viscosity_ratio=4)]),
    "two_cells": scene(60, 12, 2.5e-3, cells=[cell(14, 4, angle=60), cell(24, 7)]),
    "cell_wide": scene(60, 15, 3e-3, cells=[cell(14, 7.5)]),
    "cell_slow": scene(60, 10, 5e-3, inflow={"velocity": 0.0025}, cells=[cell(14, 5)]),
    "cell_fast": scene(60, 12, 1.5e-3, inflow={"velocity": 0.01, "profile": "parabolic"},
                       cells=[cell(14, 6, stretch_modulus=3e-5, bend_modulus=1.44e-17)]),
    "cell_fine": scene(40, 10, 1.5e-3, cells=[cell(12, 5, stretch_modulus=2e-5, bend_modulus=9.6e-18)],
                       numerics={"spacing": 2.5e-7}),
    "cell_off_axis": scene(60, 12, 3e-3, cells=[cell(14, 4, angle=45)]),
    "cell_stiff_bump": scene(60, 10, 3e-3, thrombi=[bump(26, 2.4)],
                             cells=[cell(14, 5, stretch_modulus=5e-5, bend_modulus=2.4e-17)]),
    "cell_limp_bump": scene(60, 11, 2.5e-3, thrombi=[bump(26, 2)], inflow=PARABOLIC,
                            cells=[cell(14, 5.5, stretch_modulus=5e-6, bend_modulus=2.4e-18)]),
    "two_stiff_viscous": scene(50, 12, 2.5e-3,
                               cells=[cell(13, 5, stretch_modulus=5e-5, viscosity_ratio=3),
                                      cell(23, 7, stretch_modulus=5e-5, viscosity_ratio=3)]),
    "cell_draft": scene(80, 10, 5e-3, cells=[cell(16, 5)], thrombi=[bump(32, 2.4)], numerics={"preset": "draft"}),
    "paper_plug": scene(24, 8, 3e-4, numerics={"preset": "paper"}),
    "paper_bump": scene(30, 10, 2e-4, thrombi=[bump(15, 3)], numerics={"preset": "paper"}),
    "paper_cell": scene(40, 10, 1e-4, cells=[cell(16, 5)], numerics={"preset": "paper"}),
}

VALIDATION = {
    "plasma_8um": scene(60, 8, 4e-3),
    "driven_16um": scene(32, 16, 2.5e-4, vessel=PERIODIC, body_acceleration=[300, 0], numerics={"time_step": 1e-6}),
    "small_thrombus": scene(70, 12, 2e-3, inflow={"velocity": 0.004, "profile": "parabolic"}, thrombi=[bump(30, 2.5)]),
    "large_thrombus": scene(80, 10, 1.5e-3, thrombi=[bump(36, 6, "upper")]),
    "unequal_branches": branching((36, 11), (28, 9), (34, 6.5), 1e-3),
    "stiff_cell_12um": scene(60, 12, 4e-3, cells=[cell(15, 6, stretch_modulus=5e-5, bend_modulus=2.4e-17)]),
    "limp_cell_past_thrombus": scene(60, 10, 3e-3, cells=[cell(14, 5, stretch_modulus=6e-6, bend_modulus=3e-18)],
                                     thrombi=[bump(27, 2.6)]),
    "two_viscous_cells": scene(56, 13, 2e-3, inflow={"velocity": 0.006, "profile": "parabolic"},
                               cells=[cell(13, 4.5, viscosity_ratio=5), cell(23, 8, viscosity_ratio=5)]),
    "draft_cell_past_thrombus": scene(70, 11, 5e-3, cells=[cell(15, 5.5)], thrombi=[bump(30, 3.5)],
                                      numerics={"preset": "draft"}),
    "fine_thrombus": scene(36, 9, 8e-4, thrombi=[bump(18, 3)], numerics={"spacing": 2.25e-7}),
    "paper_plasma": scene(36, 10, 2.5e-4, inflow={"velocity": 0.004}, numerics={"preset": "paper"}),
}
