"""How each problem of the catalogue comes about."""

import contextlib
import json
import os
import pathlib
import re
import select
import socket
import sqlite3
import subprocess
import threading
import time

from contract_calls import nowhere
from rouleau_server import Answer, Server, endless, plasma

json_type = {"Content-Type": "application/json"}
provocations = {}


def provoke(name):
    def add(function):
        provocations[name] = function
        return function
    return add


def catalogue():
    """{name: status} of every kind of problem, as the source has them."""
    source = pathlib.Path(__file__).parents[2] / "service/http/problem.cpp"
    return {name: int(status) for name, status in re.findall(r'\{\s*"([a-z-]+)",\s*(\d{3}),', source.read_text())}


class RawAnswer(Answer):
    """What came over a bare connection."""

    def __init__(self, reply):
        head, _, self.body = reply.partition(b"\r\n\r\n")
        lines = head.decode().split("\r\n")
        self.status = int(lines[0].split()[1])
        self.headers = dict(line.split(": ", 1) for line in lines[1:])


def raw(world, text):
    return RawAnswer(world.server.raw(text))


@contextlib.contextmanager
def another_server(folder, *arguments, **options):
    with Server(folder / "data", arguments=list(arguments), **options) as server:
        yield server


@provoke("bad-request")
def _(world, folder):
    return raw(world, "GET / HTTP/1.1\r\n\r\n")


@provoke("invalid-json")
def _(world, folder):
    return world.post("/v1/jobs", b"{", json_type)


@provoke("invalid-request")
def _(world, folder):
    return world.get("/v1/jobs?nothing=1")


@provoke("unknown-column")
def _(world, folder):
    return world.get(f"/v1/jobs/{world.succeeded}/series?columns=none")


@contextlib.contextmanager
def with_a_token(folder, scopes):
    """A server that asks for tokens, and the one that it takes."""
    made = subprocess.run([os.environ["ROULEAU_BINARY"], "token", "test", "--scopes", scopes, "--json"], capture_output=True, text=True)
    plain = "a-token-of-this-test"
    token = json.loads(made.stdout) if made.returncode == 0 else {"token": plain, "line": plain}
    (folder / "tokens").write_text(token["line"] + "\n")
    with another_server(folder, "--token-file", str(folder / "tokens")) as server:
        yield server, token["token"]


@provoke("unauthorized")
def _(world, folder):
    with with_a_token(folder, "read") as (server, _):
        return server.get("/v1/jobs")


@provoke("forbidden")
def _(world, folder):
    with with_a_token(folder, "read") as (server, token):
        return server.request("POST", "/v1/jobs", {"case": plasma()}, {"Authorization": f"Bearer {token}"})


@provoke("too-many-requests")
def _(world, folder):
    with another_server(folder, "--rate-limit", "0.1", "--rate-burst", "1") as server:
        answer = server.get("/v1/jobs")
        while answer.status == 200:
            answer = server.get("/v1/jobs")
        return answer


@provoke("no-space")
def _(world, folder):
    with another_server(folder, "--min-free", "1000000GB") as server:
        return server.request("POST", "/v1/sweeps", {"case": plasma(), "axes": [{"pointer": "/duration", "values": [1e-4]}]})


@provoke("cross-origin")
def _(world, folder):
    return world.post("/v1/jobs", {}, {"Origin": "http://elsewhere.example"})


@provoke("not-found")
def _(world, folder):
    return world.get(f"/v1/jobs/{nowhere}")


@provoke("method-not-allowed")
def _(world, folder):
    return world.server.request("PUT", "/v1/jobs")


@provoke("request-timeout")
def _(world, folder):
    with socket.create_connection(("127.0.0.1", world.server.port), timeout=30) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n")
        return RawAnswer(connection.recv(65536))


@provoke("not-finished")
def _(world, folder):
    running = world.a_running_job()
    answer = world.get(f"/v1/jobs/{running}/archive.h5")
    world.end(running)
    return answer


@provoke("invalid-transition")
def _(world, folder):
    return world.post(f"/v1/jobs/{world.succeeded}:cancel")


@provoke("idempotency-in-progress")
def _(world, folder):
    """So large a sweep that the same key comes again while it is being read."""
    axis = {"pointer": "/inflow/velocity", "from": 0.001, "to": 0.002, "count": 3000}
    body = {"case": plasma(), "axes": [axis], "fresh": True, "priority": -50}
    with another_server(folder) as server:
        server.request("POST", "/v1/queue:pause")
        answers = []

        def submit():
            answers.append(server.request("POST", "/v1/sweeps", body, {"Idempotency-Key": "twice"}))
        both = [threading.Thread(target=submit) for _ in range(8)]
        for one in both:
            one.start()
        for one in both:
            one.join()
    return max(answers, key=lambda answer: answer.status)


@provoke("idempotency-mismatch")
def _(world, folder):
    for duration in (1e-4, 2e-4):
        answer = world.post("/v1/jobs", {"case": plasma(duration=duration)}, {"Idempotency-Key": "mismatch"})
    return answer


@provoke("length-required")
def _(world, folder):
    return raw(world, "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n")


@provoke("payload-too-large")
def _(world, folder):
    return raw(world, "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 99999999\r\n\r\n")


@provoke("uri-too-long")
def _(world, folder):
    return raw(world, "GET /" + "x" * 9000 + " HTTP/1.1\r\nHost: localhost\r\n\r\n")


@provoke("unsupported-media-type")
def _(world, folder):
    return world.post("/v1/jobs", b"{}", {"Content-Type": "text/plain"})


@provoke("range-not-satisfiable")
def _(world, folder):
    return world.get(f"/v1/jobs/{world.succeeded}/archive.h5", Range="bytes=999999999-")


@provoke("unknown-host")
def _(world, folder):
    return world.get("/v1/jobs", Host="elsewhere.example")


@provoke("invalid-case")
def _(world, folder):
    return world.post("/v1/jobs", {"case": {}})


@provoke("sweep-too-large")
def _(world, folder):
    axes = [{"pointer": "/inflow/velocity", "from": 0, "to": 1, "count": 1000000}]
    return world.post("/v1/sweeps", {"case": plasma(), "axes": axes})


@provoke("headers-too-large")
def _(world, folder):
    return raw(world, "GET / HTTP/1.1\r\nHost: localhost\r\nA: " + "x" * 20000 + "\r\n\r\n")


@provoke("queue-full")
def _(world, folder):
    with another_server(folder, "--max-queued", "1") as server:
        server.request("POST", "/v1/queue:pause")
        server.submit(plasma())
        return server.request("POST", "/v1/jobs", {"case": plasma()})


@provoke("draining")
def _(world, folder):
    """The server ends once its run has: a step of so many particles takes a while."""
    with another_server(folder) as server:
        server.submit(endless(vessel={"length": 1e-3, "diameter": 1e-5}, numerics={"spacing": 4e-7}))
        while not list(server.data.rglob("*.part")):
            time.sleep(0.01)
        server.process.terminate()
        while True:
            answer = server.request("POST", "/v1/jobs", {"case": plasma()})
            if answer.status == 503:
                return answer


@provoke("too-many-connections")
def _(world, folder):
    with contextlib.ExitStack() as all_of_them:
        waiting = select.poll()
        connections = {}
        for _ in range(2100):
            one = all_of_them.enter_context(socket.create_connection(("127.0.0.1", world.server.port), timeout=10))
            connections[one.fileno()] = one
            waiting.register(one, select.POLLIN)
        for descriptor, _ in waiting.poll(10000):
            if reply := connections[descriptor].recv(65536):
                return RawAnswer(reply)
    raise AssertionError("none was refused")


@provoke("too-many-streams")
def _(world, folder):
    with another_server(folder, "--max-streams", "1") as server:
        job_id = server.submit(endless())
        with socket.create_connection(("127.0.0.1", server.port), timeout=30) as stream:
            stream.sendall(f"GET /v1/jobs/{job_id}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
            stream.recv(1)
            return server.get(f"/v1/jobs/{job_id}/events")


@contextlib.contextmanager
def server_that_removed(folder, job_id):
    """What is removed by age leaves its id behind."""
    with another_server(folder) as server:
        server.terminate()
        store = sqlite3.connect(server.data / "jobs.sqlite")
        store.execute("INSERT INTO removed_jobs VALUES (?, 0)", (job_id,))
        store.commit()
        store.close()
        server.start()
        yield server


@provoke("expired")
def _(world, folder):
    with server_that_removed(folder, nowhere) as server:
        return server.get(f"/v1/jobs/{nowhere}")


@provoke("unavailable")
def _(world, folder):
    """No file may grow any more: to the store that is a full disk."""
    with another_server(folder) as server:
        server.request("POST", "/v1/queue:pause")
        subprocess.run(["prlimit", "--pid", str(server.process.pid), "--fsize=4096"], check=True)
        return server.request("POST", "/v1/jobs", {"case": plasma()})
