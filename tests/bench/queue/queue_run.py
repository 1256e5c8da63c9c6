#!/usr/bin/python3
"""Measures how many jobs a second Rouleau's store takes and ends beside other queues, all of them durable.

    queue_run.py durable --store build/release/bin/store_bench [--turns 5] [--jobs 4000]

Each turn gives every queue a fresh folder, one after the other in an order that changes, so that what the disk does
meanwhile falls on all. Prints one line of JSON.
"""

import argparse
import json
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

import peers

SCENES = ["durable"]


def store_lines(store, folder, jobs, clients, payload):
    return subprocess.run([store, folder, str(jobs), str(clients), str(payload)], check=True, stdout=subprocess.PIPE,
                          text=True).stdout.splitlines()


def turn(name, options):
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        arguments = (pathlib.Path(folder), options.jobs, options.clients, options.payload)
        lines = store_lines(options.store, *arguments) if name == "Rouleau" else peers.lines_of(name, *arguments)
    return {measure["measure"]: measure for measure in map(json.loads, lines)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", choices=SCENES, default=SCENES[0])
    parser.add_argument("--list", action="store_true", help="name the scenes")
    parser.add_argument("--store", help="the program store_bench")
    parser.add_argument("--queues", nargs="+", default=["Rouleau", *peers.PEERS])
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=4000)
    parser.add_argument("--clients", type=int, default=16)
    parser.add_argument("--payload", type=int, default=1000, help="bytes")
    parser.add_argument("--folder", help="where the data goes: on the disk that is to be measured")
    options = parser.parse_args()
    if options.list:
        print("\n".join(SCENES))
        return
    if any(name in peers.PEERS for name in options.queues):
        peers.install()
    turns = []
    for k in range(options.turns):
        order = options.queues[k % len(options.queues):] + options.queues[:k % len(options.queues)]
        turns.append({name: turn(name, options) for name in order})
        for name in order:
            rates = ", ".join(f"{measure} {found['rate']:.0f}/s" for measure, found in turns[-1][name].items())
            print(f"turn {k + 1}: {name}: {rates}", file=sys.stderr)
    rows = []
    for name in options.queues:
        for measure in turns[0][name]:
            values = [turn[name][measure] for turn in turns]
            rates = sorted(value["rate"] for value in values)
            rows.append({"queue": name, "measure": measure, "rate": statistics.median(rates), "least": rates[0], "most": rates[-1],
                         **{key: statistics.median(v[key] for v in values) for key in ("p50_ms", "p99_ms")}})
    print(json.dumps({"scene": options.scene, "turns": options.turns, "jobs": options.jobs, "clients": options.clients,
                      "payload": options.payload, "machine": platform.processor() or platform.machine(), "rows": rows}))


if __name__ == "__main__":
    main()
