"""A real `rouleau serve` for tests, and a small client of it."""

import http.client
import json
import os
import pathlib
import signal
import socket
import subprocess
import time


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def plasma(duration=1e-4, **changes):
    """A vessel of 20 by 10 um of plasma: a step takes milliseconds."""
    case = {
        "version": 1,
        "name": "short plasma",
        "vessel": {"length": 20e-6, "diameter": 10e-6},
        "numerics": {"preset": "draft"},
        "duration": duration,
    }
    case.update(changes)
    return case


# So long that a test always meets it while it runs.
def endless(**changes):
    return plasma(**{"duration": 1, **changes})


def unstable(**changes):
    """Walls drag a limp cell apart until it is too thin for its spacing: after some 300 short steps the run is given up."""
    return plasma(**{
        "duration": 3e-3,
        "numerics": {"preset": "draft", "refine": "off"},
        "plasma": {"kinematic_viscosity": 1e-5},
        "vessel": {"length": 20e-6, "diameter": 10e-6, "ends": "periodic", "wall_velocity": {"lower": -0.05, "upper": 0.05}},
        "cells": [{"x": 10e-6, "y": 5e-6, "diameter": 6e-6, "fill": 1, "shape": "circle", "stretch_modulus": 1e-9,
                   "bend_modulus": 1e-20}],
        "probes": [{"name": "across", "from": [5e-6, 0], "to": [5e-6, 10e-6], "points": 3}],
        "output": {"series_interval": 2e-5, "frame_interval": 1e-4},
        **changes,
    })


class Answer:
    def __init__(self, response):
        self.status = response.status
        self.headers = response.headers
        self.body = response.read()

    def json(self):
        return json.loads(self.body)


class Server:
    def __init__(self, data, binary=None, workers=2, arguments=(), log_level="debug"):
        self.binary = binary or os.environ["ROULEAU_BINARY"]
        self.data = pathlib.Path(data)
        self.health_port = free_port()
        self.log_path = self.data.with_name(self.data.name + ".log")
        self.port_file = self.data.with_name(self.data.name + ".port")
        self.command = [
            self.binary, "serve", "--port", "0", "--health-port", str(self.health_port), "--data", str(self.data),
            "--port-file", str(self.port_file), "--workers", str(workers), "--log-level", log_level, *arguments,
        ]
        self.process = None
        self.port = None

    def __enter__(self):
        return self.start()

    def __exit__(self, *_):
        if self.process and self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def start(self, patience=60):
        self.port_file.unlink(missing_ok=True)
        with open(self.log_path, "ab") as log:
            self.process = subprocess.Popen(self.command, stdout=log, stderr=log)
        deadline = time.monotonic() + patience
        while not self.port_file.exists():
            if self.process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError("the server did not start:\n" + self.log())
            time.sleep(0.02)
        self.port = int(self.port_file.read_text())
        return self

    @property
    def url(self):
        return f"http://127.0.0.1:{self.port}"

    def log(self):
        return self.log_path.read_text(errors="replace")

    def kill_nine(self):
        self.process.kill()
        self.process.wait()

    def terminate(self, patience=30):
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=patience)

    def request(self, method, path, body=None, headers=None, port=None):
        headers = dict(headers or {})
        if body is not None and not isinstance(body, bytes):
            body = json.dumps(body).encode()
            headers.setdefault("Content-Type", "application/json")
        connection = http.client.HTTPConnection("127.0.0.1", port or self.port, timeout=70)
        try:
            connection.request(method, path, body=body, headers=headers)
            return Answer(connection.getresponse())
        finally:
            connection.close()

    def get(self, path, **headers):
        return self.request("GET", path, headers={name.replace("_", "-"): value for name, value in headers.items()})

    def health(self, path):
        return self.request("GET", path, port=self.health_port)

    def submit(self, case, **members):
        """A job that is computed, whatever was before it."""
        members.setdefault("fresh", True)
        answer = self.request("POST", "/v1/jobs", {"case": case, **members})
        assert answer.status == 202, answer.body
        return answer.json()["id"]

    def job(self, job_id):
        return self.get(f"/v1/jobs/{job_id}").json()

    def wait(self, job_id, done=lambda job: job["ended_at"] is not None, patience=60):
        deadline = time.monotonic() + patience
        while True:
            job = self.job(job_id)
            if done(job):
                return job
            assert time.monotonic() < deadline, f"{job}\n{self.log()}"
            time.sleep(0.05)

    def wait_until_running(self, job_id):
        return self.wait(job_id, lambda job: job["state"] == "running" and job["progress"])

    def raw(self, text, patience=10):
        """Sends bytes as they are and no more; what comes back until the server closes."""
        if isinstance(text, str):
            text = text.encode("latin-1")
        with socket.create_connection(("127.0.0.1", self.port), timeout=patience) as connection:
            try:
                connection.sendall(text)
                connection.shutdown(socket.SHUT_WR)
            except OSError:
                pass  # refused before all of it was taken; the answer is there
            received = b""
            while True:
                try:
                    part = connection.recv(65536)
                except ConnectionResetError:
                    return received
                if not part:
                    return received
                received += part
