#!/usr/bin/python3
"""Measures how quickly a service with many jobs answers while others submit.

    load_run.py status --program build/release/bin/rouleau [--jobs 10000] [--seconds 20]

Clients are wrk's, which ask again as soon as they are answered. Prints one line of JSON.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parents[1] / "service"))

from rouleau_server import Server, plasma  # noqa: E402

# What runs beside those who ask for a status: nobody; those who submit; they and the workers that compute.
SCENES = {"paced": {"submit": False, "compute": False, "pause_ms": 10},
          "paced_and_submit": {"submit": True, "compute": False, "pause_ms": 10},
          "status": {"submit": False, "compute": False},
          "status_and_submit": {"submit": True, "compute": False},
          "status_submit_and_compute": {"submit": True, "compute": True}}


def wrk(server, script, clients, seconds, jobs_file, pause_ms=0):
    # The first line is JSON even when wrk says more.
    environment = {**os.environ, "JOBS": str(jobs_file), "REPORT": str(HERE / "report.lua"), "PAUSE_MS": str(pause_ms)}
    return subprocess.Popen(["wrk", "--threads", "1", "--connections", str(clients), "--duration", f"{seconds}s", "--timeout", "30s",
                             "--script", HERE / script, server.url], env=environment, stdout=subprocess.PIPE, text=True)


def report_of(process):
    output = process.communicate()[0]
    return json.loads(next(line for line in output.splitlines() if line.startswith("{")))


def fill(server, jobs):
    """Hands in so many jobs that are not like one another; their ids."""
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        return list(pool.map(lambda k: server.submit(plasma(duration=2e-4 + 1e-9 * k)), range(jobs)))


def run(scene, options):
    wanted = SCENES[scene]
    arguments = ["--max-queued", str(10 * options.jobs)]
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        with Server(pathlib.Path(folder) / "data", options.program, options.workers, arguments, log_level="warn") as server:
            assert server.request("POST", "/v1/queue:pause").status in (200, 202)
            jobs_file = pathlib.Path(folder) / "jobs"
            jobs_file.write_text("\n".join(fill(server, options.jobs)))
            if wanted["compute"]:
                server.request("POST", "/v1/queue:resume")
            asking = wrk(server, "status.lua", options.clients, options.seconds, jobs_file, wanted.get("pause_ms", 0))
            submitting = None
            if wanted["submit"]:
                submitting = wrk(server, "submit.lua", options.submitters, options.seconds, jobs_file, wanted.get("pause_ms", 0))
            return {"scene": scene, "jobs": options.jobs, "seconds": options.seconds, "clients": options.clients,
                    "status": report_of(asking), "submitters": options.submitters if submitting else 0,
                    "submit": report_of(submitting) if submitting else None, "cores": os.cpu_count()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", choices=SCENES, default="status")
    parser.add_argument("--list", action="store_true", help="name the scenes")
    parser.add_argument("--program", help="rouleau")
    parser.add_argument("--jobs", type=int, default=10000)
    parser.add_argument("--clients", type=int, default=16)
    parser.add_argument("--submitters", type=int, default=4)
    parser.add_argument("--seconds", type=int, default=20)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--folder", help="where the data goes")
    options = parser.parse_args()
    if options.list:
        print("\n".join(SCENES))
    else:
        print(json.dumps(run(options.scene, options)))


if __name__ == "__main__":
    main()
