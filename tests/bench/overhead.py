#!/usr/bin/python3
"""What the service adds to the time of a job's computing.

    overhead.py --binary build/release/bin/rouleau --turns 3

Runs one case by `rouleau run` and as a job of `rouleau serve` in turns (run, job, job, run, ...), and compares processor time
and wall time. The service writes checkpoints as often as the run does, and a client follows the job's events meanwhile.
"""

import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "service"))
from event_stream import EventStream  # noqa: E402
from rouleau_server import Server  # noqa: E402


def scene(duration):
    return {
        "version": 1,
        "vessel": {"length": 120e-6, "diameter": 10e-6},
        "thrombi": [{"wall": "lower", "x": 60e-6, "radius": 3e-6}],
        "cells": [{"x": 10e-6, "y": 5e-6, "diameter": 5e-6}],
        "duration": duration,
        "output": {"series_interval": 1e-5, "frame_interval": 1e-4},
    }


def processor_time(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run_alone(binary, folder, case, interval):
    file = folder / "case.json"
    file.write_text(json.dumps(case))
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([binary, "run", file, "-o", folder / "alone.h5", "--checkpoint-interval", str(interval)], check=True,
                   capture_output=True, env={**os.environ, "ROULEAU_DATA": str(folder / "data")})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {"wall": time.monotonic() - begun, "processor": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}


def run_as_job(server, case):
    before, begun = processor_time(server.process.pid), time.monotonic()
    job_id = server.submit(case)
    with EventStream(server, job_id) as stream:
        watcher = threading.Thread(target=lambda: list(stream))
        watcher.start()
        while server.get(f"/v1/jobs/{job_id}?wait=60s").json()["ended_at"] is None:
            pass
        wall = time.monotonic() - begun
        watcher.join()
    assert server.job(job_id)["state"] == "succeeded", server.log()
    return {"wall": wall, "processor": processor_time(server.process.pid) - before}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", required=True)
    parser.add_argument("--turns", type=int, default=3, help="of run, job, job, run")
    parser.add_argument("--duration", type=float, default=1.4e-2, help="simulated, s")
    parser.add_argument("--checkpoint-interval", type=float, default=60)
    options = parser.parse_args()

    case = scene(options.duration)
    taken = {"run": [], "job": []}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        arguments = ("--checkpoint-interval", str(options.checkpoint_interval))
        with Server(folder / "data", options.binary, workers=1, arguments=arguments) as server:
            # Measures the machine, which the plans of both then know.
            server.wait(server.submit(scene(1e-5)))
            for _ in range(options.turns):
                for kind in ("run", "job", "job", "run"):
                    taken[kind].append(run_alone(options.binary, folder, case, options.checkpoint_interval) if kind == "run"
                                       else run_as_job(server, case))
    result = {"case": case, "taken": taken}
    for measure in ("processor", "wall"):
        middle = {kind: statistics.median(turn[measure] for turn in turns) for kind, turns in taken.items()}
        result[measure] = {**middle, "added_percent": round(100 * (middle["job"] / middle["run"] - 1), 2)}
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
