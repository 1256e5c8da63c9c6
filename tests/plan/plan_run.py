#!/usr/bin/python3
"""Runs a scene as a user would, with `rouleau plan` and `rouleau run`, and prints as one line of JSON what was
predicted and what came of it: time, peak memory, and how far the result is from a run with half of the spacing and
half of the step."""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import plan_scenes

# h5py and numpy are imported where they are needed, after the runs: a process's peak memory starts from its parent's.

PROBE_LINES, PROBE_POINTS = 15, 40


def box_of(vessel):
    """x and y that hold all of the vessel, in m."""
    if vessel["shape"] == "box":
        return (0, vessel["width"]), (0, vessel["height"])
    if vessel["shape"] == "straight":
        return (0, vessel["length"]), (0, vessel["diameter"])
    trunk, (lower, upper) = vessel["trunk"], (branch["length"] for branch in vessel["branches"])
    along, aside = math.cos(math.radians(30)), math.sin(math.radians(30))
    return (0, trunk["length"] + along * min(lower, upper)), (-aside * lower, trunk["diameter"] + aside * upper)


def with_probes(case):
    """Lines along the vessel, all over it: what lies outside is left out of the comparison."""
    (x0, x1), (y0, y1) = box_of(case["vessel"])
    inset = 0.5 * (x1 - x0) / PROBE_POINTS
    lines = []
    for k in range(PROBE_LINES):
        y = y0 + (k + 0.5) / PROBE_LINES * (y1 - y0)
        lines.append({"name": f"line{k}", "from": [x0 + inset, y], "to": [x1 - inset, y], "points": PROBE_POINTS})
    return case | {"probes": lines}


def finer(case, plan):
    """With half of the spacing and of the step; the published scheme's reference is the standard preset."""
    numerics = {"spacing": plan["spacing"] / 2}
    if "time_step" in case.get("numerics", {}):
        numerics["time_step"] = case["numerics"]["time_step"] / 2
    return case | {"numerics": numerics}


def run(program, case, folder, name):
    """The summary, the archive, and what the process took."""
    file, archive, told = folder / f"{name}.json", folder / f"{name}.h5", folder / f"{name}.out"
    file.write_text(json.dumps(case))
    started = time.monotonic()
    with told.open("w") as out:
        process = subprocess.Popen([program, "run", file, "-o", archive, "--json"], stdout=out, stderr=out)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.monotonic() - started
    if process.returncode != 0:
        raise RuntimeError(told.read_text()[-500:])
    lines = told.read_text().splitlines()
    summary = json.loads("\n".join(lines[next(k for k, line in enumerate(lines) if line.startswith("{")):]))["summary"]
    return summary, archive, {"wall_time": wall, "cpu_time": usage.ru_utime + usage.ru_stime,
                              "peak_memory": usage.ru_maxrss * 1024}


def velocities(archive):
    """[points][2] at the end, and the columns of the series by name."""
    import h5py
    import numpy as np

    with h5py.File(archive) as file:
        probes = [file["probes"][f"line{k}"] for k in range(PROBE_LINES)]
        velocity = np.array([[probe[c][-1] for c in "uv"] for probe in probes]).transpose(0, 2, 1).reshape(-1, 2)
        return velocity, {name: np.array(values) for name, values in file["series"].items()}


def errors(archive, reference, cells):
    """Of the velocity: its root mean square all over the vessel at the end, over that of the velocity. Of tau: the
    root mean square over the run and the cells, over tau."""
    import numpy as np

    (here, series), (there, finer_series) = velocities(archive), velocities(reference)
    both = np.isfinite(here).all(axis=1) & np.isfinite(there).all(axis=1)
    here, there = here[both], there[both]
    result = {"velocity": math.sqrt(np.mean((here - there) ** 2) / np.mean(there ** 2)), "tau": None}
    if cells:
        off = []
        for k in range(cells):
            tau = np.interp(series["time"], finer_series["time"], finer_series[f"cell{k}.tau"])
            off.append(series[f"cell{k}.tau"] / tau - 1)
        off = np.concatenate(off)
        result["tau"] = math.sqrt(np.mean(off[np.isfinite(off)] ** 2))
    return result


def tell(program, *arguments, machine=None):
    """What a command prints as JSON."""
    environment = os.environ | ({"ROULEAU_MACHINE": str(machine)} if machine else {})
    answer = subprocess.run([program, *arguments], capture_output=True, text=True, env=environment)
    if answer.returncode != 0:
        raise RuntimeError(answer.stderr)
    return json.loads(answer.stdout)


def counts(summary):
    """What the model of cost was made from, of a run."""
    kept = ("steps", "rejected_steps", "viscosity_iterations", "pressure_iterations", "effect_times")
    return {name: summary[name] for name in kept} | {"refinements": len(summary["refinements"])}


def planned_run(program, case, folder, name):
    """The plan, the summary, the archive, and what the run took beside what was expected of it. How fast the machine is
    is measured right before and right after: other work on it changes that within minutes."""
    file = folder / f"{name}.json"
    file.write_text(json.dumps(case))

    def plan_now():
        return tell(program, "plan", file, "--json", "--calibrate", machine=folder / "machine.json")

    before = plan_now()
    summary, archive, took = run(program, case, folder, name)
    after = plan_now()
    line = {"expected": {key: before[key] for key in ("particles", "steps", "expected_steps", "memory_bytes")},
            "slowness": [before["machine"]["slowness"], after["machine"]["slowness"]]} | took | counts(summary)
    line["expected"]["wall_time_s"] = (before["wall_time_s"] + after["wall_time_s"]) / 2
    return before, archive, line


def measure(program, name, case, reference):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        case = with_probes(case)
        plan, archive, line = planned_run(program, case, folder, "run")
        line = {"scene": name, "set": "validation" if name in plan_scenes.VALIDATION else "calibration", "run": line,
                "expected_error": plan["expected_error"],
                "shares": {effect["name"]: effect["share"] for effect in plan["effects"] if effect["on"]}}
        if reference:
            _, finer_archive, line["finer"] = planned_run(program, finer(case, plan), folder, "finer")
            line["errors"] = errors(archive, finer_archive, len(case.get("cells", [])))
        return line


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", nargs="?")
    parser.add_argument("--list", action="store_true", help="the scenes that the model has not seen")
    parser.add_argument("--list-calibration", action="store_true", help="those that it was made from")
    parser.add_argument("--program", default="build/release/bin/rouleau")
    parser.add_argument("--no-reference", action="store_true", help="time and memory alone")
    arguments = parser.parse_args()
    scenes = plan_scenes.CALIBRATION | plan_scenes.VALIDATION
    if arguments.list or arguments.list_calibration:
        print("\n".join(plan_scenes.VALIDATION if arguments.list else plan_scenes.CALIBRATION))
        return
    if arguments.scene not in scenes:
        sys.exit(f"no scene is called {arguments.scene}; there are: {', '.join(scenes)}")
    print(json.dumps(measure(arguments.program, arguments.scene, scenes[arguments.scene],
                             not arguments.no_reference)))


if __name__ == "__main__":
    main()
