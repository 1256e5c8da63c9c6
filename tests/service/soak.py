#!/usr/bin/python3
"""Mixed load on a service for a while; whether its memory, threads, descriptors and write-ahead log stay as they are.

    soak.py mixed --binary build/release/bin/rouleau --minutes 60

Submits, cancels, pauses, resumes, deletes, lists, streams, downloads, and clients that break off. Prints one line of
JSON; exit code 1 if something grew, or an answer was wrong.
"""

import argparse
import collections
import contextlib
import http.client
import json
import pathlib
import random
import socket
import statistics
import sys
import tempfile
import threading
import time

from rouleau_server import Server, plasma

SCENES = ["mixed"]
JOBS_KEPT = 100
# How much a measure may grow from the first half to the second: what a slope over an hour of samples cannot tell
# from noise. Memory in bytes: the heap's own, and a page cache of SQLite for each reader.
BOUNDS = {"memory": 16e6, "threads": 2, "descriptors": 6, "wal": 4.2e6}


class Load:
    def __init__(self, server, seed):
        self.server = server
        self.source = random.Random(seed)
        self.counts = collections.Counter()
        self.wrong = collections.Counter()
        self.over = threading.Event()
        self.lock = threading.Lock()
        self.jobs = []

    def ask(self, method, path, body=None, fine=(200, 202, 204), **headers):
        answer = self.server.request(method, path, body, headers)
        with self.lock:
            self.counts[method] += 1
            if answer.status not in fine:
                self.wrong[f"{method} {answer.status}"] += 1
        return answer

    def some_job(self):
        with self.lock:
            return self.source.choice(self.jobs) if self.jobs else None

    def submit(self):
        duration = 1e-5 + 1e-4 * self.source.random()
        answer = self.ask("POST", "/v1/jobs", {"case": plasma(duration=duration), "labels": {"lane": self.source.choice("abc")}})
        with self.lock:
            self.jobs.append(answer.json()["id"])
        if self.source.random() < 0.1:
            self.act("cancel")
        time.sleep(0.3)

    def act(self, verb=None):
        """What another client did meanwhile may have made it impossible."""
        if job := self.some_job():
            verb = verb or self.source.choice(["cancel", "pause", "pause", "resume", "retry"])
            self.ask("POST", f"/v1/jobs/{job}:{verb}", fine=(200, 202, 404, 409))
            if verb == "pause":
                self.ask("POST", f"/v1/jobs/{job}:resume", fine=(200, 202, 404, 409))
        time.sleep(0.7)

    def delete(self):
        with self.lock:
            old = [self.jobs.pop(0) for _ in range(max(0, len(self.jobs) - JOBS_KEPT))]
        for job in old:
            answer = self.ask("DELETE", f"/v1/jobs/{job}", fine=(204, 404, 409))
            if answer.status == 409:
                self.ask("POST", f"/v1/jobs/{job}:cancel", fine=(200, 202, 404, 409))
                with self.lock:
                    self.jobs.append(job)
        time.sleep(1)

    def read(self):
        job = self.some_job()
        for path in ("/v1/jobs?page_size=50", "/v1/queue", "/v1/jobs?state=succeeded&label=lane:a"):
            self.ask("GET", path)
        if job:
            self.ask("GET", f"/v1/jobs/{job}?wait=1s", fine=(200, 404))
            self.ask("GET", f"/v1/jobs/{job}/series", fine=(200, 404), Accept="text/csv")
            self.ask("GET", f"/v1/jobs/{job}/archive.h5", fine=(200, 404, 409))
            self.ask("GET", f"/v1/jobs/{job}/archive.h5", fine=(206, 404, 409), Range="bytes=100-2000")
        time.sleep(0.3)

    def stream(self):
        if job := self.some_job():
            with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=5)) as connection:
                connection.request("GET", f"/v1/jobs/{job}/events")
                response = connection.getresponse()
                with self.lock:
                    self.counts["stream"] += 1
                if response.status == 200 and self.source.random() < 0.7:
                    response.read()  # until the job ends; else this client is simply gone
        time.sleep(0.5)

    def break_off(self):
        text = self.source.choice([b"", b"GET /v1/jobs HT", b"POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                                   b"application/json\r\nContent-Length: 1000\r\n\r\n{", b"\x16\x03\x01\x02", b"GET /v1/jobs?page_size=1000 "
                                   b"HTTP/1.1\r\nHost: localhost\r\n\r\n"])
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=5) as connection:
            connection.sendall(text)
            if self.source.random() < 0.5:
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\x01\0\0\0\0\0\0\0")
            time.sleep(self.source.uniform(0, 1))
        with self.lock:
            self.counts["broken off"] += 1

    def keep_doing(self, what):
        while not self.over.is_set():
            try:
                what()
            except (OSError, http.client.HTTPException) as error:
                if not self.over.is_set() and what != self.stream:
                    with self.lock:
                        self.wrong[f"{what.__name__}: {error}"] += 1
                time.sleep(0.1)

    def start(self):
        doing = [self.submit, self.submit, self.act, self.delete, self.read, self.read, self.stream, self.stream, self.break_off]
        self.threads = [threading.Thread(target=self.keep_doing, args=(what,)) for what in doing]
        for thread in self.threads:
            thread.start()

    def stop(self):
        self.over.set()
        for thread in self.threads:
            thread.join()


def sample(server):
    process = pathlib.Path(f"/proc/{server.process.pid}")
    status = dict(line.split(":", 1) for line in (process / "status").read_text().splitlines())
    wal = server.data / "jobs.sqlite-wal"
    return {"memory": 1024 * int(status["VmRSS"].split()[0]), "threads": int(status["Threads"]),
            "descriptors": len(list((process / "fd").iterdir())), "wal": wal.stat().st_size if wal.exists() else 0}


def slope(values):
    """Per sample, of the line that half of all pairs lie above: a few peaks do not move it (Theil and Sen)."""
    step = max(1, len(values) // 200)
    thinned = list(enumerate(values))[::step]
    return statistics.median((b - a) / (j - i) for k, (i, a) in enumerate(thinned) for j, b in thinned[k + 1:])


def verdict(samples):
    """Of what was sampled after a third of the time, in which caches fill and threads begin."""
    late = samples[len(samples) // 3:]
    found = {}
    for name, bound in BOUNDS.items():
        values = [each[name] for each in late]
        growth = slope(values) * len(values)
        found[name] = {"median": statistics.median(values), "most": max(values), "growth": round(growth, 1), "bound": bound,
                       "flat": growth <= bound}
    return found


def run(options):
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        with Server(pathlib.Path(folder) / "data", options.binary, options.workers, log_level="warn") as server:
            load = Load(server, options.seed)
            load.start()
            samples, begun = [], time.monotonic()
            while time.monotonic() < begun + 60 * options.minutes and server.process.poll() is None:
                time.sleep(options.interval)
                samples.append(sample(server))
                if options.samples:
                    with open(options.samples, "a") as out:
                        print(json.dumps({"t": round(time.monotonic() - begun, 1), **samples[-1]}), file=out)
            load.stop()
            found = verdict(samples)
            exit_code = server.terminate()
            return {"scene": "mixed", "minutes": options.minutes, "samples": len(samples), "did": dict(load.counts),
                    "wrong": dict(load.wrong), "exit_code": exit_code, "measures": found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", choices=SCENES, default="mixed")
    parser.add_argument("--list", action="store_true", help="name the scenes")
    parser.add_argument("--binary")
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--interval", type=float, default=10, help="s between samples")
    parser.add_argument("--samples", help="a file for the samples, a line each")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--any-growth", action="store_true", help="of a run too short to tell growth from a start")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", help="where the data goes")
    options = parser.parse_args()
    if options.list:
        print("\n".join(SCENES))
        return 0
    result = run(options)
    print(json.dumps(result))
    flat = options.any_growth or all(each["flat"] for each in result["measures"].values())
    good = not result["wrong"] and result["exit_code"] == 0 and flat
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
