"""What can be asked of a job, and in which states."""

import pytest
from rouleau_server import Server, endless, plasma, unstable

actions = ("cancel", "pause", "resume", "retry", "delete")


def ask(server, job_id, action):
    if action == "delete":
        return server.request("DELETE", f"/v1/jobs/{job_id}")
    return server.request("POST", f"/v1/jobs/{job_id}:{action}")


@pytest.fixture(scope="module")
def service(tmp_path_factory):
    with Server(tmp_path_factory.mktemp("actions") / "data", workers=1) as server:
        yield server


@pytest.fixture(scope="module")
def one_of_each(service):
    """A job in each state; the only worker is busy with the running one."""
    jobs = {"succeeded": service.submit(plasma()), "failed": service.submit(unstable())}
    for job_id in jobs.values():
        service.wait(job_id)
    jobs["running"] = service.submit(endless())
    service.wait_until_running(jobs["running"])
    for name in ("queued", "paused", "cancelled"):
        jobs[name] = service.submit(endless(name=name, vessel={"length": 22e-6, "diameter": 10e-6}))
    assert ask(service, jobs["paused"], "pause").status == 200
    assert ask(service, jobs["cancelled"], "cancel").status == 200
    assert {name: service.job(job_id)["state"] for name, job_id in jobs.items()} == {name: name for name in jobs}
    return jobs


refused = [("queued", "retry"), ("queued", "delete"), ("running", "retry"), ("running", "delete"), ("paused", "retry"),
           ("paused", "delete"), ("succeeded", "cancel"), ("succeeded", "pause"), ("succeeded", "resume"), ("succeeded", "retry"),
           ("failed", "cancel"), ("failed", "pause"), ("failed", "resume"), ("cancelled", "pause"), ("cancelled", "resume")]


@pytest.mark.parametrize("state,action", refused)
def test_what_a_state_does_not_allow(service, one_of_each, state, action):
    answer = ask(service, one_of_each[state], action)
    assert answer.status == 409, answer.body
    problem = answer.json()
    assert problem["type"] == "/problems/invalid-transition"
    assert problem["detail"].startswith(f"the job is {state} and cannot be ")
    assert "; it can be " in problem["detail"]
    assert service.job(one_of_each[state])["state"] == state


@pytest.mark.parametrize("action", actions)
def test_a_job_that_there_is_not(service, action):
    answer = ask(service, "01900000-0000-7000-8000-000000000000", action)
    assert answer.status == 404 and answer.json()["type"] == "/problems/not-found"


def test_asking_for_the_same_again_changes_nothing(service, one_of_each):
    assert ask(service, one_of_each["paused"], "pause").json()["state"] == "paused"
    assert ask(service, one_of_each["cancelled"], "cancel").json()["state"] == "cancelled"
    assert ask(service, one_of_each["queued"], "resume").json()["state"] == "queued"


def test_a_paused_job_can_be_cancelled(service):
    job_id = service.submit(endless(vessel={"length": 24e-6, "diameter": 10e-6}), priority=-1)
    assert ask(service, job_id, "pause").json()["state"] == "paused"
    answer = ask(service, job_id, "cancel")
    assert answer.status == 200 and answer.json()["state"] == "cancelled"


def test_an_ended_job_is_deleted_with_its_files(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(plasma())
        server.wait(job_id)
        assert list(server.data.rglob(f"{job_id}*"))
        answer = ask(server, job_id, "delete")
        assert (answer.status, answer.body) == (204, b"")
        assert not list(server.data.rglob(f"{job_id}*"))
        for path in ("", "/series", "/log", "/events", "/archive.h5"):
            assert server.get(f"/v1/jobs/{job_id}{path}").status == 404
        assert ask(server, job_id, "delete").status == 404
        assert server.get("/v1/jobs").json()["jobs"] == []


def test_an_archive_that_two_jobs_share_goes_with_the_last(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        first = server.submit(plasma())
        server.wait(first)
        second = server.submit(plasma(name="the same again"), fresh=False)
        assert server.job(second)["result_of"] == first
        assert ask(server, first, "delete").status == 204
        assert server.get(f"/v1/jobs/{second}/archive.h5").status == 200
        assert len(server.get(f"/v1/jobs/{second}/series").json()["rows"]) > 1
        assert ask(server, second, "delete").status == 204
        assert not list(server.data.glob("archives/*"))


def test_a_cancelled_job_is_tried_again(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(plasma(duration=1e-2))
        server.wait_until_running(job_id)
        ask(server, job_id, "cancel")
        assert server.wait(job_id)["state"] == "cancelled"
        answer = ask(server, job_id, "retry")
        assert answer.status == 200 and answer.json()["state"] in ("queued", "running")
        assert answer.json()["ended_at"] is None
        job = server.wait(job_id)
        assert (job["state"], job["attempt"]) == ("succeeded", 2)


def test_a_failed_job_is_tried_again(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(unstable())
        failed = server.wait(job_id)
        assert ask(server, job_id, "retry").json()["error"] is None
        again = server.wait(job_id)
        assert again["attempt"] == 2 and again["error"] == failed["error"]
        assert server.get(f"/v1/jobs/{job_id}/archive.h5").status == 200
        log = server.get(f"/v1/jobs/{job_id}/log").body.decode()
        assert log.count("event=failed kind=engine") == 2 and 'event="asked to be retried"' in log


def test_cancelling_overrides_pausing(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(endless())
        server.wait_until_running(job_id)
        ask(server, job_id, "pause")
        ask(server, job_id, "cancel")
        assert server.wait(job_id)["state"] == "cancelled"
        assert not list(server.data.glob("archives/*"))


def test_a_pause_is_not_lost_by_a_crash(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        job_id = server.submit(endless())
        server.wait_until_running(job_id)
        ask(server, job_id, "pause")
        server.kill_nine()
        server.start()
        assert server.wait(job_id, lambda job: job["state"] != "running")["state"] == "paused"
