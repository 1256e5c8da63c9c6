"""What happens to the machine under the service: a disk that is full, a crash, a clock that steps back, a worker's error."""

import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading
import time

import h5py
import pytest

from rouleau_server import Server, plasma

HERE = pathlib.Path(__file__).parent
FAKETIME = "/usr/lib/x86_64-linux-gnu/faketime/libfaketimeMT.so.1"


def test_the_disk_is_full_at_some_places_of_a_jobs_life(tmp_path):
    result = subprocess.run([sys.executable, HERE / "full_disk.py", "--binary", os.environ["ROULEAU_BINARY"], "--library",
                             os.environ["ROULEAU_FULL_DISK"], "--places", "3", "--folder", tmp_path], capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    found = json.loads(result.stdout)
    assert found["hit"] == 3 and found["calls_failed"] >= 3 and found["refused while full"] >= 3


def test_an_image_of_the_disk_at_any_instant_is_whole(tmp_path):
    """As a pulled plug leaves it: every job that was accepted by then is in it, and runs."""
    with Server(tmp_path / "data") as server:
        accepted, images = [], []
        over = threading.Event()

        def submit(client):
            while not over.is_set():
                accepted.append(server.submit(plasma(duration=1e-6 * (len(accepted) + 1), name=f"{client} {len(accepted)}")))

        clients = [threading.Thread(target=submit, args=(client,)) for client in range(3)]
        for client in clients:
            client.start()
        for k in range(6):
            time.sleep(0.03 * (k + 1))
            server.process.send_signal(signal.SIGSTOP)
            known = list(accepted)
            shutil.copytree(server.data, tmp_path / f"image{k}")
            server.process.send_signal(signal.SIGCONT)
            images.append((tmp_path / f"image{k}", known))
        over.set()
        for client in clients:
            client.join()
    for image, known in images:
        database = sqlite3.connect(image / "jobs.sqlite")
        assert database.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        assert database.execute("PRAGMA foreign_key_check").fetchall() == []
        assert {row[0] for row in database.execute("SELECT id FROM jobs")} >= set(known)
        database.close()
    image, known = images[-1]
    with Server(image) as server:
        for job in known:
            assert server.wait(job)["state"] == "succeeded"
            answer = server.get(f"/v1/jobs/{job}/archive.h5")
            assert answer.status == 200 and answer.body[:4] == b"\x89HDF"
        assert server.terminate() == 0


@pytest.mark.skipif(not pathlib.Path(FAKETIME).exists(), reason="there is no libfaketime")
def test_the_clock_steps_back(tmp_path, monkeypatch):
    clock = tmp_path / "clock"
    clock.write_text("+0")
    for name, value in {"LD_PRELOAD": FAKETIME, "FAKETIME_TIMESTAMP_FILE": str(clock), "FAKETIME_NO_CACHE": "1",
                        "FAKETIME_DONT_FAKE_MONOTONIC": "1"}.items():
        monkeypatch.setenv(name, value)
    with Server(tmp_path / "data") as server:
        monkeypatch.undo()
        before = [server.submit(plasma(duration=2e-2 + 1e-9 * k)) for k in range(4)]
        server.wait_until_running(before[0])
        clock.write_text("-2h")
        after = [server.submit(plasma(duration=1e-5 + 1e-9 * k)) for k in range(4)]
        for job in before + after:
            done = server.wait(job)
            assert done["state"] == "succeeded" and done["attempt"] == 1, done
        listed = [job["id"] for job in server.get("/v1/jobs").json()["jobs"]]
        assert listed == list(reversed(before + after)), "in the order of submission, whatever the clock says"
        assert server.job(after[0])["created_at"] < server.job(before[0])["created_at"]
        assert server.terminate() == 0


class TestWorker:
    def test_what_it_cannot_write_is_tried_again(self, tmp_path):
        with Server(tmp_path / "data") as server:
            server.request("POST", "/v1/queue:pause")
            job = server.submit(plasma(duration=1e-5))
            in_the_way = server.data / "archives" / f"{job}.h5.part"
            in_the_way.mkdir()
            (in_the_way / "file").touch()
            server.request("POST", "/v1/queue:resume")
            server.wait(job, lambda job: job["state"] == "queued" and job["attempt"] == 1)
            shutil.rmtree(in_the_way)
            done = server.wait(job)
            assert done["state"] == "succeeded" and done["attempt"] == 2
            assert 'event="job will be tried again"' in server.log()

    def test_half_an_archive_is_not_taken_for_one(self, tmp_path):
        with Server(tmp_path / "data") as server:
            job = server.submit(plasma(duration=2e-2))
            server.wait_until_running(job)
            server.kill_nine()
            part = server.data / "archives" / f"{job}.h5.part"
            assert part.exists()
            content = part.read_bytes()
            part.write_bytes(content[:len(content) // 2] + b"half of it")
            (server.data / "archives" / f"{job}.h5.checkpoint").write_bytes(b"half a checkpoint")
            server.start()
            done = server.wait(job)
            assert done["state"] == "succeeded"
            with h5py.File(server.data / "archives" / f"{job}.h5") as archive:
                assert "series" in archive
            assert server.terminate() == 0
            left = {path.suffix for path in (server.data / "archives").iterdir()}
            assert left == {".h5", ".xdmf"}
