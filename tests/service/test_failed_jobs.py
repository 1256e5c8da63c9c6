"""A job whose run went unstable: it says why, and what it computed until then stays."""

import hashlib
import io
import json
import subprocess

import h5py
import pytest
from rouleau_server import Server, unstable


@pytest.fixture(scope="module")
def service(tmp_path_factory):
    with Server(tmp_path_factory.mktemp("failed") / "data") as server:
        yield server


@pytest.fixture(scope="module")
def failed(service):
    """Met after a restart, so that nothing comes from the memory of the process that ran it."""
    job_id = service.submit(unstable())
    service.wait(job_id)
    service.terminate()
    service.start()
    return service.job(job_id)


def test_it_says_what_left_its_bounds_when_and_where(failed):
    error = failed["error"]
    assert failed["state"] == "failed" and error["kind"] == "engine"
    assert error["quantity"] and error["quantity"] in error["message"]
    assert error["unit"] and error["value"] is not None and error["bound"] > 0
    assert 0 < error["simulated_time"] < 3e-3 and error["step"] > 10
    assert 0 <= error["x"] <= 20e-6 and 0 < error["y"] < 10e-6 and error["cell"] == 0


def test_its_summary_is_of_what_it_computed(failed):
    summary = failed["summary"]
    assert summary["ending"] == "failed" and summary["steps"] == failed["error"]["step"] - 1
    assert summary["simulated_time"] < failed["error"]["simulated_time"]
    assert failed["progress"]["simulated_time"] == pytest.approx(summary["simulated_time"])
    assert summary["cells"][0]["greatest_strain"] > 1


def test_its_archive_is_whole(service, failed):
    path = f"/v1/jobs/{failed['id']}/archive.h5"
    answer = service.get(path)
    assert answer.status == 200
    assert answer.headers["ETag"] == f'"{hashlib.sha256(answer.body).hexdigest()}"'
    assert service.get(path, Range="bytes=0-99").body == answer.body[:100]
    assert failed["id"].encode() in service.get(path.replace(".h5", ".xdmf")).body
    with h5py.File(io.BytesIO(answer.body)) as archive:
        assert json.loads(archive["parameters/summary"].asstr()[()])["ending"] == "failed"


def test_its_series_frames_and_probes_answer_as_for_any_other(service, failed):
    path = f"/v1/jobs/{failed['id']}"
    rows = service.get(f"{path}/series?columns=time,cell0.perimeter").json()["rows"]
    assert rows[-1][1] > 2 * rows[0][1]
    assert failed["error"]["simulated_time"] - rows[-1][0] < 2.1e-5
    times = service.get(f"{path}/frames").json()["times"]
    last = service.get(f"{path}/frames/{len(times) - 1}").json()
    assert len(times) > 2 and len(last["particles"]["x"]) > 100 and len(last["outlines"][0]["x"]) > 10
    assert len(service.get(f"{path}/probes/across").json()["time"]) == len(rows)


def test_it_is_fetched_and_followed_from_the_command_line(service, failed, tmp_path):
    def call(*arguments):
        return subprocess.run([service.binary, *arguments, "--server", service.url], cwd=tmp_path,
                              capture_output=True, text=True, timeout=60)

    followed = call("wait", failed["id"])
    assert followed.returncode == 1 and failed["error"]["message"] in followed.stderr
    assert "went unstable" in followed.stdout and "cell 0: peak velocity" in followed.stdout
    assert failed["error"]["message"] in call("status", failed["id"]).stdout
    assert call("fetch", failed["id"], "-o", "got.h5").returncode == 0
    with h5py.File(tmp_path / "got.h5") as archive:
        assert "series" in archive


def test_one_that_cannot_be_undone(service, failed):
    answer = service.request("POST", f"/v1/jobs/{failed['id']}:cancel")
    assert answer.status == 409 and answer.json()["type"] == "/problems/invalid-transition"
    assert service.get("/v1/jobs?state=failed").json()["jobs"][0]["summary"]["ending"] == "failed"
