"""What a scene does without costs it nothing: runs it in a program that has every effect and in one in which
those that its plan leaves out do not exist.

  absent.py catalogue PROGRAM CASE ENGINE FILE
      writes the two catalogues of ENGINE into FILE with only those entries that PROGRAM ran
  absent.py compare PROGRAM WITHOUT CASE STEPS
      the answers must agree to the last bit, and so must what they allocate
  absent.py bench PROGRAM WITHOUT CASE STEPS [REPETITIONS]
      both in turn; prints as one line of JSON what each took
"""

import json
import re
import subprocess
import sys
from pathlib import Path

CATALOGUES = ["effects", "observe"]


def run(program, case, steps):
    done = subprocess.run([program, case, str(steps)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{program} {case}: {done.stderr}")
    return json.loads(done.stdout)


def ran(result):
    return {effect["name"] for effect in result["effects"]}


def kind_names(source):
    """The name of each kind that a file of the engine defines, by its variable."""
    text = source.read_text(encoding="utf-8")
    found = re.findall(r'const \w+Kind (\w+)\s*\{\s*"(\w+)"', text)
    return dict(found)


def filtered(catalogue, names):
    """The text of a catalogue without the entries that are not among `names`."""
    variables = {}
    for source in catalogue.parent.glob("*.cpp"):
        variables.update(kind_names(source))
    text = catalogue.read_text(encoding="utf-8")

    def keep(match):
        return match[0] if variables[match[1]] in names else ""

    begin = text.index("kinds = {")
    end = text.index("};", begin)
    return text[:begin] + re.sub(r"&(\w+),?", keep, text[begin:end]) + text[end:]


def write_catalogues(program, case, engine, file):
    names = ran(run(program, case, 1))
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("".join(filtered(engine / room / "catalogue.cpp", names) for room in CATALOGUES), encoding="utf-8")


def symbols_of(program):
    return subprocess.run(["nm", "--demangle", program], capture_output=True, text=True, check=True).stdout


def effects_linked(symbols):
    return set(re.findall(r" rouleau::(?:effects|observe)::(\w+)$", symbols, re.MULTILINE))


def compare(program, without, case, steps):
    full, bare = run(program, case, steps), run(without, case, steps)
    faults = []
    if missing := ran(full) - set(bare["known"]):
        faults.append(f"it lacks {missing}, which the scene needs")
    if needless := set(bare["known"]) - ran(full):
        faults.append(f"it has {needless}, which the scene does without")
    if not set(full["known"]) - set(bare["known"]):
        faults.append("both programs know the same effects")
    for key in ("digest", "steps", "allocations", "allocated"):
        if full[key] != bare[key]:
            faults.append(f"{key}: {full[key]} with all effects, {bare[key]} without those")
    symbols = symbols_of(without)
    if linked := effects_linked(symbols) & (set(full["known"]) - set(bare["known"])):
        faults.append(f"the program without {linked} contains them")
    if full["membrane_nodes"] == 0 and "rouleau::cells::add_" in symbols:
        faults.append("the program of a scene without cells contains their forces")
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(bare['known'])} of {len(full['known'])} effects and observers, {bare['steps']} steps, "
          f"{bare['allocations']} allocations: the same bits")


def bench(program, without, case, steps, repetitions):
    seconds = {program: [], without: []}
    results = {}
    for repetition in range(repetitions):
        for one in (program, without) if repetition % 2 else (without, program):
            results[one] = run(one, case, steps)
            seconds[one].append(results[one]["seconds"])
    full = results[program]
    line = {key: full[key] for key in ("name", "particles", "membrane_nodes", "steps", "effects")}
    line["scene"] = Path(case).stem
    line["known"] = len(full["known"])
    line["steps_per_second"] = full["steps"] / min(seconds[program])
    line["steps_per_second_without"] = full["steps"] / min(seconds[without])
    line["ratio"] = min(seconds[program]) / min(seconds[without])
    line["repetitions"] = repetitions
    line["same_bits"] = full["digest"] == results[without]["digest"]
    print(json.dumps(line))


def main():
    command, *rest = sys.argv[1:] or [""]
    if command == "catalogue" and len(rest) == 4:
        write_catalogues(rest[0], rest[1], Path(rest[2]), Path(rest[3]))
    elif command == "compare" and len(rest) == 4:
        compare(rest[0], rest[1], rest[2], int(rest[3]))
    elif command == "bench" and len(rest) in (4, 5):
        bench(rest[0], rest[1], rest[2], int(rest[3]), int((rest + [5])[4]))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
