"""A sweep run in one process, without a service."""

import csv
import json
import signal
import subprocess
import time

import h5py
import pytest
from rouleau_server import plasma, unstable


@pytest.fixture
def sweep(tmp_path, rouleau):
    """Runs a sweep in `tmp_path/out`."""
    def run(body, *arguments):
        (tmp_path / "sweep.json").write_text(json.dumps(body))
        return subprocess.run([rouleau, "sweep", "sweep.json", "-o", "out", *arguments], cwd=tmp_path, capture_output=True,
                              text=True, timeout=120)
    return run


def table(folder):
    with open(folder / "table.csv", newline="") as file:
        return list(csv.DictReader(file))


def archives(folder):
    return {path.name: path.stat().st_mtime_ns for path in folder.glob("*.h5")}


velocities = {"pointer": "/inflow/velocity", "values": [0.001, 0.002, 0.003]}


def test_every_point_has_an_archive_and_a_row(sweep, tmp_path):
    body = {"case": plasma(), "axes": [{"pointer": "/plasma/density", "values": [1000, 1050]},
                                       {"pointer": "/inflow/velocity", "from": 0.001, "to": 0.003, "count": 2}],
            "priority": 3, "labels": {"a": "b"}, "fresh": True}
    done = sweep(body, "--json", "--workers", "2")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert (told["points"], told["succeeded"], told["failed"], told["reused"]) == (4, 4, 0, 0)
    rows = table(tmp_path / "out")
    assert [(row["/plasma/density"], row["/inflow/velocity"]) for row in rows] == [
        ("1000", "0.001"), ("1000", "0.003"), ("1050", "0.001"), ("1050", "0.003")]
    assert {row["state"] for row in rows} == {"succeeded"}
    for row in rows:
        with h5py.File(tmp_path / "out" / (row["case_hash"][:16] + ".h5")) as archive:
            resolved = json.loads(archive["parameters/case_resolved"].asstr()[()])
            assert resolved["inflow"]["velocity"] == float(row["/inflow/velocity"])
            assert resolved["plasma"]["density"] == float(row["/plasma/density"])
    kept = json.loads((tmp_path / "out" / "sweep.json").read_text())
    assert kept["sweep"] == body and kept["table"] == told["table"]


def test_the_sweep_itself_is_not_written_over(tmp_path, rouleau):
    file = tmp_path / "sweep.json"
    file.write_text(json.dumps({"case": plasma(), "axes": [velocities]}))
    before = file.read_text()
    done = subprocess.run([rouleau, "sweep", "sweep.json", "-o", "."], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2 and "another folder" in done.stderr
    assert file.read_text() == before and list(tmp_path.iterdir()) == [file]


def test_started_again_it_runs_what_is_not_there(sweep, tmp_path):
    assert sweep({"case": plasma(), "axes": [velocities]}).returncode == 0
    before = archives(tmp_path / "out")
    more = {"pointer": "/inflow/velocity", "values": [0.0015, 0.002, 0.003, 0.001, 0.002]}
    told = json.loads(sweep({"case": plasma(name="another name"), "axes": [more]}, "--json").stdout)
    after = archives(tmp_path / "out")
    assert (told["succeeded"], told["reused"]) == (5, 4)
    assert len(after) == 4 and before.items() <= after.items()


def test_an_archive_of_another_version_is_not_taken(sweep, tmp_path):
    body = {"case": plasma(), "axes": [{"pointer": "/inflow/velocity", "values": [0.001]}]}
    assert sweep(body).returncode == 0
    [archive] = (tmp_path / "out").glob("*.h5")
    with h5py.File(archive, "r+") as file:
        del file["parameters/version"]
        file["parameters/version"] = "0.0.0"
    assert json.loads(sweep(body, "--json").stdout)["reused"] == 0
    archive.write_bytes(b"no archive")
    assert json.loads(sweep(body, "--json").stdout)["reused"] == 0


def test_a_point_that_fails_does_not_stop_the_others(sweep, tmp_path):
    body = {"case": unstable(), "axes": [{"pointer": "/duration", "values": [3e-3, 1e-4]}]}
    for _ in range(2):
        done = sweep(body)
        assert done.returncode == 1 and "error: point 0: " in done.stderr
        assert [row["state"] for row in table(tmp_path / "out")] == ["failed", "succeeded"]
    assert "2 were there already" in done.stdout
    assert float(table(tmp_path / "out")[1]["cell0.peak_tau"]) >= 0


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_sweep_that_was_stopped_goes_on(sweep, tmp_path, rouleau, number):
    body = {"case": plasma(numerics={"spacing": 4e-7}, duration=2e-3), "axes": [{**velocities, "values": [0.005, 0.004]}]}
    (tmp_path / "sweep.json").write_text(json.dumps(body))
    run = subprocess.Popen([rouleau, "sweep", "sweep.json", "-o", "out", "--workers", "2", "--checkpoint-interval", "0.001"],
                           cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while len(list(tmp_path.glob("out/*.checkpoint"))) < 2:
        assert run.poll() is None
        time.sleep(0.002)
    run.send_signal(number)
    assert run.wait(timeout=60) != 0
    assert sweep(body).returncode == 0
    assert {row["state"] for row in table(tmp_path / "out")} == {"succeeded"}
    assert not list(tmp_path.glob("out/*.checkpoint")) and not list(tmp_path.glob("out/*.part"))


def test_two_at_once_in_one_folder_are_refused(sweep, tmp_path, rouleau):
    body = {"case": plasma(duration=1), "axes": [velocities]}
    (tmp_path / "long.json").write_text(json.dumps(body))
    running = subprocess.Popen([rouleau, "sweep", "long.json", "-o", "out"], cwd=tmp_path, stderr=subprocess.DEVNULL)
    while not list(tmp_path.glob("out/*.part")):
        assert running.poll() is None
        time.sleep(0.01)
    second = sweep(body)
    running.kill()
    running.wait()
    assert second.returncode == 1 and "in use" in second.stderr


@pytest.mark.parametrize("body, pointers", [
    ({"axes": [velocities]}, {"/case"}),
    ({"case": plasma(), "axes": []}, {"/axes"}),
    ({"case": plasma(), "axes": [velocities, {"pointer": "/none", "values": [1]}]}, {"/axes/1/pointer"}),
    ({"case": plasma(), "axes": [{"pointer": "/duration", "values": [1e-4, -1, -2]}]}, {"/case/duration"}),
])
def test_a_bad_sweep_is_refused_before_anything_runs(sweep, tmp_path, body, pointers):
    done = sweep(body, "--json")
    assert done.returncode == 2
    assert {error["pointer"] for error in json.loads(done.stdout)["errors"]} == pointers
    assert not (tmp_path / "out").exists()


def test_too_many_points(sweep):
    body = {"case": plasma(), "axes": [{"pointer": "/duration", "from": 1e-4, "to": 2e-4, "count": 11}]}
    done = sweep(body, "--max-sweep", "10")
    assert done.returncode == 2 and "10 points" in done.stderr
