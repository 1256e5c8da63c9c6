#!/usr/bin/python3
"""Accepts jobs while `kill -9` falls: every accepted job must end, exactly once, and leave a whole archive.

    kill_nine.py --binary build/release/bin/rouleau --jobs 200 --kills 5

The kills fall at random among the ends of all these jobs.
"""

import argparse
import collections
import http.client
import json
import pathlib
import random
import sys
import tempfile
import threading
import time

import h5py

from rouleau_server import Server, plasma


class Submitter(threading.Thread):
    """Hands in jobs until as many as asked for are accepted; a request that got no answer counts for nothing."""

    def __init__(self, server, jobs, duration, pause):
        super().__init__()
        self.server, self.jobs, self.duration, self.pause = server, jobs, duration, pause
        self.accepted = []
        self.unanswered = 0

    def run(self):
        while len(self.accepted) < self.jobs:
            try:
                # No case like another: each is computed.
                nth = len(self.accepted) + self.unanswered
                self.accepted.append(self.server.submit(plasma(duration=self.duration + 1e-10 * nth)))
            except (OSError, AssertionError, ValueError, http.client.HTTPException):
                self.unanswered += 1
            time.sleep(self.pause)


def all_jobs(server):
    jobs, token = [], ""
    while token is not None:
        page = server.get(f"/v1/jobs?page_size=1000&page_token={token}").json()
        jobs += page["jobs"]
        token = page.get("next_page_token")
    return jobs


def ended(server):
    return sum(server.get("/v1/queue").json()["states"][state] for state in ("succeeded", "failed", "cancelled"))


def wait_for_ends(server, jobs, patience):
    deadline = time.monotonic() + patience
    while ended(server) < jobs:
        if time.monotonic() > deadline:
            raise SystemExit(f"{jobs} jobs have not ended in time")
        time.sleep(0.02)


def broken_archives(server, jobs):
    """Those that cannot be read to their end."""
    broken = []
    for job in jobs:
        try:
            with h5py.File(server.data / "archives" / f"{job}.h5") as archive:
                archive.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)
        except OSError as error:
            broken.append(f"{job}: {error}")
    return broken


def wait_for_all(server, patience):
    deadline = time.monotonic() + patience
    while True:
        jobs = all_jobs(server)
        left = [job for job in jobs if job["ended_at"] is None]
        if not left:
            return jobs
        if time.monotonic() > deadline:
            raise SystemExit(f"{len(left)} jobs have not ended")
        time.sleep(0.2)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", required=True)
    parser.add_argument("--jobs", type=int, default=200)
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--duration", type=float, default=1e-3, help="simulated time of each job, s")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--patience", type=float, default=3600, help="s until all jobs must have ended")
    options = parser.parse_args()

    source = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        with Server(pathlib.Path(folder) / "data", options.binary, options.workers) as server:
            # Handed in for as long as the kills last, so that some fall on a request.
            submitter = Submitter(server, options.jobs, options.duration, min(0.1, 1.5 * options.kills / options.jobs))
            submitter.start()
            begun = time.monotonic()
            for ends in sorted(source.sample(range(options.jobs), options.kills)):
                wait_for_ends(server, ends, options.patience)
                time.sleep(source.uniform(0, 0.2))
                server.kill_nine()
                server.start()
            submitter.join()
            jobs = wait_for_all(server, options.patience)
            wall_time = time.monotonic() - begun
            exit_code = server.terminate()
            archives = {path.stem for path in server.data.glob("archives/*.h5")}
            left_over = [path.name for path in server.data.glob("archives/*") if path.suffix not in (".h5", ".xdmf")]
            broken = broken_archives(server, archives)
            published = collections.Counter(
                field.removeprefix("job=") for line in server.log().splitlines() if 'event="job succeeded"' in line
                for field in line.split() if field.startswith("job="))

    stored = {job["id"]: job for job in jobs}
    succeeded = {job_id for job_id, job in stored.items() if job["state"] == "succeeded"}
    lost = [job_id for job_id in submitter.accepted if job_id not in succeeded]
    # A kill may fall between the commit and the log line, never between two commits of one job.
    twice = [job_id for job_id, count in published.items() if count > 1]
    result = {
        "scene": "kill_nine",
        "jobs": options.jobs,
        "accepted": len(submitter.accepted),
        "unanswered_requests": submitter.unanswered,
        "jobs_in_the_store": len(jobs),
        "succeeded": len(succeeded),
        "accepted_and_lost": len(lost),
        "ended_more_than_once": len(twice),
        "archives": len(archives),
        "broken_archives": broken,
        "left_over": left_over,
        "attempts": sum(job["attempt"] for job in jobs),
        "kills": options.kills,
        "wall_time_s": round(wall_time, 1),
    }
    print(json.dumps(result))
    good = not (lost or twice or broken or left_over) and archives == succeeded == set(stored) and exit_code == 0
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
