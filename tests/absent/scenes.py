"""Scenes from still plasma to cells with everything on, made from the examples of the documentation.

Usage: scenes.py EXAMPLES FOLDER. Writes FOLDER/NAME.json for each scene and prints the names.
"""

import json
import sys
from pathlib import Path

EVERY_OUTPUT = {"series_interval": 2e-5, "frame_interval": 1e-4,
                "fields": ["velocity", "pressure", "wall_shear_stress"]}
ON_REQUEST = ["aggregation", "inextensible", "hydraulic_resistance", "cell_free_layer", "fahraeus", "membrane_maps",
              "hemolysis"]
THROMBUS = {"wall": "lower", "x": 32e-6, "radius": 3.2e-6}
PROBE = {"name": "across", "from": [20e-6, 0], "to": [20e-6, 10e-6], "points": 25}


def cell(x, y=5e-6, **more):
    return {"x": x, "y": y, **more}


def straight(name, **more):
    return {"version": 1, "name": name, "vessel": {"shape": "straight", "length": 40e-6, "diameter": 10e-6},
            "duration": 1e-3, **more}


def still(name):
    return {**straight(name), "vessel": {"shape": "straight", "length": 40e-6, "diameter": 10e-6, "ends": "periodic"}}


def changed(base, **more):
    return {**base, **more}


def scenes(examples):
    """Name to case, the simplest first."""

    def example(name):
        return json.loads((examples / f"{name}.json").read_text(encoding="utf-8"))

    two_cells = straight("two cells past a thrombus", thrombi=[{**THROMBUS, "x": 24e-6}],
                         cells=[cell(8e-6), cell(14e-6, 4.5e-6)])
    return {
        "still_plasma": still("plasma at rest"),
        "hydrostatic": example("hydrostatic"),
        "couette": example("couette"),
        "cavity": example("cavity_re100"),
        "taylor_green": example("taylor_green"),
        "poiseuille": example("poiseuille_plug"),
        "poiseuille_paper": example("poiseuille_paper"),
        "womersley": example("womersley"),
        "thrombus": straight("a thrombus, no cell", thrombi=[{**THROMBUS, "x": 20e-6}]),
        "wall_shear": example("wall_shear"),
        "bifurcation": example("bifurcation"),
        "single_cell": example("single_cell_8d0"),
        "viscous_cell": changed(example("single_cell_8d0"), cells=[cell(16e-6, viscosity_ratio=5)]),
        "deflating_cell": example("deflating_cell"),
        "cell_in_shear": example("cell_in_shear"),
        "inextensible_cell": example("inextensible_cell"),
        "rouleau": example("rouleau_in_shear"),
        "two_cells": two_cells,
        "everything": changed(two_cells, cells=[cell(8e-6, viscosity_ratio=5), cell(14e-6, 4.5e-6)],
                              inflow={"waveform": [[0, 1], [1e-3, 1.5]]}, output=EVERY_OUTPUT, probes=[PROBE],
                              effects=dict.fromkeys(ON_REQUEST, "on")),
    }


def main():
    examples, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, case in scenes(examples).items():
        path, text = folder / f"{name}.json", json.dumps(case, indent=2) + "\n"
        # What is the same keeps its time, and what was built of it.
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
        print(name)


if __name__ == "__main__":
    main()
