"""How the service begins and ends, well and badly."""

import json
import subprocess
import threading

import h5py
from rouleau_server import Server, endless, plasma


def test_draining_gives_running_jobs_back(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        running = server.submit(endless(), priority=1)
        queued = server.submit(plasma())
        server.wait_until_running(running)
        states = []
        waiter = threading.Thread(target=lambda: states.append(server.get(f"/v1/jobs/{queued}?wait=30s").status))
        waiter.start()
        assert server.terminate() == 0
        waiter.join()

        server.start()
        assert server.job(running)["attempt"] >= 1
        server.request("POST", f"/v1/jobs/{running}:cancel")
        assert server.wait(running)["state"] == "cancelled"
        assert server.wait(queued)["state"] == "succeeded"
        assert server.terminate() == 0


def test_a_job_survives_kill_nine(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(plasma(duration=1e-2, output={"frame_interval": 2.5e-5}))
        server.wait_until_running(job_id)
        server.kill_nine()
        assert list(server.data.glob("archives/*.part"))

        server.start()
        job = server.wait(job_id)
        assert (job["state"], job["attempt"]) == ("succeeded", 2)
        assert {path.suffix for path in server.data.glob("archives/*")} == {".h5", ".xdmf"}
        with h5py.File(server.data / "archives" / f"{job_id}.h5") as archive:
            assert "series" in archive
        assert server.terminate() == 0
        assert server.log().count('event="job succeeded"') == 1


def test_a_cancellation_survives_kill_nine(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(endless())
        server.wait_until_running(job_id)
        server.request("POST", f"/v1/jobs/{job_id}:cancel")
        server.kill_nine()
        server.start()
        assert server.wait(job_id)["state"] == "cancelled"


def test_a_taken_port_is_said_clearly(tmp_path, server):
    command = [server.binary, "serve", "--port", str(server.port), "--health-port", "0", "--data", str(tmp_path / "data")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30)
    assert done.returncode == 1
    assert f"cannot listen on 127.0.0.1:{server.port}: Address already in use" in done.stderr


def test_a_data_folder_has_one_server(server):
    command = [server.binary, "serve", "--port", "0", "--health-port", "0", "--data", str(server.data)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30)
    assert done.returncode == 1 and done.stderr.startswith("error: ")
    assert server.get("/v1/jobs").status == 200


def test_what_the_log_says(tmp_path):
    with Server(tmp_path / "data") as server:
        answer = server.request("POST", "/v1/jobs", {"case": plasma(name='a level=error "b"')})
        server.wait(answer.json()["id"])
        server.terminate()
        lines = server.log().splitlines()
        accepted = [line for line in lines if 'event="job accepted"' in line]
        assert len(accepted) == 1
        assert f"request={answer.headers['X-Request-Id']}" in accepted[0]
        assert json.dumps('a level=error "b"') in accepted[0]
