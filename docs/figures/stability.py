#!/usr/bin/python3
"""Writes the page of the scenes that break solvers from runs of them.

usage: docs/figures/stability.py FOLDER

Reads FOLDER/stability.jsonl, in which a later run replaces an earlier one of the same scene and form; writes it
again in the order of the scenes, and FOLDER/stability.md. deploy/reproduce stability makes the runs.
"""
import json
import pathlib
import sys

INTRODUCTION = """# Hard cases

Scenes that break solvers. Each is watched from outside after every step (`tests/stability/watcher.h`): nothing may
become infinite, no edges of membranes may cross, no particle may be on the wrong side of a membrane or behind a wall,
a cell's area may be off by 0.5 % at most, and the divergence of the velocity, as the fits of the step have it, by
1e-2 U/d0 at any particle. Where the scene says so, more is asked. What breaks its bound is in bold.

"put back" counts particles that a membrane let through within a step and that were put back in it; "taken again" counts
steps that broke a limit and were taken again, smaller. One thread; the processor's time is what the run takes by
the clock on an idle machine.

This page is made by `deploy/reproduce stability` (a scene alone: `deploy/reproduce stability apex`), which draws it from
`stability.jsonl`; `--draw` draws it again without running anything. Shorter forms of all scenes, with the same
bounds, run with every `deploy/test`; `tests/stability/known_misses.h` names those that break one.
"""

QUANTITIES = {
    "crossing_edges": "crossing edges",
    "wrong_side": "wrong side",
    "area": "area",
    "divergence": "div u d0/U",
}
EXTRAS = {
    "repeat": "between the two runs {value}",
    "trajectory": "off the normal trajectory by {value} of the way",
    "energy_rise": "energy rises by {value} of that of lifting",
}


def read_runs(path):
    runs = {}
    for line in path.read_text().splitlines():
        run = json.loads(line)
        runs.pop((run["scene"], run["form"]), None)
        runs[run["scene"], run["form"]] = run
    return sorted(runs.values(), key=lambda run: (run["form"], run["place"]))


def number(value):
    if value == 0 or value == int(value) and value < 1e4:
        return str(int(value))
    return f"{value:.1e}" if value < 1e-2 or value >= 1e3 else f"{value:.2g}"


def seconds(value):
    return f"{value:.1f}" if value < 10 else f"{value:.0f}"


def marked(text, missed):
    return f"**{text}**" if missed else text


def outcome(run):
    text = run["outcome"] + (f": {run['message']}" if run["message"] else "")
    parts = [marked(text.replace("|", "/").replace("\n", " "), "outcome" in run["misses"])]
    for name, form in EXTRAS.items():
        if name in run["worst"]:
            said = form.format(value=number(run["worst"][name]["value"]))
            parts.append(marked(said, name in run["misses"]))
    if run["worst"]["not_finite"]["value"]:
        parts.append("**values that are not finite**")
    return "; ".join(parts)


def row(run):
    cells = [f"`{run['scene']}`: {run['text']}", outcome(run), f"{run['simulated_time'] * 1e3:.3g}"]
    for name in QUANTITIES:
        cells.append(marked(number(run["worst"][name]["value"]), name in run["misses"]))
    return cells + [str(run["put_back"]), str(run["steps"]), str(run["rejected"]), seconds(run["cpu_time"]),
                    seconds(run["wall_time"])]


def table(rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in rows]
    return "\n".join([lines[0], "|" + " --- |" * len(rows[0]), *lines[1:]])


def where(run):
    """Where and when each bound that was broken was broken most."""
    places = []
    for name in run["misses"]:
        worst = run["worst"].get(name)
        if worst and worst["time"] > 0:
            places.append(f"{QUANTITIES.get(name, name)} at t = {worst['time'] * 1e3:.3g} ms, "
                          f"x = {worst['x'] * 1e6:.4g}, y = {worst['y'] * 1e6:.4g} um")
    return "; ".join(places)


def main():
    folder = pathlib.Path(sys.argv[1])
    runs = read_runs(folder / "stability.jsonl")
    (folder / "stability.jsonl").write_text("".join(json.dumps(run, sort_keys=True) + "\n" for run in runs))
    parts = [INTRODUCTION]
    for form in ("long", "short"):
        own = [run for run in runs if run["form"] == form]
        if not own:
            continue
        kept = sum(not run["misses"] for run in own)
        parts += [f"## The {form} forms", "", f"{kept} of {len(own)} scenes keep all their bounds.", ""]
        head = ["scene", "outcome", "ms", *QUANTITIES.values(), "put back", "steps", "taken again", "processor, s",
                "clock, s"]
        parts += [table([head] + [row(run) for run in own]), ""]
        places = [f"- `{run['scene']}`: {where(run)}" for run in own if where(run)]
        if places:
            parts += ["Where and when the bounds were broken most:", "", *places, ""]
    (folder / "stability.md").write_text("\n".join(parts).rstrip() + "\n")


if __name__ == "__main__":
    main()
