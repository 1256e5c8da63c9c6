"""How soon others are answered while many clients are slow or silent.

Usage: slow_clients.py [--binary FILE | --url URL [--token TOKEN]] [--slow N] [--seconds S] [--others N] [KIND...]

Prints a line of JSON without slow clients and one for each kind of them. Exits with 1 if any of the others was not answered.
"""

import argparse
import http.client
import json
import os
import socket
import sys
import tempfile
import threading
import time
import urllib.parse

from rouleau_server import Server, plasma


class SlowClients:
    """Connections on one thread, each of which does a little about once a second; one that is closed is opened again."""

    def __init__(self, address, count, kind):
        self.address, self.count, self.kind = address, count, kind
        self.stopped = threading.Event()
        self.connected = threading.Event()
        self.opened = 0
        self.thread = threading.Thread(target=self.work)

    def __enter__(self):
        self.thread.start()
        assert self.connected.wait(60)
        return self

    def __exit__(self, *_):
        self.stopped.set()
        self.thread.join()

    def open(self):
        connection = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(5)
        connection.connect(self.address)
        connection.sendall(self.kind.first)
        connection.setblocking(False)
        self.opened += 1
        return connection

    def work(self):
        connections = [self.open() for _ in range(self.count)]
        self.connected.set()
        while not self.stopped.wait(1):
            for i, connection in enumerate(connections):
                try:
                    closed = self.kind.turn(connection)
                except BlockingIOError:
                    closed = False
                except OSError:
                    closed = True
                if closed:
                    connection.close()
                    connections[i] = self.open()
        for connection in connections:
            connection.close()


class Kind:
    def __init__(self, first, turn):
        self.first, self.turn = first.encode(), turn


def is_answered(connection):
    """Closed, or told that it took too long."""
    received = connection.recv(4096)
    return not received or received.startswith(b"HTTP/1.1 4")


def sends_a_byte(connection):
    connection.send(b"x")
    return is_answered(connection)


def reads_a_little(connection):
    return not connection.recv(1024)


def kinds(host, archive, token):
    head = f"Host: {host}\r\n" + (f"Authorization: Bearer {token}\r\n" if token else "")
    return {
        "silent": Kind("", is_answered),
        "head": Kind(f"GET /v1/jobs HTTP/1.1\r\n{head}A: ", sends_a_byte),
        "body": Kind(f"POST /v1/cases:validate HTTP/1.1\r\n{head}Content-Type: application/json\r\n"
                     "Content-Length: 100000\r\n\r\n", sends_a_byte),
        "reader": Kind(f"GET {archive} HTTP/1.1\r\n{head}\r\n", reads_a_little),
    }


class Others:
    """Clients as they should be: one request after the other on a connection that is kept."""

    def __init__(self, address, path, headers, count, seconds):
        self.address, self.path, self.headers = address, path, headers
        self.until = time.monotonic() + seconds
        self.lock = threading.Lock()
        self.times, self.failed = [], 0
        threads = [threading.Thread(target=self.work) for _ in range(count)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def work(self):
        times, failed = [], 0
        connection = http.client.HTTPConnection(*self.address, timeout=60)
        while time.monotonic() < self.until:
            begun = time.perf_counter()
            try:
                connection.request("GET", self.path, headers=self.headers)
                answer = connection.getresponse()
                answer.read()
                failed += answer.status != 200
            except (OSError, http.client.HTTPException):
                failed += 1
                connection.close()
            times.append(time.perf_counter() - begun)
            time.sleep(0.005)
        connection.close()
        with self.lock:
            self.times += times
            self.failed += failed

    def figures(self):
        ordered = sorted(self.times)
        share = lambda part: round(1e3 * ordered[min(int(part * len(ordered)), len(ordered) - 1)], 2)
        return {"requests": len(ordered), "failed": self.failed, "p50_ms": share(0.5), "p99_ms": share(0.99),
                "worst_ms": share(1)}


def long_archive(url, headers):
    """Has a job run whose archive is larger than what sockets buffer; its address and that of the archive."""
    case = plasma(output={"series_interval": 2e-6, "frame_interval": 5e-7})
    parts = urllib.parse.urlsplit(url)
    connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=70)

    def call(method, path, body=None):
        connection.request(method, path, body, {**headers, "Content-Type": "application/json"} if body else headers)
        answer = connection.getresponse()
        return json.loads(answer.read())

    job = call("POST", "/v1/jobs", json.dumps({"case": case}))
    path = f"/v1/jobs/{job['id']}"
    while not job["ended_at"]:
        job = call("GET", path + "?wait=20s")
    connection.close()
    assert job["state"] == "succeeded", job
    return path, path + "/archive.h5"


def measure(url, token, options):
    parts = urllib.parse.urlsplit(url)
    headers = {"Authorization": f"Bearer {token}"} if token else {}
    path, archive = long_archive(url, headers)
    every = kinds(f"{parts.hostname}:{parts.port}", archive, token)
    address = (parts.hostname, parts.port)
    failed = 0

    def show(kind, slow, figures, **more):
        print(json.dumps({"kind": kind, "slow": slow, "others": options.others, **figures, **more}), flush=True)
        return figures["failed"]

    failed += show("none", 0, Others(address, path, headers, options.others, options.seconds).figures())
    for name in options.kinds or every:
        with SlowClients(address, options.slow, every[name]) as slow:
            time.sleep(1)
            figures = Others(address, path, headers, options.others, options.seconds).figures()
        failed += show(name, options.slow, figures, opened=slow.opened)
    return failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--binary", default=os.environ.get("ROULEAU_BINARY"))
    parser.add_argument("--url")
    parser.add_argument("--token", default="")
    parser.add_argument("--slow", type=int, default=200)
    parser.add_argument("--others", type=int, default=8)
    parser.add_argument("--seconds", type=float, default=15)
    parser.add_argument("kinds", nargs="*", metavar="KIND", help="silent, head, body, reader (default: each)")
    options = parser.parse_args()
    if options.url:
        failed = measure(options.url, options.token, options)
    else:
        with tempfile.TemporaryDirectory() as folder, Server(folder + "/data", options.binary) as server:
            failed = measure(server.url, options.token, options)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
