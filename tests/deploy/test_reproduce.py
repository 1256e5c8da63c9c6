"""deploy/reproduce, with the programs that CTest built (in ROULEAU_VALIDATION_RUN and ROULEAU_STABILITY_RUN)."""

import json
import os
import subprocess

import pytest

from repository import ROOT


def reproduce(*arguments):
    return subprocess.run([ROOT / "deploy/reproduce", *arguments], capture_output=True, text=True, timeout=100,
                          stdin=subprocess.DEVNULL)


def page(name, out, *arguments):
    result = reproduce(name, "--out", str(out), *arguments)
    assert result.returncode == 0, result.stdout + result.stderr
    return {path.relative_to(out).as_posix(): path.read_bytes() for path in out.rglob("*") if path.is_file()}


def accuracy(out, *arguments):
    return page("accuracy", out, *arguments)


def stability(out, *arguments):
    return page("stability", out, *arguments)


def test_help():
    result = reproduce("--help")
    assert result.returncode == 0
    assert result.stdout.startswith("usage: deploy/reproduce")


@pytest.mark.parametrize("arguments", [[], ["everything"], ["accuracy", "--slow"], ["stability", "--slow"], ["plan", "--slow"],
                                       ["cost", "--slow"], ["queue", "--slow"], ["faults", "--slow"]])
def test_what_is_unknown_is_refused(arguments):
    result = reproduce(*arguments)
    assert result.returncode == 2
    assert result.stderr.startswith("usage: deploy/reproduce")


@pytest.mark.skipif("ROULEAU_VALIDATION_RUN" not in os.environ, reason="run by CTest, which knows the program")
class TestAccuracy:
    def test_an_unknown_scene_is_named(self, tmp_path):
        result = reproduce("accuracy", "--out", str(tmp_path), "waterfall")
        assert result.returncode == 1
        assert "no scene is called waterfall; there are: couette_start, " in result.stderr

    def test_runs_become_a_page_with_diagrams(self, tmp_path):
        files = accuracy(tmp_path, "--quick", "hydrostatic", "taylor_green")
        assert set(files) == {"accuracy.md", "accuracy.jsonl", "img/accuracy_hydrostatic.svg", "img/accuracy_taylor_green.svg"}
        runs = [json.loads(line) for line in files["accuracy.jsonl"].splitlines()]
        assert [(run["scene"], run["across"]) for run in runs] == [
            ("taylor_green", 12), ("taylor_green", 16), ("hydrostatic", 12), ("hydrostatic", 16)]
        page = files["accuracy.md"].decode()
        for run in runs:
            assert run["outcome"] == "completed"
            assert f"| standard | {run['across']} | " in page

    def test_a_scene_takes_the_place_of_its_earlier_runs_and_drawing_changes_nothing(self, tmp_path):
        accuracy(tmp_path, "--quick", "hydrostatic")
        again = accuracy(tmp_path, "--quick", "hydrostatic")
        assert len(again["accuracy.jsonl"].splitlines()) == 2
        assert accuracy(tmp_path, "--draw") == again


@pytest.mark.skipif("ROULEAU_STABILITY_RUN" not in os.environ, reason="run by CTest, which knows the program")
class TestStability:
    def test_an_unknown_scene_is_named(self, tmp_path):
        result = reproduce("stability", "--out", str(tmp_path), "waterfall")
        assert result.returncode == 1
        assert "no scene is called waterfall; there are: closed_80, " in result.stderr

    def test_runs_become_a_page(self, tmp_path):
        files = stability(tmp_path, "--quick", "resting_tank")
        assert set(files) == {"stability.md", "stability.jsonl"}
        run = json.loads(files["stability.jsonl"])
        assert (run["scene"], run["form"], run["outcome"], run["steps"]) == ("resting_tank", "short", "completed", 2000)
        assert set(run["worst"]) == {
            "not_finite", "crossing_edges", "wrong_side", "area", "divergence", "energy_rise"}
        assert "| `resting_tank`: " in files["stability.md"].decode()
        again = stability(tmp_path, "--quick", "resting_tank")
        assert len(again["stability.jsonl"].splitlines()) == 1
        assert stability(tmp_path, "--draw") == again


@pytest.mark.skipif("ROULEAU_BINARY" not in os.environ, reason="run by CTest, which knows the program")
class TestPlan:
    def test_an_unknown_scene_is_named(self, tmp_path):
        result = reproduce("plan", "--out", str(tmp_path), "waterfall")
        assert result.returncode == 1
        assert "no scene is called waterfall; there are: plasma_8um, " in result.stderr

    def test_runs_become_a_page_beside_their_plans(self, tmp_path):
        files = page("plan", tmp_path, "--quick", "--calibration", "couette", "driven_at_once")
        assert set(files) == {"plan.md", "plan.jsonl"}
        runs = [json.loads(line) for line in files["plan.jsonl"].splitlines()]
        assert [(run["scene"], run["set"]) for run in runs] == [
            ("couette", "calibration"), ("driven_at_once", "calibration")]
        for run in runs:
            expected, took = run["run"]["expected"], run["run"]
            assert expected["wall_time_s"] > 0 and took["peak_memory"] > 1e7
            assert abs(took["steps"] - expected["expected_steps"]) < 20
            assert f"| `{run['scene']}` | {expected['particles']} | " in files["plan.md"].decode()


@pytest.mark.parametrize("name", ["accuracy", "stability", "plan", "cost"])
def test_the_page_is_that_of_the_runs_kept_with_it(tmp_path, name):
    (tmp_path / f"{name}.jsonl").write_bytes((ROOT / f"docs/{name}.jsonl").read_bytes())
    drawn = page(name, tmp_path, "--draw")
    assert drawn[f"{name}.md"] == (ROOT / f"docs/{name}.md").read_bytes()
    assert drawn[f"{name}.jsonl"] == (ROOT / f"docs/{name}.jsonl").read_bytes()


@pytest.mark.parametrize("name", ["queue", "load", "faults", "soak"])
def test_the_page_of_load_is_that_of_the_runs_kept_with_it(tmp_path, name):
    for runs in ("queue", "load", "faults", "soak"):
        if (ROOT / f"docs/{runs}.jsonl").exists():
            (tmp_path / f"{runs}.jsonl").write_bytes((ROOT / f"docs/{runs}.jsonl").read_bytes())
    drawn = page(name, tmp_path, "--draw")
    assert drawn["load.md"] == (ROOT / "docs/load.md").read_bytes()
