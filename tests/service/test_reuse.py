"""One result for the same case, one job for the same key, and turns between lanes."""

import concurrent.futures
import time

import pytest

from rouleau_server import Server, endless, plasma


@pytest.fixture()
def server(tmp_path):
    with Server(tmp_path / "data", workers=2) as running:
        yield running


def submit(server, case, key=None, **members):
    headers = {"Idempotency-Key": key} if key else {}
    return server.request("POST", "/v1/jobs", {"case": case, **members}, headers)


def test_the_same_case_is_answered_at_once(server):
    first = server.wait(server.submit(plasma(name="first")))
    answer = submit(server, plasma(name="another name"))
    assert answer.status == 202
    second = answer.json()
    assert second["state"] == "succeeded"
    assert second["result_of"] == first["id"] and first["result_of"] is None
    assert second["summary"] == first["summary"]
    assert second["case_hash"] == first["case_hash"]
    assert second["case"]["name"] == "another name"
    one, other = (server.get(f"/v1/jobs/{job['id']}/archive.h5") for job in (first, second))
    assert one.body == other.body and one.headers["ETag"] == other.headers["ETag"]
    sidecar = server.get(f"/v1/jobs/{second['id']}/archive.xdmf").body.decode()
    assert second["id"] + ".h5" in sidecar and first["id"] not in sidecar
    assert server.get(f"/v1/jobs/{second['id']}/series").json() == server.get(f"/v1/jobs/{first['id']}/series").json()


def test_fresh_computes_it_again(server):
    first = server.wait(server.submit(plasma()))
    again = server.wait(server.submit(plasma(), fresh=True))
    assert again["result_of"] is None and again["attempt"] == 1
    assert again["summary"]["steps"] == first["summary"]["steps"]
    answer = submit(server, plasma(), fresh="yes")
    assert answer.status == 400 and answer.json()["errors"][0]["pointer"] == "/fresh"


def test_two_at_the_same_time_run_once(server):
    running = server.submit(endless())
    server.wait_until_running(running)
    waiting = server.submit(endless(name="the same"), fresh=False)
    other = server.wait(server.submit(plasma()))
    assert other["state"] == "succeeded", "a worker was left for it"
    assert server.job(waiting)["state"] == "queued"
    server.request("POST", f"/v1/jobs/{running}:cancel")
    server.wait_until_running(waiting)


def test_a_replayed_key_gives_the_first_answer(server):
    first = submit(server, plasma(), "key-1")
    server.wait(first.json()["id"])
    again = submit(server, plasma(), "key-1")
    assert (again.status, again.headers["Location"]) == (202, first.headers["Location"])
    assert again.json() == first.json()
    assert again.headers["Idempotency-Replayed"] == "true" and "Idempotency-Replayed" not in first.headers
    assert len(server.get("/v1/jobs").json()["jobs"]) == 1


def test_a_key_for_another_body_is_refused(server):
    submit(server, plasma(), "key-1")
    answer = submit(server, plasma(duration=2e-4), "key-1")
    assert (answer.status, answer.json()["type"]) == (422, "/problems/idempotency-mismatch")


@pytest.mark.parametrize("key", ["with blank", "x" * 256, "\xe9"])
def test_bad_keys_are_refused(server, key):
    assert submit(server, plasma(), key).status == 400


def test_a_key_sent_many_times_at_once_makes_one_job(server):
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda _: submit(server, plasma(), "key-1"), range(24)))
    assert {answer.status for answer in answers} <= {202, 409}
    assert {answer.json()["type"] for answer in answers if answer.status == 409} <= {"/problems/idempotency-in-progress"}
    assert len({answer.json()["id"] for answer in answers if answer.status == 202}) == 1


def test_the_queue_is_paused_and_resumed(server):
    assert server.get("/v1/queue").json()["paused"] is False
    assert server.request("POST", "/v1/queue:pause").json()["paused"] is True
    job = server.submit(plasma())
    queue = server.get("/v1/queue").json()
    assert queue["depth"] == 1 and queue["states"]["queued"] == 1 and queue["workers"] == 2
    assert queue["oldest_waiting"] == server.job(job)["created_at"] and queue["oldest_age_s"] >= 0
    server.terminate()
    server.start()
    assert server.get("/v1/queue").json()["paused"] is True
    assert server.job(job)["state"] == "queued"
    server.request("POST", "/v1/queue:resume")
    assert server.wait(job)["state"] == "succeeded"


def test_a_full_queue_says_so(tmp_path):
    with Server(tmp_path / "data", arguments=["--max-queued", "2"]) as server:
        server.request("POST", "/v1/queue:pause")
        for k in range(2):
            server.submit(plasma(duration=1e-4 * (k + 1)))
        answer = submit(server, plasma(duration=1e-3))
        assert (answer.status, answer.json()["type"]) == (503, "/problems/queue-full")
        assert int(answer.headers["Retry-After"]) > 0
        sweep = {"case": plasma(), "axes": [{"pointer": "/duration", "values": [4e-4, 5e-4, 6e-4]}]}
        answer = server.request("POST", "/v1/sweeps", sweep)
        assert (answer.status, answer.json()["type"]) == (422, "/problems/sweep-too-large"), "it would never fit"


def test_who_waits_for_a_resumed_job_is_told_that_its_result_has_come(server):
    running = server.submit(endless())
    server.request("POST", "/v1/queue:pause")
    first, second = (server.submit(plasma(duration=7e-5), fresh=False) for _ in range(2))
    server.request("POST", f"/v1/jobs/{second}:pause")
    server.request("POST", "/v1/queue:resume")
    server.wait(first)
    begun = time.monotonic()
    server.request("POST", f"/v1/jobs/{second}:resume")
    while server.get(f"/v1/jobs/{second}?wait=30s").json()["state"] != "succeeded":
        assert time.monotonic() < begun + 20
    server.request("POST", f"/v1/jobs/{running}:cancel")


def test_what_was_accepted_is_answered_again_while_the_queue_is_full(tmp_path):
    with Server(tmp_path / "data", arguments=["--max-queued", "2"]) as server:
        server.request("POST", "/v1/queue:pause")
        job = submit(server, plasma(), "job-1")
        body = {"case": plasma(duration=2e-4), "axes": [{"pointer": "/duration", "values": [2e-4]}]}
        sweep = server.request("POST", "/v1/sweeps", body, {"Idempotency-Key": "sweep-1"})
        assert submit(server, plasma(duration=3e-4)).status == 503
        assert submit(server, plasma(), "job-1").json() == job.json()
        again = server.request("POST", "/v1/sweeps", body, {"Idempotency-Key": "sweep-1"})
        assert (again.status, again.json()["id"]) == (202, sweep.json()["id"])


def test_lanes_take_turns(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        server.request("POST", "/v1/queue:pause")
        busy = [server.submit(plasma(duration=1e-5 * (k + 1)), labels={"lane": "busy"}) for k in range(4)]
        other = server.submit(plasma(duration=9e-5), labels={"lane": "other"})
        server.request("POST", "/v1/queue:resume")
        started = {job: server.wait(job)["started_at"] for job in [*busy, other]}
        assert sorted(started, key=started.get).index(other) <= 1
