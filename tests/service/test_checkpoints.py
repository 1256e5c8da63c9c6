"""A job goes on from where it was, whatever stopped it, and comes to the same archive."""

import random
import time

import pytest
from rouleau_server import Server, endless, plasma
from same_archive import assert_same

often = ("--checkpoint-interval", "0.05")


def plasma_case():
    return plasma(duration=2.4e-2, output={"series_interval": 2e-5, "frame_interval": 2e-4},
                  probes=[{"name": "across", "from": [5e-6, 0], "to": [5e-6, 10e-6], "points": 3}])


def cell_case():
    return plasma(duration=5e-3, vessel={"length": 40e-6, "diameter": 10e-6}, cells=[{"x": 10e-6, "y": 5e-6, "diameter": 5e-6}],
                  output={"series_interval": 2e-5, "frame_interval": 2e-4})


def archive(server, job_id):
    return server.data / "archives" / f"{job_id}.h5"


def leftovers(server):
    return [path.name for path in server.data.glob("archives/*") if path.suffix not in (".h5", ".xdmf")]


def log_of(server, job_id):
    return server.get(f"/v1/jobs/{job_id}/log").body.decode()


def uninterrupted(server, case):
    job_id = server.submit(case)
    assert server.wait(job_id)["state"] == "succeeded"
    return archive(server, job_id)


def wait_for_steps(server, job_id, more_than):
    return server.wait(job_id, lambda job: job["ended_at"] or (job["progress"] or {"steps": 0})["steps"] > more_than)


@pytest.mark.parametrize("case", [plasma_case(), cell_case()], ids=["plasma", "cell"])
def test_a_drain_and_a_start_are_not_to_be_seen(tmp_path, case):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(case)
        steps = 0
        for _ in range(2):
            steps = wait_for_steps(server, job_id, steps + 20)["progress"]["steps"]
            begun = time.monotonic()
            assert server.terminate() == 0
            assert time.monotonic() - begun < 10
            assert (server.data / "archives" / f"{job_id}.h5.checkpoint").exists()
            server.start()
        job = server.wait(job_id)
        assert (job["state"], job["attempt"]) == ("succeeded", 3)
        assert log_of(server, job_id).count('event="goes on"') == 2
        assert leftovers(server) == []
        assert_same(archive(server, job_id), uninterrupted(server, case))


@pytest.mark.parametrize("case", [plasma_case(), cell_case()], ids=["plasma", "cell"])
def test_kill_nine_costs_no_more_than_since_the_last_checkpoint(tmp_path, case):
    source = random.Random(1)
    with Server(tmp_path / "data", workers=1, arguments=often) as server:
        job_id = server.submit(case)
        steps = 0
        for _ in range(3):
            steps = wait_for_steps(server, job_id, steps + 15)["progress"]["steps"]
            server.wait(job_id, lambda job: job["ended_at"] or leftovers(server).count(f"{job_id}.h5.checkpoint"))
            time.sleep(source.uniform(0, 0.1))
            server.kill_nine()
            server.start()
        job = server.wait(job_id)
        assert job["state"] == "succeeded"
        assert log_of(server, job_id).count('event="goes on"') == job["attempt"] - 1 >= 1
        assert leftovers(server) == []
        assert_same(archive(server, job_id), uninterrupted(server, case))


def test_a_paused_job_keeps_what_it_has_and_goes_on(tmp_path):
    case = cell_case()
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(case)
        wait_for_steps(server, job_id, 20)
        answer = server.request("POST", f"/v1/jobs/{job_id}:pause")
        assert answer.status == 202 and answer.json()["state"] == "running"
        paused = server.wait(job_id, lambda job: job["state"] != "running")
        assert paused["state"] == "paused" and paused["ended_at"] is None
        assert server.request("POST", f"/v1/jobs/{job_id}:pause").status == 200
        rows = server.get(f"/v1/jobs/{job_id}/series").json()["rows"]
        outlines = server.get(f"/v1/jobs/{job_id}/frames?fields=outlines").json()
        assert len(rows) > 1 and len(outlines["times"]) >= 1

        # Another process reads it from the disk.
        assert server.terminate() == 0
        server.start()
        assert server.job(job_id)["state"] == "paused"
        assert server.job(job_id)["progress"]["steps"] == paused["progress"]["steps"]
        assert server.get(f"/v1/jobs/{job_id}/series").json()["rows"] == rows
        assert server.get(f"/v1/jobs/{job_id}/frames?fields=outlines").json() == outlines
        assert server.get(f"/v1/jobs/{job_id}/frames/0").json()["particles"]["x"]

        answer = server.request("POST", f"/v1/jobs/{job_id}:resume")
        assert answer.status == 200 and answer.json()["state"] == "queued"
        assert server.wait(job_id)["state"] == "succeeded"
        assert server.get(f"/v1/jobs/{job_id}/series").json()["rows"][:len(rows)] == rows
        assert_same(archive(server, job_id), uninterrupted(server, case))


def test_what_was_shown_before_is_shown_while_it_goes_on(tmp_path):
    case = endless(output={"series_interval": 1e-5, "frame_interval": 1e-4})
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(case)
        wait_for_steps(server, job_id, 30)
        before = server.get(f"/v1/jobs/{job_id}/series").json()["rows"]
        assert server.terminate() == 0
        server.start()
        server.wait_until_running(job_id)
        server.wait(job_id, lambda _: server.get(f"/v1/jobs/{job_id}/series").json()["rows"][:len(before)] == before)
        server.request("POST", f"/v1/jobs/{job_id}:cancel")
        assert server.wait(job_id)["state"] == "cancelled"
        assert leftovers(server) == []


def spoil(path):
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


@pytest.mark.parametrize("suffix,how", [(".h5.checkpoint", spoil), (".h5.part", lambda path: path.unlink()),
                                        (".h5.part", lambda path: path.write_bytes(path.read_bytes()[:5000]))],
                         ids=["a bit of the checkpoint", "no archive", "half an archive"])
def test_what_cannot_be_gone_on_from_is_thrown_away(tmp_path, suffix, how):
    case = plasma_case()
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(case)
        wait_for_steps(server, job_id, 30)
        server.terminate()
        how(server.data / "archives" / f"{job_id}{suffix}")
        server.start()
        assert server.wait(job_id)["state"] == "succeeded"
        log = log_of(server, job_id)
        assert 'event="begins anew" because=' in log and 'event="goes on"' not in log
        assert leftovers(server) == []
        assert_same(archive(server, job_id), uninterrupted(server, case))


def test_leftovers_of_no_waiting_job_are_removed_at_the_start(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        ended = server.submit(plasma())
        server.wait(ended)
        server.terminate()
        for name in (f"{ended}.h5.part", f"{ended}.h5.checkpoint", "x.h5.part", f"{ended}.xdmf.part", "x.h5.before"):
            (server.data / "archives" / name).write_text("left")
        server.start()
        assert leftovers(server) == []
        assert archive(server, ended).exists()
