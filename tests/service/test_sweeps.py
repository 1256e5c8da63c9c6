"""Sweeps over HTTP."""

import csv
import io
import threading

import pytest
from rouleau_server import Server, endless, plasma, unstable


def velocities(*values):
    return {"pointer": "/inflow/velocity", "values": list(values)}


def submit(server, body, **headers):
    answer = server.request("POST", "/v1/sweeps", body, headers)
    assert answer.status == 202, answer.body
    return answer.json()


def wait(server, sweep_id, patience=60):
    for _ in range(patience):
        sweep = server.get(f"/v1/sweeps/{sweep_id}?wait=1s").json()
        if sweep["active"] == 0:
            return sweep
    raise AssertionError(sweep)


@pytest.fixture(scope="module")
def finished(server):
    body = {"name": "a grid", "case": plasma(cells=[{"x": 10e-6, "y": 5e-6, "diameter": 4e-6}]), "labels": {"study": "grid"},
            "axes": [velocities(0.001, 0.002), {"pointer": "/plasma/density", "from": 1000, "to": 1050, "count": 2}]}
    return wait(server, submit(server, body)["id"])


def test_a_sweep_is_its_jobs(server, finished):
    assert finished["counts"]["succeeded"] == 4 and sum(finished["counts"].values()) == 4
    assert (finished["name"], finished["labels"], finished["mode"]) == ("a grid", {"study": "grid"}, "grid")
    assert [job["values"] for job in finished["jobs"]] == [[0.001, 1000], [0.001, 1050], [0.002, 1000], [0.002, 1050]]
    assert [job["index"] for job in finished["jobs"]] == [0, 1, 2, 3]
    job = server.job(finished["jobs"][3]["id"])
    assert job["sweep"] == finished["id"] and job["labels"] == {"study": "grid"} and job["name"].endswith("#3")
    assert (job["case"]["inflow"]["velocity"], job["case"]["plasma"]["density"]) == (0.002, 1050)
    assert any(effect["on"] for effect in job["plan"]["effects"]), "planned when it is looked at"
    listed = server.get(f"/v1/jobs?sweep={finished['id']}").json()["jobs"]
    assert [job["id"] for job in listed] == [job["id"] for job in finished["jobs"]][::-1]


def test_the_table_has_a_row_a_job(server, finished):
    path = f"/v1/sweeps/{finished['id']}/table"
    table = server.get(path).json()
    rows = [dict(zip(table["columns"], row)) for row in table["rows"]]
    assert [row["job"] for row in rows] == [job["id"] for job in finished["jobs"]]
    summary = server.job(rows[1]["job"])["summary"]
    assert rows[1]["/inflow/velocity"] == 0.001 and rows[1]["/plasma/density"] == 1050
    assert rows[1]["cell0.peak_velocity"] == summary["cells"][0]["peak_velocity"]
    assert rows[1]["cell0.peak_tau"] == summary["cells"][0]["peak_tau"] >= rows[1]["cell0.least_tau"]
    assert rows[1]["wall_time"] == summary["wall_time"] and rows[1]["cell0.residence_time"] is None
    assert table["units"]["cell0.peak_velocity"] == "m/s"
    answer = server.get(path, Accept="text/csv")
    assert answer.headers["Content-Type"].startswith("text/csv")
    read = list(csv.DictReader(io.StringIO(answer.body.decode())))
    assert [float(row["cell0.peak_tau"]) for row in read] == [row["cell0.peak_tau"] for row in rows]


def test_the_residence_time_of_a_cell_that_leaves(server):
    case = plasma(duration=4e-3, cells=[{"x": 12e-6, "y": 5e-6, "diameter": 4e-6}])
    sweep = wait(server, submit(server, {"case": case, "axes": [velocities(0.005)]})["id"])
    table = server.get(f"/v1/sweeps/{sweep['id']}/table").json()
    [row] = [dict(zip(table["columns"], row)) for row in table["rows"]]
    assert 0 < row["cell0.residence_time"] < 4e-3


def test_what_was_computed_answers_at_once(server, finished):
    body = {"case": plasma(cells=[{"x": 10e-6, "y": 5e-6, "diameter": 4e-6}], name="otherwise named"), "mode": "zip",
            "axes": [velocities(0.001, 0.002), {"pointer": "/plasma/density", "values": [1050, 1000]}]}
    sweep = submit(server, body)
    assert sweep["counts"]["succeeded"] == 2 and sweep["active"] == 0
    jobs = server.get(f"/v1/sweeps/{sweep['id']}").json()["jobs"]
    assert server.job(jobs[0]["id"])["result_of"] == finished["jobs"][1]["id"]
    fresh = submit(server, {**body, "fresh": True})
    assert fresh["active"] == 2
    wait(server, fresh["id"])


def test_a_sweep_that_was_submitted_again_under_its_key_is_the_same(server):
    body = {"case": plasma(), "axes": [velocities(0.0041, 0.0042)]}
    first = submit(server, body, **{"Idempotency-Key": "sweep-1"})
    answer = server.request("POST", "/v1/sweeps", body, {"Idempotency-Key": "sweep-1"})
    assert answer.status == 202 and answer.json()["id"] == first["id"]
    assert answer.headers["Idempotency-Replayed"] == "true"
    other = server.request("POST", "/v1/sweeps", {**body, "priority": 1}, {"Idempotency-Key": "sweep-1"})
    assert other.status == 422 and other.json()["type"] == "/problems/idempotency-mismatch"
    wait(server, first["id"])


def test_cancelling(server):
    sweep = submit(server, {"case": endless(), "axes": [velocities(0.001, 0.002, 0.003, 0.004)], "priority": 50})
    path = f"/v1/sweeps/{sweep['id']}"
    running = server.get(path).json()["jobs"][0]["id"]
    server.wait_until_running(running)
    answer = server.request("POST", path + ":cancel")
    assert answer.status == 202 and answer.json()["counts"]["cancelled"] >= 2
    assert wait(server, sweep["id"])["counts"]["cancelled"] == 4
    again = server.request("POST", path + ":cancel")
    assert again.status == 200 and again.json()["counts"]["cancelled"] == 4


def test_waiting_holds_until_the_end(server):
    sweep = submit(server, {"case": plasma(), "axes": [velocities(0.0031, 0.0032, 0.0033)]})
    answer = server.get(f"/v1/sweeps/{sweep['id']}?wait=30s&jobs=false")
    assert answer.json()["active"] == 0 and "jobs" not in answer.json()
    assert server.get(f"/v1/sweeps/{sweep['id']}?jobs=false", If_None_Match=answer.headers["ETag"]).status == 304


def test_a_failed_point_does_not_stop_the_others(server):
    sweep = submit(server, {"case": unstable(), "axes": [{"pointer": "/duration", "values": [3e-3, 1e-4]}]})
    assert [job["state"] for job in wait(server, sweep["id"])["jobs"]] == ["failed", "succeeded"]


def test_the_list_is_newest_first_and_in_pages(server):
    ids = [submit(server, {"case": plasma(), "axes": [velocities(0.002)]})["id"] for _ in range(3)]
    first = server.get("/v1/sweeps?page_size=2").json()
    assert [sweep["id"] for sweep in first["sweeps"]] == ids[:0:-1]
    second = server.get(f"/v1/sweeps?page_size=2&page_token={first['next_page_token']}").json()
    assert second["sweeps"][0]["id"] == ids[0]
    for query in ("page_size=0", "page_token=nonsense", "state=queued"):
        assert server.get(f"/v1/sweeps?{query}").status == 400


def refused(server, body):
    before = len(server.get("/v1/jobs?page_size=1000").json()["jobs"])
    answer = server.request("POST", "/v1/sweeps", body)
    assert len(server.get("/v1/jobs?page_size=1000").json()["jobs"]) == before, "all or none"
    return answer.status, answer.json()


def test_every_bad_point_is_named(server):
    status, problem = refused(server, {"case": plasma(), "axes": [velocities(0.001, "fast", -1e9)]})
    assert status == 422 and problem["type"] == "/problems/invalid-case" and "2 of 3" in problem["detail"]
    assert {error["pointer"] for error in problem["errors"]} == {"/case/inflow/velocity"}
    messages = [error["message"] for error in problem["errors"]]
    assert messages[0].startswith('point 1 (/inflow/velocity = "fast"): ')
    assert messages[1].startswith("point 2 (/inflow/velocity = -1000000000.0): ")


@pytest.mark.parametrize("body, pointers", [
    ({}, {"/case", "/axes"}),
    ({"case": plasma(), "axes": [velocities()], "priority": 1000, "labels": 3, "fresh": 1, "mode": "x", "y": 0},
     {"/axes/0/values", "/priority", "/labels", "/fresh", "/mode", "/y"}),
    ({"case": plasma(), "axes": [{"pointer": "/none/such", "values": [1]}]}, {"/axes/0/pointer"}),
    ([], {""}),
])
def test_a_body_that_is_no_sweep(server, body, pointers):
    status, problem = refused(server, body)
    assert status in (400, 422) and {error["pointer"] for error in problem["errors"]} == pointers


def test_a_sweep_that_is_too_large(tmp_path):
    with Server(tmp_path / "data", arguments=["--max-sweep", "5"]) as server:
        status, problem = refused(server, {"case": plasma(), "axes": [velocities(1, 2), {**velocities(1, 2, 3), "pointer": "/duration"}]})
        assert status == 422 and problem["type"] == "/problems/sweep-too-large"


def test_sweeps_that_are_not_there(server):
    for path in ("/v1/sweeps/none", "/v1/sweeps/none/table"):
        assert server.get(path).status == 404
    assert server.request("POST", "/v1/sweeps/none:cancel").status == 404


def test_a_large_sweep_is_stored_whole(server):
    running = submit(server, {"case": endless(), "axes": [velocities(0.001, 0.002)], "priority": 100})
    axis = {"pointer": "/inflow/velocity", "from": 0.001, "to": 0.002, "count": 2000}
    others = []
    asking = threading.Thread(target=lambda: others.extend(server.get("/v1/jobs?page_size=1").status for _ in range(20)))
    asking.start()
    sweep = submit(server, {"case": plasma(duration=2e-4), "axes": [axis]})
    asking.join()
    assert sweep["counts"]["queued"] == 2000 and set(others) == {200}
    jobs = server.get(f"/v1/sweeps/{sweep['id']}").json()["jobs"]
    assert [job["index"] for job in jobs] == list(range(2000)) and jobs[-1]["values"] == [0.002]
    assert len(server.get(f"/v1/sweeps/{sweep['id']}/table").json()["rows"]) == 2000
    for one in (sweep, running):
        server.request("POST", f"/v1/sweeps/{one['id']}:cancel")
    assert wait(server, sweep["id"])["counts"]["cancelled"] == 2000
