"""What is removed to make room, what is not, and what a client is told."""

import time

from rouleau_server import Server, endless, plasma

LOOKING = ("--retention-interval", "0.2")


def until(done, patience=20):
    deadline = time.monotonic() + patience
    while not done():
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_jobs_beyond_their_age_are_gone_with_their_files(tmp_path):
    with Server(tmp_path / "data", arguments=("--keep-days", "0.00001", *LOOKING)) as server:
        going_on = server.submit(endless())
        done = server.submit(plasma(duration=1e-5))
        until(lambda: server.get(f"/v1/jobs/{done}").status == 410)
        assert server.get(f"/v1/jobs/{done}").json()["type"] == "/problems/expired"
        assert server.get(f"/v1/jobs/{done}/archive.h5").status == 410
        assert server.job(going_on)["state"] == "running"
        assert [path.name for path in (server.data / "archives").iterdir() if path.name.startswith(done)] == []
        assert [job["id"] for job in server.get("/v1/jobs").json()["jobs"]] == [going_on]
        assert 'event="old jobs removed"' in server.log()


def test_archives_beyond_their_room_are_gone(tmp_path):
    with Server(tmp_path / "data", arguments=("--max-archive-space", "1B", *LOOKING)) as server:
        server.request("POST", "/v1/queue:pause")
        first, second = (server.submit(plasma(duration=duration)) for duration in (1e-5, 2e-5))
        server.request("POST", "/v1/queue:resume")
        until(lambda: {server.get(f"/v1/jobs/{job}").status for job in (first, second)} == {410})
        assert server.request("POST", "/v1/jobs", {"case": plasma(duration=3e-5)}).status == 202


def test_no_room_on_the_disk_lets_no_job_in(tmp_path):
    with Server(tmp_path / "data", arguments=("--min-free", "1000TB", *LOOKING)) as server:
        answer = server.request("POST", "/v1/jobs", {"case": plasma()})
        assert answer.status == 503 and answer.json()["type"] == "/problems/no-space"
        assert "--min-free" in answer.json()["detail"] and int(answer.headers["Retry-After"]) > 0
        assert server.get("/problems/no-space").status == 200
