#!/usr/bin/python3
"""Compares the time of a scene with and without what it does without; see absent.py, which it runs.

Usage: cost_run.py --list
       cost_run.py SCENE BUILD [--quick]
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
import absent  # noqa: E402
import scenes  # noqa: E402

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(scenes.scenes(EXAMPLES)))
        return
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    scene, build = sys.argv[1], Path(sys.argv[2])
    steps, repetitions = (12, 1) if "--quick" in sys.argv else (100, 7)
    absent.bench(str(build / "bin/absent_run"), str(build / f"bin/absent_{scene}"),
                 str(build / f"tests/absent/cases/{scene}.json"), steps, repetitions)


if __name__ == "__main__":
    main()
