"""Server-sent events of a job, read by a client that connects again where it was."""

import socket
import time

import pytest
from event_stream import EventStream, Followed
from rouleau_server import Server, endless, plasma


def long_enough(**changes):
    return plasma(duration=6e-3, output={"series_interval": 4e-6, "frame_interval": 0}, **changes)


def rows_of(server, job_id):
    return server.get(f"/v1/jobs/{job_id}/series").json()["rows"]


@pytest.fixture(scope="module")
def service(tmp_path_factory):
    with Server(tmp_path_factory.mktemp("events") / "data", workers=2,
                arguments=("--max-streams", "3", "--stream-heartbeat", "0.5")) as server:
        yield server


@pytest.fixture
def running(service):
    job_id = service.submit(endless(output={"series_interval": 1e-5, "frame_interval": 0}))
    service.wait_until_running(job_id)
    yield job_id
    service.request("POST", f"/v1/jobs/{job_id}:cancel")
    service.wait(job_id)


def test_a_run_from_its_beginning_to_its_end(service):
    job_id = service.submit(long_enough())
    followed = Followed()
    with EventStream(service, job_id) as stream:
        assert stream.status == 200
        assert stream.response.headers["Content-Type"] == "text/event-stream"
        events = list(stream)
    for event in events:
        followed.take(event)
    assert events[0].name == events[-1].name == "state"
    assert events[-1].data["state"] == "succeeded" and events[-1].data["summary"]["ending"] == "completed"
    assert not {"plan", "case"} & events[0].data.keys()
    assert followed.states[-2:] == ["running", "succeeded"]
    assert followed.rows == rows_of(service, job_id)
    assert followed.columns == service.get(f"/v1/jobs/{job_id}/series").json()["columns"]
    assert followed.progress == sorted(followed.progress) and followed.progress[-1] == pytest.approx(1)


def test_connecting_again_and_again_leaves_no_gap_and_doubles_nothing(service):
    job_id = service.submit(long_enough(vessel={"length": 21e-6, "diameter": 10e-6}))
    followed, last_id, connections = Followed(), None, 0
    while not followed.states or followed.states[-1] != "succeeded":
        connections += 1
        with EventStream(service, job_id, last_id) as stream:
            for count, event in enumerate(stream):
                followed.take(event)
                last_id = stream.last_id
                if count == 3:
                    break
    assert connections > 2
    assert followed.rows == rows_of(service, job_id)


def test_a_restart_in_between_leaves_no_gap_either(tmp_path):
    with Server(tmp_path / "data", workers=1, arguments=("--checkpoint-interval", "0.1")) as server:
        job_id = server.submit(long_enough(vessel={"length": 22e-6, "diameter": 10e-6}))
        followed, last_id = Followed(), None
        for stop in (server.terminate, server.kill_nine):
            with EventStream(server, job_id, last_id) as stream:
                rows = len(followed.rows)
                for event in stream:
                    followed.take(event)
                    last_id = stream.last_id
                    if len(followed.rows) > rows + 20:
                        break
            stop()
            server.start()
        with EventStream(server, job_id, last_id) as stream:
            for event in stream:
                followed.take(event)
        assert followed.states[-1] == "succeeded"
        assert followed.rows == rows_of(server, job_id)


def test_what_has_ended_is_told_once(service):
    job_id = service.submit(plasma())
    service.wait(job_id)
    followed = Followed()
    with EventStream(service, job_id) as stream:
        for event in stream:
            followed.take(event)
    assert followed.states == ["succeeded"] and followed.rows == rows_of(service, job_id)
    with EventStream(service, job_id, stream.last_id) as again:
        assert again.status == 204, "a browser does not connect again after this"


@pytest.mark.parametrize("identity", ["nonsense", "5", "-1@x", "5@0.0.0+0", "@@", "5@" + "9" * 300])
def test_an_id_that_is_none_of_this_server_starts_from_the_beginning(service, identity):
    job_id = service.submit(plasma())
    service.wait(job_id)
    followed = Followed()
    with EventStream(service, job_id, identity) as stream:
        for event in stream:
            followed.take(event)
    assert followed.rows == rows_of(service, job_id)


def test_streams_are_limited_and_a_client_that_left_makes_room(service, running):
    streams = [EventStream(service, running) for _ in range(3)]
    assert [stream.status for stream in streams] == [200] * 3
    with EventStream(service, running) as refused:
        assert refused.status == 503 and refused.response.headers["Retry-After"]
        assert b"/problems/too-many-streams" in refused.response.read()
    assert service.get(f"/v1/jobs/{running}").status == 200
    for stream in streams:
        stream.close()
    deadline = time.monotonic() + 10
    while True:
        with EventStream(service, running) as stream:
            if stream.status == 200:
                return
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_a_client_that_reads_nothing_holds_up_nobody(service, running):
    with socket.create_connection(("127.0.0.1", service.port)) as silent:
        silent.sendall(f"GET /v1/jobs/{running}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
        before = service.job(running)["progress"]["steps"]
        with EventStream(service, running) as stream:
            for count, _ in enumerate(stream):
                if count == 5:
                    break
        service.wait(running, lambda job: job["progress"]["steps"] > before)


def test_a_stream_in_which_nothing_happens_is_kept_alive(service):
    job_id = service.submit(endless(vessel={"length": 26e-6, "diameter": 10e-6}), priority=-5)
    service.request("POST", f"/v1/jobs/{job_id}:pause")
    service.wait(job_id, lambda job: job["state"] == "paused")
    with EventStream(service, job_id) as stream:
        assert next(iter(stream)).data["state"] == "paused"
        while stream.comments < 2:
            line = stream.response.readline()
            assert line, "the stream ended"
            stream.comments += line.startswith(b":")
    service.request("POST", f"/v1/jobs/{job_id}:cancel")


def test_a_job_that_is_deleted_ends_its_stream(service):
    job_id = service.submit(plasma(vessel={"length": 27e-6, "diameter": 10e-6}))
    service.wait(job_id)
    assert service.request("DELETE", f"/v1/jobs/{job_id}").status == 204
    with EventStream(service, job_id) as stream:
        assert stream.status == 404


def test_a_drain_ends_streams_at_once(tmp_path):
    with Server(tmp_path / "data", workers=1) as server:
        running = server.submit(endless())
        server.wait_until_running(running)
        with EventStream(server, running) as stream:
            next(iter(stream))
            begun = time.monotonic()
            assert server.terminate() == 0
            assert time.monotonic() - begun < 10
            for _ in stream:
                pass
