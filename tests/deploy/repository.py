"""The files of this repository, without what is built from them."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _is_source(folder):
    return folder not in (".git", "node_modules", "__pycache__", ".cache") and not folder.startswith("build")


def source_files(*suffixes):
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if _is_source(name)]
        for name in names:
            if not suffixes or name.endswith(suffixes):
                yield pathlib.Path(folder) / name


def packages():
    """(group, package, the text by which its use is found) of each line of deploy/packages.txt."""
    group = None
    for line in (ROOT / "deploy/packages.txt").read_text().splitlines():
        if line.startswith("["):
            group = line.strip("[]")
        elif line and not line.startswith("#"):
            package, mark = line.split("#", 1)
            yield group, package.strip(), mark.strip()
