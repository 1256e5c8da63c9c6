#!/usr/bin/python3
"""Writes the page of what a plan expects, from runs beside their plans.

usage: docs/figures/plan.py FOLDER

Reads FOLDER/plan.jsonl, in which a later run replaces an earlier one of the same scene; writes it again in order, and
FOLDER/plan.md from it and plan_text.md beside this file. deploy/reproduce plan makes the runs.
"""
import json
import pathlib
import sys

TEXT = pathlib.Path(__file__).with_name("plan_text.md")


def read_runs(path):
    runs = {}
    for line in path.read_text().splitlines():
        run = json.loads(line)
        runs.pop(run["scene"], None)
        runs[run["scene"]] = run
    return sorted(runs.values(), key=lambda run: run["set"] != "validation")


def number(value):
    return f"{value:.2g}" if value >= 1e-3 else f"{value:.1e}"


def seconds(value):
    return f"{value:.2f}" if value < 10 else f"{value:.1f}"


def ratio(expected, measured, most):
    """In bold where it is off by more than `most` either way."""
    text = f"{expected / measured:.2f}"
    return text if within(expected, measured, most) else f"**{text}**"


def within(expected, measured, most):
    return 1 / most <= expected / measured <= most


def within_share(expected, measured, share):
    return abs(expected - measured) <= share * measured


def marked(expected, measured, share):
    text = f"{100 * (expected / measured - 1):+.0f} %"
    return text if within_share(expected, measured, share) else f"**{text}**"


def table(head, rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in [head, *rows]]
    return "\n".join([lines[0], "|" + " --- |" * len(head), *lines[1:]])


def cost_cells(run):
    expected = run["expected"]
    low, high = sorted(run["slowness"])
    return [str(expected["particles"]), f"{expected['expected_steps']:.0f} / {run['steps']}",
            f"{low:.2f} - {high:.2f}", seconds(expected["wall_time_s"]), seconds(run["cpu_time"]),
            marked(expected["wall_time_s"], run["cpu_time"], 0.25), seconds(run["wall_time"]),
            f"{expected['memory_bytes'] / 1e6:.0f} / {run['peak_memory'] / 1e6:.0f}",
            marked(expected["memory_bytes"], run["peak_memory"], 0.25)]


def cost_rows(runs):
    for run in runs:
        yield [f"`{run['scene']}`", *cost_cells(run["run"])]
        if "finer" in run:
            yield [f"`{run['scene']}`, its finer run", *cost_cells(run["finer"])]


def error_row(run):
    expected, errors = run["expected_error"], run["errors"]
    cells = [f"`{run['scene']}`"]
    for name in ("velocity", "tau"):
        if errors[name] is None:
            cells += ["-", "-", "-"]
        else:
            cells += [number(expected[name]), number(errors[name]), ratio(expected[name], errors[name], 2)]
    return cells


COST_HEAD = ["scene", "particles", "steps expected / taken", "slowness of the machine", "expected, s", "processor, s",
             "off by", "clock, s", "MB expected / peak", "off by"]
ERROR_HEAD = ["scene", "velocity expected", "measured", "ratio", "tau expected", "measured", "ratio"]


def counted(runs):
    """How many of these runs the plan got right, for each of its numbers."""
    def line(text, hits):
        hits = list(hits)
        return f"- {text}: {sum(hits)} of {len(hits)}"

    tried = [run for run in runs if "errors" in run]
    finer = [run["finer"] for run in runs if "finer" in run]
    lines = []
    for text, own in (("time within 25 % of the processor's", [run["run"] for run in runs]),
                      ("the same of their finer runs", finer)):
        lines.append(line(text, (within_share(run["expected"]["wall_time_s"], run["cpu_time"], 0.25) for run in own)))
    lines.append(line("memory within 25 % of the peak, of both",
                      (within_share(run["expected"]["memory_bytes"], run["peak_memory"], 0.25)
                       for run in [*(run["run"] for run in runs), *finer])))
    for name in ("velocity", "tau"):
        lines.append(line(f"error of {name} within a factor of two",
                          (within(run["expected_error"][name], run["errors"][name], 2) for run in tried
                           if run["errors"][name] is not None)))
    return "\n".join(lines)


def part(title, runs):
    if not runs:
        return []
    tried = [run for run in runs if "errors" in run]
    return [f"## {title}", "", counted(runs), "", table(COST_HEAD, cost_rows(runs)), "",
            table(ERROR_HEAD, map(error_row, tried)), ""]


def main():
    folder = pathlib.Path(sys.argv[1])
    runs = read_runs(folder / "plan.jsonl")
    (folder / "plan.jsonl").write_text("".join(json.dumps(run, sort_keys=True) + "\n" for run in runs))
    parts = [TEXT.read_text()]
    parts += part("Scenes that the model has not seen", [run for run in runs if run["set"] == "validation"])
    parts += part("Scenes that it was made from", [run for run in runs if run["set"] == "calibration"])
    (folder / "plan.md").write_text("\n".join(parts).rstrip() + "\n")


if __name__ == "__main__":
    main()
