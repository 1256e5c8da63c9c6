"""Draws docs/cost.md from docs/cost.jsonl: what the effects of each scene cost, and what those cost that it
does without.

Usage: cost.py FOLDER
"""

import json
import sys
from pathlib import Path

HEAD = """# What each scene simulates, and what it costs

Every scene below ran in two programs in turn: one that has all {known} effects and observers, and one linked from
the same objects in which those that the scene's plan leaves out do not exist (for scenes without cells that is all
code of cells). Both give the same bits and allocate the same, which `ctest --preset release -R absent` checks; the
last column is how much more time the first one took. Times are the least of {repetitions} runs each, in turns, by the processor's
clock, from the first step on, observers included; one thread. Runs of one and the same program differ by a tenth and
more on the machine that made this page: what is left of that in the last column, of either sign, says no more.

This page is made by `deploy/reproduce cost`, which draws it from `cost.jsonl`. The scenes are made by
`tests/absent/scenes.py` from the [examples](examples/).

| scene | particles | membrane nodes | effects and observers | steps/s | steps/s without the others | cost of what is absent |
| --- | --- | --- | --- | --- | --- | --- |
"""

TIMES = """
## Time per effect

Of each scene, in ms a step, the share of the whole, and how often an effect was awake where it slept at times. Left out
are those under 0.5 %.
"""


def rows(lines):
    for line in lines:
        cost = f"{100 * (line['ratio'] - 1):+.1f} %"
        bits = "" if line["same_bits"] else " (other bits!)"
        yield (f"| `{line['scene']}` | {line['particles']} | {line['membrane_nodes']} | {len(line['effects'])} of "
               f"{line['known']} | {line['steps_per_second']:.0f} | {line['steps_per_second_without']:.0f} | {cost}{bits} |")


def times(line):
    effects = line["effects"]
    total = sum(e["seconds"] for e in effects)
    small = [e["name"] for e in effects if e["seconds"] < 0.005 * total]
    yield f"\n### {line['scene']}\n"
    yield "| effect | ms a step | share | awake |"
    yield "| --- | --- | --- | --- |"
    for effect in sorted(effects, key=lambda e: -e["seconds"]):
        if effect["name"] in small and effect["awake"] == effect["rounds"]:
            continue
        awake = "" if effect["awake"] == effect["rounds"] else f"{100 * effect['awake'] / effect['rounds']:.0f} %"
        yield (f"| `{effect['name']}` | {1e3 * effect['seconds'] / line['steps']:.3f} | "
               f"{100 * effect['seconds'] / total:.1f} % | {awake} |")
    yield "\nThe plan's other effects and observers: " + ", ".join(f"`{name}`" for name in small) + "."


def main():
    folder = Path(sys.argv[1])
    with open(folder / "cost.jsonl", encoding="utf-8") as stream:
        latest = {line["scene"]: line for line in map(json.loads, stream)}
    lines = list(latest.values())
    (folder / "cost.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    text = HEAD.format(known=lines[0]["known"], repetitions=lines[0]["repetitions"])
    text += "\n".join(rows(lines)) + "\n" + TIMES
    text += "\n".join(row for line in lines for row in times(line)) + "\n"
    (folder / "cost.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
