"""A job from its submission to its end, over HTTP."""

import math
import re

import pytest
from rouleau_server import endless, plasma

uuid7 = re.compile(r"^[0-9a-f]{8}-[0-9a-f]{4}-7[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$")
rfc3339 = re.compile(r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")


@pytest.fixture(scope="module")
def finished(server):
    job_id = server.submit(plasma(output={"series_interval": 2e-5, "frame_interval": 5e-5}))
    job = server.wait(job_id)
    assert job["state"] == "succeeded", job
    return job


def test_a_submitted_job_is_accepted_with_its_address(server):
    answer = server.request("POST", "/v1/jobs", {"case": plasma(), "priority": -3, "labels": {"study": "a"}})
    job = answer.json()
    assert answer.status == 202
    assert answer.headers["Location"] == f"/v1/jobs/{job['id']}"
    assert uuid7.match(job["id"])
    assert rfc3339.match(job["created_at"])
    assert (job["state"], job["priority"], job["labels"], job["name"]) == ("queued", -3, {"study": "a"}, "short plasma")
    assert any(effect["on"] for effect in job["plan"]["effects"])
    assert job["case"]["plasma"]["density"] == 1000
    server.wait(job["id"])


def test_a_finished_job_says_how_it_ended(finished):
    assert finished["attempt"] == 1
    assert finished["error"] is None
    assert finished["summary"]["ending"] == "completed"
    assert math.isclose(finished["summary"]["simulated_time"], 1e-4, rel_tol=1e-6)
    assert rfc3339.match(finished["started_at"]) and rfc3339.match(finished["ended_at"])
    assert finished["progress"]["fraction"] == pytest.approx(1)


def test_series_as_json(server, finished):
    series = server.get(f"/v1/jobs/{finished['id']}/series").json()
    assert series["columns"][0] == "time"
    assert series["units"]["time"] == "s"
    times = [row[0] for row in series["rows"]]
    assert times == sorted(times) and times[0] == 0 and times[-1] == pytest.approx(1e-4)
    assert all(len(row) == len(series["columns"]) for row in series["rows"])


def test_series_as_csv(server, finished):
    path = f"/v1/jobs/{finished['id']}/series?columns=time,inflow"
    answer = server.get(path, Accept="text/csv")
    assert answer.headers["Content-Type"].startswith("text/csv")
    lines = answer.body.decode().splitlines()
    assert lines[0] == "time,inflow"
    rows = [[float(value) for value in line.split(",")] for line in lines[1:]]
    assert rows == server.get(path).json()["rows"]


def test_series_after_a_time_and_downsampled(server, finished):
    path = f"/v1/jobs/{finished['id']}/series"
    rows = server.get(path).json()["rows"]
    middle = rows[1][0]
    assert server.get(f"{path}?after={middle!r}").json()["rows"] == rows[2:]
    few = server.get(f"{path}?columns=time&max_points=3").json()["rows"]
    assert len(few) <= 4 and few[0][0] == rows[0][0] and few[-1][0] == rows[-1][0]


def test_series_of_unknown_columns(server, finished):
    answer = server.get(f"/v1/jobs/{finished['id']}/series?columns=time,nope,neither")
    assert answer.status == 400
    assert answer.json()["type"] == "/problems/unknown-column"
    assert len(answer.json()["errors"]) == 2
    answer = server.get(f"/v1/jobs/{finished['id']}/series?columns=time,time")
    assert (answer.status, answer.json()["type"]) == (400, "/problems/invalid-request")


def test_frames(server, finished):
    path = f"/v1/jobs/{finished['id']}/frames"
    times = server.get(path).json()["times"]
    assert len(times) >= 3 and times[0] == 0
    frame = server.get(f"{path}/1").json()
    particles = frame["particles"]
    assert frame["time"] == times[1]
    assert len(particles["x"]) > 100
    assert {len(particles[name]) for name in ("x", "y", "u", "v", "p", "kind", "cell", "id")} == {len(particles["x"])}
    assert "particles" not in server.get(f"{path}/1?fields=outlines").json()
    assert server.get(f"{path}?fields=outlines&from=1").json()["outlines"] == [[]] * (len(times) - 1)
    for k in (str(len(times)), "-1", "x", "99999999999999999999"):
        assert server.get(f"{path}/{k}").status == 404


def test_a_running_job_shows_what_it_has(server):
    # So long a vessel that the cell does not reach its end meanwhile.
    scene = endless(duration=0.05, vessel={"length": 2e-4, "diameter": 10e-6}, cells=[{"x": 8e-6, "y": 5e-6, "diameter": 4e-6}],
                    output={"series_interval": 1e-6, "frame_interval": 1e-6})
    job_id = server.submit(scene)
    job = server.wait_until_running(job_id)
    assert 0 <= job["progress"]["fraction"] < 1
    server.wait(job_id, lambda _: len(server.get(f"/v1/jobs/{job_id}/frames").json()["times"]) >= 2)
    series = server.get(f"/v1/jobs/{job_id}/series?columns=time,cell0.u").json()
    assert series["columns"] == ["time", "cell0.u"] and len(series["rows"]) >= 1
    frames = server.get(f"/v1/jobs/{job_id}/frames?fields=outlines").json()
    assert len(frames["outlines"][0]) == 1 and len(frames["outlines"][0][0]["x"]) > 10
    assert server.get(f"/v1/jobs/{job_id}").headers["Retry-After"]
    assert server.get(f"/v1/jobs/{job_id}/archive.h5").json()["type"] == "/problems/not-finished"

    cancelled = server.request("POST", f"/v1/jobs/{job_id}:cancel")
    assert cancelled.status == 202 and cancelled.json()["state"] == "cancelling"
    assert server.wait(job_id)["state"] == "cancelled"
    again = server.request("POST", f"/v1/jobs/{job_id}:cancel")
    assert again.status == 200 and again.json()["state"] == "cancelled"
    assert len(server.get(f"/v1/jobs/{job_id}/series").json()["rows"]) >= 1, "what it had is kept a while"
    assert not list(server.data.glob(f"archives/{job_id}*"))


def test_a_queued_job_is_cancelled_at_once(server):
    running = [server.submit(endless(), priority=5) for _ in range(2)]
    for job_id in running:
        server.wait_until_running(job_id)
    queued = server.submit(plasma())
    answer = server.request("POST", f"/v1/jobs/{queued}:cancel")
    assert answer.status == 200 and answer.json()["state"] == "cancelled"
    for job_id in running:
        server.request("POST", f"/v1/jobs/{job_id}:cancel")
    for job_id in running:
        server.wait(job_id)


def test_a_job_that_succeeded_cannot_be_cancelled(server, finished):
    answer = server.request("POST", f"/v1/jobs/{finished['id']}:cancel")
    assert answer.status == 409 and answer.json()["type"] == "/problems/invalid-transition"


def test_waiting_for_a_change_of_state(server):
    job_id = server.submit(plasma())
    states = {server.get(f"/v1/jobs/{job_id}?wait=30s").json()["state"] for _ in range(3)}
    assert "succeeded" in states
    assert server.get(f"/v1/jobs/{job_id}?wait=soon").status == 400


def test_an_unchanged_job_is_not_sent_again(server, finished):
    path = f"/v1/jobs/{finished['id']}"
    etag = server.get(path).headers["ETag"]
    again = server.get(path, If_None_Match=etag)
    assert again.status == 304 and again.body == b""
    assert server.get(path, If_None_Match='"other"').status == 200


def test_the_list_is_newest_first_and_in_pages(server):
    ids = [server.submit(plasma(), labels={"list": "x:y"}) for _ in range(5)]
    seen, token = [], ""
    while token is not None:
        page = server.get(f"/v1/jobs?label=list:x%3Ay&page_size=2&page_token={token}").json()
        assert len(page["jobs"]) <= 2
        seen += [job["id"] for job in page["jobs"]]
        token = page.get("next_page_token")
    assert seen == ids[::-1]
    for job_id in ids:
        server.wait(job_id)
    found = server.get("/v1/jobs?state=succeeded,failed&label=list:x:y").json()["jobs"]
    assert {job["id"] for job in found} == set(ids)
    assert server.get("/v1/jobs?state=failed&label=list:x:y").json()["jobs"] == []


@pytest.mark.parametrize("query", ["state=done", "label=x", "page_size=0", "page_size=1001", "page_size=x",
                                   "page_token=nonsense", "sort=name", "page_size=1&page_size=2"])
def test_a_query_that_makes_no_sense(server, query):
    answer = server.get(f"/v1/jobs?{query}")
    assert answer.status == 400
    assert answer.json()["type"] == "/problems/invalid-request"
    assert answer.json()["errors"][0]["pointer"].startswith("?")


def test_every_fault_of_a_case_is_reported_at_once(server):
    case = plasma(vessel={"length": -1, "diamter": 1e-5}, duration="long")
    answer = server.request("POST", "/v1/jobs", {"case": case, "priority": 1000})
    problem = answer.json()
    assert answer.status == 422
    assert problem["type"] == "/problems/invalid-case"
    assert {"/case/vessel/length", "/case/vessel/diamter", "/case/vessel/diameter", "/case/duration",
            "/priority"} <= {error["pointer"] for error in problem["errors"]}
    assert problem["request_id"] == answer.headers["X-Request-Id"]


@pytest.mark.parametrize("body", [b"{}", b"[]", b"7", b'{"case": {}, "x": 1}'])
def test_a_body_that_is_no_job(server, body):
    answer = server.request("POST", "/v1/jobs", body, {"Content-Type": "application/json"})
    assert answer.status in (400, 422) and answer.json()["errors"]


@pytest.mark.parametrize("body", [b"", b"{", b'{"case": {}, "case": {}}', b"[" * 100000, b'{"case": NaN}', b'"\xff"'])
def test_a_body_that_is_no_json(server, body):
    answer = server.request("POST", "/v1/jobs", body, {"Content-Type": "application/json"})
    assert answer.status == 400 and answer.json()["type"] == "/problems/invalid-json"


def test_validation(server):
    answer = server.request("POST", "/v1/cases:validate", plasma())
    assert answer.status == 200
    assert answer.json()["case"]["inflow"]["velocity"] == 0.005
    job = server.job(server.submit(plasma()))
    assert answer.json()["case_hash"] == job["case_hash"]
    server.wait(job["id"])
    assert server.request("POST", "/v1/cases:plan", plasma(duration=-1)).status == 422
    answer = server.request("POST", "/v1/cases:validate", plasma(duration=-1))
    assert answer.status == 422 and answer.json()["errors"][0]["pointer"] == "/duration"


def test_the_description_names_the_methods_of_every_path(server):
    for pattern, operations in server.get("/openapi.json").json()["paths"].items():
        answer = server.request("OPTIONS", re.sub(r"\{\w+\}", "x", pattern))
        assert answer.status == 405, pattern
        described = {method.upper() for method in operations if method != "parameters"}
        assert set(answer.headers["Allow"].split(", ")) - {"HEAD"} == described, pattern


def test_what_the_server_says_of_itself(server):
    assert server.get("/v1/schema/case.json").json()["type"] == "object"
    description = server.get("/openapi.json").json()
    assert description["openapi"].startswith("3.1")
    page = server.get("/problems/invalid-case")
    assert page.status == 200 and b"invalid-case" in page.body
    assert server.get("/problems/none").status == 404
    assert server.health("/livez").status == 200 and server.health("/readyz").status == 200
