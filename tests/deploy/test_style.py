import subprocess

import pytest

from repository import ROOT, source_files

SCRIPTS = sorted(
    path for path in source_files()
    if path.suffix == ".sh" or path.parent.name in ("deploy", ".ci") and path.read_bytes().startswith(b"#!/usr/bin/env bash"))


def test_the_scripts_are_found():
    assert {ROOT / ".ci/run", ROOT / "deploy/run", ROOT / "deploy/test"} <= set(SCRIPTS)


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_scripts_pass_shellcheck(script):
    result = subprocess.run(["shellcheck", "--external-sources", script], capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr


def test_sources_are_formatted():
    files = sorted(source_files(".cpp", ".h"))
    assert len(files) > 100
    result = subprocess.run(["clang-format", "--dry-run", "-Werror", *files], capture_output=True, text=True, cwd=ROOT)
    assert result.returncode == 0, result.stderr[:4000]
