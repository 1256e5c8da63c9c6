"""The program as people and scripts call it."""

import io
import json
import os
import signal
import subprocess
import time

import h5py
import pytest
from rouleau_server import endless, plasma, unstable


@pytest.fixture
def call(server, tmp_path):
    def run(*arguments, timeout=60):
        kept = {name: os.environ[name] for name in ("ROULEAU_MACHINE",) if name in os.environ}
        return subprocess.run([server.binary, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True,
                              timeout=timeout, env={"ROULEAU_SERVER": server.url, "PATH": "/usr/bin", **kept})
    return run


@pytest.fixture
def write_case(tmp_path):
    def write(case, name="case.json"):
        (tmp_path / name).write_text(json.dumps(case))
        return name
    return write


def test_help(call):
    for command in ("validate", "plan", "run", "series", "sweep", "bench", "serve", "submit", "status", "wait", "fetch", "cancel",
                    "pause", "resume", "retry", "delete", "queue"):
        done = call(command, "--help")
        assert done.returncode == 0 and command in done.stdout
    assert call("--version").returncode == 0


@pytest.mark.parametrize("arguments", [[], ["frobnicate"], ["run"], ["run", "a", "--nope"], ["serve", "--port", "70000"]])
def test_usage(call, arguments):
    done = call(*arguments)
    assert done.returncode == 2 and done.stderr and not done.stdout


def test_validate(call, write_case):
    assert call("validate", write_case(plasma())).returncode == 0
    done = call("validate", "--json", write_case(plasma()))
    assert json.loads(done.stdout)["case"]["plasma"]["density"] == 1000

    done = call("validate", "--json", write_case(plasma(vessel={"length": -1}, surprise=1)))
    pointers = {error["pointer"] for error in json.loads(done.stdout)["errors"]}
    assert done.returncode == 2
    assert {"/vessel/length", "/vessel/diameter", "/surprise"} <= pointers
    assert all(f"  {pointer}: " in done.stderr for pointer in pointers)
    assert call("validate", "none.json").returncode == 2


def test_bench(call):
    setting = ("--particles", "400,700", "--steps", 2)
    done = call("bench", "--json", *setting)
    points = json.loads(done.stdout)["points"]
    assert done.returncode == 0 and [point["steps"] for point in points] == [2, 2]
    assert 300 < points[0]["particles"] < 500 < points[1]["particles"] < 800
    for point in points:
        assert point["updates_per_second"] == pytest.approx(2 * point["particles"] / point["seconds"])
        assert sum(effect["seconds"] for effect in point["effects"]) == pytest.approx(point["seconds"])
        assert {"pressure_rotational", "viscosity_implicit"} <= {effect["name"] for effect in point["effects"]}

    done = call("bench", *setting)
    assert done.returncode == 0 and "pressure_rotational" in done.stdout and "preset standard" in done.stdout
    assert call("bench", "--preset", "hasty", *setting).returncode == 2
    assert call("bench", "--particles", "3").returncode == 2


def test_plan(call, write_case):
    done = call("plan", "--json", write_case(plasma()))
    plan = json.loads(done.stdout)
    assert done.returncode == 0 and plan["particles"] > 100
    assert {effect["name"] for effect in plan["effects"] if effect["on"]} >= {"pressure_rotational"}
    assert sum(effect["share"] for effect in plan["effects"]) == pytest.approx(1)
    assert plan["wall_time_s"] > 0 and plan["machine"]["measured"] and plan["expected_error"]["tau"] is None
    told = call("plan", write_case(plasma()))
    assert "pressure_rotational" in told.stdout and "the scene has no cells (/cells):" in told.stdout


def test_the_service_plans_as_the_command_line_does(server, call, write_case):
    told = json.loads(call("plan", "--json", "--data", str(server.data), write_case(plasma())).stdout)
    answer = server.request("POST", "/v1/cases:plan", plasma())
    assert (answer.status, answer.json()) == (200, told)
    job = server.submit(plasma())
    assert server.job(job)["plan"] == told
    server.wait(job)
    with h5py.File(io.BytesIO(server.get(f"/v1/jobs/{job}/archive.h5").body)) as archive:
        assert json.loads(archive["parameters/plan"][()]) == told


def test_the_machine_is_measured_once_and_again_when_asked(call, write_case, tmp_path, monkeypatch):
    monkeypatch.delenv("ROULEAU_MACHINE", raising=False)
    kept = tmp_path / "data/machine.json"
    first = call("plan", "--json", "--data", "data", write_case(plasma()))
    assert "measuring" in first.stderr and json.loads(kept.read_text())["slowness"] > 0
    again = call("plan", "--json", "--data", "data", write_case(plasma()))
    assert again.stderr == "" and again.stdout == first.stdout
    kept.write_text(json.dumps(json.loads(kept.read_text()) | {"processor": "another"}))
    assert "measuring" in call("plan", "--data", "data", write_case(plasma())).stderr
    assert "measuring" in call("plan", "--data", "data", "--calibrate", write_case(plasma())).stderr
    for damaged in ["{", "", "[]", '{"engine": 3, "processor": []}']:
        kept.write_text(damaged)
        assert call("plan", "--data", "data", write_case(plasma())).returncode == 0
        assert json.loads(kept.read_text())["slowness"] > 0


def test_run_and_series(call, write_case, tmp_path):
    done = call("run", write_case(plasma(duration=1)), "-o", "out.h5", "--set", "/duration=1e-4", "--set",
                "/plasma/density=1050")
    assert done.returncode == 0, done.stderr
    assert "conservation" in done.stdout and "time per effect" in done.stdout
    assert (tmp_path / "out.xdmf").exists()
    with h5py.File(tmp_path / "out.h5") as archive:
        assert "series" in archive

    csv = call("series", "out.h5", "--csv").stdout.splitlines()
    series = json.loads(call("series", "out.h5", "--json").stdout)
    assert csv[0].split(",") == series["columns"] and len(csv) == len(series["rows"]) + 1
    assert call("series", "out.h5", "--columns", "time").stdout.split()[0] == "time"
    assert call("series", "out.h5", "--columns", "nope").returncode == 2
    assert call("series", "none.h5").returncode == 2


def test_an_interrupted_run_keeps_what_it_has(server, write_case, tmp_path):
    write_case(endless())
    run = subprocess.Popen([server.binary, "run", "case.json", "-o", "part.h5", "--json"], cwd=tmp_path,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    deadline = time.monotonic() + 30
    while not (tmp_path / "part.h5.part").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    output, _ = run.communicate(timeout=30)
    assert run.returncode == 1
    assert json.loads(output)["summary"]["ending"] == "stopped"
    with h5py.File(tmp_path / "part.h5") as archive:
        assert "series" in archive


def test_a_run_that_goes_unstable_keeps_what_it_computed(call, write_case, tmp_path):
    done = call("run", write_case(unstable()), "-o", "out.h5", "--json")
    told = json.loads(done.stdout)
    breach = told["breach"]
    assert done.returncode == 1 and "error: the run went unstable" in done.stderr
    assert breach["quantity"] and breach["cell"] == 0 and 0 < breach["y"] < 10e-6
    assert told["summary"]["ending"] == "failed" and told["summary"]["simulated_time"] < breach["simulated_time"]
    assert not list(tmp_path.glob("out.h5.*"))

    series = json.loads(call("series", "out.h5", "--columns", "time,cell0.perimeter", "--json").stdout)
    (_, first), (time, last) = series["rows"][0], series["rows"][-1]
    assert len(series["rows"]) > 5 and last > 2 * first
    assert time <= told["summary"]["simulated_time"]
    across = call("series", "out.h5", "--probe", "across", "--csv").stdout.splitlines()
    assert len(across) == 1 + 3 * len(series["rows"])
    with h5py.File(tmp_path / "out.h5") as archive:
        assert archive["parameters/ending"].asstr()[()] == "failed"


def test_submit_wait_and_fetch(call, write_case, tmp_path):
    done = call("submit", write_case(plasma()), "--label", "study=cli", "--priority", "3")
    job_id, url = done.stdout.split()
    assert url.endswith(f"/v1/jobs/{job_id}")
    done = call("wait", job_id)
    assert done.returncode == 0 and "succeeded" in done.stdout
    assert job_id in call("status").stdout and "succeeded" in call("status", job_id).stdout
    assert json.loads(call("status", job_id, "--json").stdout)["labels"] == {"study": "cli"}

    done = call("fetch", job_id, "-o", "got.h5", "--json")
    assert done.returncode == 0, done.stderr
    assert len(json.loads(done.stdout)["sha256"]) == 64
    assert "got.h5" in (tmp_path / "got.xdmf").read_text()
    with h5py.File(tmp_path / "got.h5") as archive:
        assert "series" in archive


def test_submit_and_wait_in_one(call, write_case):
    done = call("submit", write_case(plasma()), "--wait", "--json")
    assert done.returncode == 0 and json.loads(done.stdout)["state"] == "succeeded"


def test_cancel(call, write_case):
    job_id = json.loads(call("submit", write_case(endless()), "--json").stdout)["id"]
    assert call("fetch", job_id).returncode == 1
    assert call("cancel", job_id).returncode == 0
    assert call("wait", job_id).returncode == 1
    assert call("cancel", "not-an-id!").returncode == 2
    assert call("status", "00000000").returncode == 2


def test_faults_found_by_the_server(call, write_case):
    done = call("submit", write_case(plasma(duration=-1)))
    assert done.returncode == 2 and "/case/duration: " in done.stderr


def test_no_server(call):
    done = call("status", "--server", "http://127.0.0.1:9")
    assert done.returncode == 1 and "no server answers" in done.stderr


def numbers(archive):
    """All datasets of an archive but what says when and how fast it was made."""
    found = {}
    with h5py.File(archive) as file:
        file.visititems(lambda name, item: found.update({name: item[()].tobytes()})
                        if isinstance(item, h5py.Dataset) and not name.startswith("parameters") else None)
    return found


def test_resume_after_a_kill_and_a_signal(call, server, write_case, tmp_path):
    write_case(plasma(numerics={"spacing": 4e-7}, duration=2e-3))
    assert call("run", "case.json", "-o", "whole.h5").returncode == 0
    run = ("run", "case.json", "-o", "out.h5", "--resume", "--checkpoint-interval", "0.001")
    for number in (signal.SIGKILL, signal.SIGTERM):
        process = subprocess.Popen([server.binary, *run], cwd=tmp_path, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, env={"PATH": "/usr/bin"})
        while not (tmp_path / "out.h5.checkpoint").exists():
            assert process.poll() is None
            time.sleep(0.002)
        process.send_signal(number)
        process.communicate(timeout=60)
    done = call(*run)
    assert done.returncode == 0 and "whole duration" in done.stdout
    assert numbers(tmp_path / "out.h5") == numbers(tmp_path / "whole.h5")
    assert not list(tmp_path.glob("out.h5.*"))


def test_a_damaged_checkpoint_is_refused(call, write_case, tmp_path):
    write_case(plasma())
    (tmp_path / "out.h5.checkpoint").write_bytes(b"rouleau checkpoint\n" + bytes(500))
    done = call("run", "case.json", "-o", "out.h5", "--resume")
    assert done.returncode == 2 and "checkpoint" in done.stderr
    assert call("run", "case.json", "-o", "out.h5").returncode == 0
    assert not (tmp_path / "out.h5.checkpoint").exists()
