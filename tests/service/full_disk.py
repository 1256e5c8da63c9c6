#!/usr/bin/python3
"""Lets the disk be full at one place after another of a job's life: each time the service must say so clearly, go on
answering, and do everything that it had accepted once there is room.

    full_disk.py anywhere --binary build/release/bin/rouleau --library build/release/lib/libfull_disk.so --places 100

A place is a call that takes room in the data folder (write, fsync, ftruncate, ...), counted from the submission of a
job on; it and all that follow fail until there is room again. Prints one line of JSON.
"""

import argparse
import collections
import http.client
import json
import mmap
import os
import pathlib
import random
import struct
import sys
import tempfile
import time


import h5py

from rouleau_server import Server, plasma

SCENES = ["anywhere"]


class Disk:
    """What full_disk.c shares with us."""

    def __init__(self, path):
        path.write_bytes(bytes(24))
        with open(path, "r+b") as file:
            self.shared = mmap.mmap(file.fileno(), 24)

    def number(self, index):
        return struct.unpack_from("q", self.shared, 8 * index)[0]

    @property
    def calls(self):
        return self.number(0)

    @property
    def failed(self):
        return self.number(2)

    def fill_after(self, calls):
        struct.pack_into("q", self.shared, 8, self.calls + calls)

    def make_room(self):
        struct.pack_into("q", self.shared, 8, 0)


class Faults:
    def __init__(self, server, disk):
        self.server, self.disk = server, disk
        self.counts = collections.Counter()
        self.wrong = []
        self.submitted = 0

    def expect(self, good, what):
        if not good:
            self.wrong.append(what)

    def submit(self):
        """The id, or none if there was no room; the answer must say so."""
        self.submitted += 1
        case = plasma(duration=3e-5 + 1e-9 * self.submitted, output={"series_interval": 1e-5, "frame_interval": 1e-5})
        answer = self.server.request("POST", "/v1/jobs", {"case": case})
        if answer.status == 202:
            return answer.json()["id"]
        problem = answer.json()
        self.expect(answer.status == 503 and problem["type"] == "/problems/unavailable" and problem["detail"], f"refused with {problem}")
        self.counts["refused while full"] += 1
        return None

    def end(self, job, patience=60):
        done = self.server.wait(job, patience=patience)
        self.expect(done["state"] == "succeeded", f"{job} ended as {done['state']}: {done['error']}")
        self.counts["attempts"] += done["attempt"]
        return done

    def place(self, calls):
        failed = self.disk.failed
        self.disk.fill_after(calls)
        job = self.submit()
        self.counts["accepted"] += job is not None
        deadline = time.monotonic() + 5
        while self.disk.failed == failed and time.monotonic() < deadline and not (job and self.server.job(job)["ended_at"]):
            time.sleep(0.02)
        self.counts["hit"] += self.disk.failed > failed
        # While it is full: it answers, and takes nothing that it cannot keep.
        self.expect(self.server.health("/livez").status == 200, "does not live")
        self.expect(self.server.get("/v1/jobs?page_size=10").status == 200, "does not list")
        if self.disk.failed > failed:
            self.expect(self.submit() is None, "accepted what it could not store")
        self.disk.make_room()
        again = self.submit()
        self.expect(again is not None, "refuses although there is room")
        return [each for each in (job, again) if each]


def check_archives(server, jobs):
    broken = []
    for job in jobs:
        try:
            with h5py.File(server.data / "archives" / f"{job}.h5") as archive:
                assert "series" in archive
        except (OSError, AssertionError) as error:
            broken.append(f"{job}: {error}")
    return broken


def run(options):
    source = random.Random(options.seed)
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        folder = pathlib.Path(folder)
        disk = Disk(folder / "control")
        os.environ.update(FULL_DISK_FOLDER=str(folder / "data"), FULL_DISK_CONTROL=str(folder / "control"),
                          LD_PRELOAD=os.path.abspath(options.library))
        with Server(folder / "data", options.binary, workers=2) as server:
            del os.environ["LD_PRELOAD"]
            faults = Faults(server, disk)
            before = disk.calls
            jobs = [faults.submit()]
            faults.end(jobs[0])
            time.sleep(0.5)
            calls = disk.calls - before
            for k in range(options.places):
                # Every part of a job's life in turn, and anywhere in it.
                place = 1 + int(calls * (k + source.random()) / options.places)
                hit = faults.counts["hit"]
                while faults.counts["hit"] == hit and place > 0:
                    mine = faults.place(place)
                    for job in mine:
                        faults.end(job)
                    jobs += mine
                    place -= 1 + calls // 10  # calls shared with others, or an end that came sooner
            stored = {job["id"] for job in all_jobs(server)}
            exit_code = server.terminate()
            broken = check_archives(server, jobs)
            left = [path.name for path in (server.data / "archives").iterdir() if path.suffix not in (".h5", ".xdmf")]
    return {"scene": "anywhere", "places": options.places, "calls_of_a_job": calls, "calls_failed": disk.failed, **faults.counts,
            "jobs": len(jobs), "stored_and_not_accepted": len(stored - set(jobs)), "accepted_and_lost": len(set(jobs) - stored),
            "broken_archives": broken, "left_over": left, "wrong": faults.wrong, "exit_code": exit_code}


def all_jobs(server):
    jobs, token = [], ""
    while token is not None:
        page = server.get(f"/v1/jobs?page_size=1000&page_token={token}").json()
        jobs += page["jobs"]
        token = page.get("next_page_token")
    return jobs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", choices=SCENES, default="anywhere")
    parser.add_argument("--list", action="store_true", help="name the scenes")
    parser.add_argument("--binary")
    parser.add_argument("--library")
    parser.add_argument("--places", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", help="where the data goes")
    options = parser.parse_args()
    if options.list:
        print("\n".join(SCENES))
        return 0
    try:
        result = run(options)
    except http.client.HTTPException as error:
        raise SystemExit(f"the service does not answer: {error}") from error
    print(json.dumps(result))
    good = not (result["wrong"] or result["broken_archives"] or result["left_over"] or result["exit_code"]
                or result["stored_and_not_accepted"] or result["accepted_and_lost"])
    return 0 if good and result["hit"] == options.places else 1


if __name__ == "__main__":
    sys.exit(main())
