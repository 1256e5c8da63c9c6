"""What the architecture allows, checked on the sources alone.

Usage: rules.py ROOT. Prints every breach as FILE:LINE: WHAT and exits with 1 if there is any.
"""

import re
import sys
from pathlib import Path

SOURCES = {".h", ".cpp"}

# A room of the engine may use what stands in a lower row.
LAYERS = [
    {"error", "case", "simd"},
    {"bytes"},
    {"geometry", "particles"},
    {"operators", "linear", "cells"},
    {"effects"},
    {"observe"},
    {"plan"},
    {"simulation"},
]
LEVEL = {room: level for level, rooms in enumerate(LAYERS) for room in rooms}

EXCEPTIONS = {
    # What the compiler has no vector extension for.
    ("engine/simd/vector.h", "immintrin.h"),
}

STANDARD_HEADER = re.compile(r"[a-z_]+$")
FOREIGN = re.compile(r"httplib|sqlite|hdf5|H5", re.IGNORECASE)
PRINTS_OR_ENDS = re.compile(
    r"std::(cout|cerr|clog)\b|<iostream>|(?<![\w.>])(?:std::)?"
    r"(?:v?f?printf|f?puts|putchar|exit|_exit|_Exit|quick_exit|abort|terminate)\s*\("
)
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')


def without_comments(text):
    """The text of a C++ file with comments blanked out, line for line."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"'

    def blank(match):
        if match[0].startswith('"'):
            return match[0]
        return re.sub(r"[^\n]", " ", match[0])

    return re.sub(pattern, blank, text, flags=re.DOTALL)


def includes(lines):
    for number, line in enumerate(lines, 1):
        if match := INCLUDE.match(line):
            yield number, match[1]


def sources(root, folder):
    for path in sorted((root / folder).rglob("*")):
        if path.suffix in SOURCES:
            text = path.read_text(encoding="utf-8")
            yield path.relative_to(root).as_posix(), without_comments(text).split("\n")


def engine_include(name, header):
    """What is wrong with an include of an engine file, or None."""
    if FOREIGN.search(header):
        return f"the engine knows nothing of {header}"
    if header.startswith(("Eigen/", "nlohmann/")) or STANDARD_HEADER.match(header):
        return None
    if (name, header) in EXCEPTIONS:
        return None
    if not header.startswith("engine/"):
        return f"the engine includes std, Eigen, nlohmann and itself alone, not {header}"
    here, there = name.split("/")[1], header.split("/")[1]
    for room in (here, there):
        if room not in LEVEL:
            return f"room {room} has no place in the order of the engine"
    if here != there and LEVEL[there] >= LEVEL[here]:
        return f"{here} must not know {there}"
    return None


def breaches_of_engine(root):
    for name, lines in sources(root, "engine"):
        for number, header in includes(lines):
            if wrong := engine_include(name, header):
                yield f"{name}:{number}: {wrong}"
        for number, line in enumerate(lines, 1):
            code = re.sub(r'"(?:\\.|[^"\\])*"', '""', line)
            if match := PRINTS_OR_ENDS.search(code):
                yield f"{name}:{number}: the engine neither prints nor ends the process: {match[0]}"


def breaches_of_storage(root):
    for name, lines in sources(root, "storage"):
        for number, header in includes(lines):
            if header.startswith("service/"):
                yield f"{name}:{number}: storage must not know {header}"


def breaches_of_flags(root):
    files = [root / "CMakeLists.txt", root / "CMakePresets.json"]
    for folder in ("cmake", "engine", "storage", "service", "tests"):
        files += (root / folder).rglob("*.cmake")
        files += (root / folder).rglob("CMakeLists.txt")
        files += (p for p in (root / folder).rglob("*") if p.suffix in SOURCES)
    for path in sorted(set(files)):
        if not path.is_file():
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            comment = "//" if path.suffix in SOURCES else "#"
            code = line if path.suffix == ".json" else line.split(comment)[0]
            if re.search(r"-?f?fast-math|-Ofast", code):
                yield f"{path.relative_to(root).as_posix()}:{number}: a NaN must be seen: no -ffast-math"


def breaches(root):
    yield from breaches_of_engine(root)
    yield from breaches_of_storage(root)
    yield from breaches_of_flags(root)


def main():
    root = Path(sys.argv[1])
    if not any(sources(root, "engine")):
        sys.exit(f"no sources in {root / 'engine'}")
    found = list(breaches(root))
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
