#!/usr/bin/python3
"""Writes the page of load and faults from runs of them.

usage: docs/figures/load.py FOLDER

Reads FOLDER/{queue,load,faults,soak}.jsonl, in which a later run replaces an earlier one of the same scene, writes them
again, and FOLDER/load.md. deploy/reproduce queue, load, faults and soak make the runs.
"""
import json
import pathlib
import sys

INTRODUCTION = """# Load and faults

What the service holds when many use it and when the machine fails it. Each table names the command that makes it
(with `--quick` a shorter form; `--draw` draws this page again); rates on a machine drift with its disk and its neighbours, so
compare within one table only.
"""

QUEUE = """
## The store beside other queues

`deploy/reproduce queue`

Every call is answered after what it did is on the disk. {clients} clients, each of which waits for its answer before it asks
again; a payload of {payload} bytes; {jobs} jobs a turn, {turns} turns in which each queue has a fresh folder, one after the
other in changing order. Medians of the turns.
"""
QUEUE_AFTER = """
What is and is not alike: Rouleau's store is a library within the service, measured in its own process by 16 threads, and
stores each case twice (as given, and with its defaults) besides a plan, a hash and nine indexes; what HTTP adds is in the next
table. plainjob is a library, too: one Node process, in which calls cannot overlap, with `synchronous = FULL`, which is not its
default; it waits for a sync of its own with every call, and so is as quick as the disk happens to be. BullMQ and pg-boss speak to a server of their own over TCP, with a connection for each client: Redis with
`appendonly yes, appendfsync always`, PostgreSQL with `fsync` and `synchronous_commit` on. To claim and to complete are two
durable calls with Rouleau, plainjob and pg-boss; a BullMQ Worker ends a job and claims the next in one, which its rate
profits from, and the time of a call is that from claim to end.
"""

LOAD = """
## A service with many jobs

`deploy/reproduce load`

{jobs} jobs in the store, {clients} clients of wrk that ask for one of them after the other, with or without a pause, and clients
that submit cases that are all different, {seconds} s each on {cores} cores, which clients and workers share with the service.
Without a pause the clients take all that the machine has, and what is measured is the queue in front of it.
"""
LOAD_NAMES = {"paced": "they alone, 10 ms after each answer", "paced_and_submit": "and {submitters} that submit, all 10 ms after each answer",
              "status": "they alone", "status_and_submit": "and {submitters} that submit",
              "status_submit_and_compute": "and {submitters} that submit, while two workers compute"}

FAULTS = """
## Faults

`deploy/reproduce faults`
"""

SOAK = """
## Mixed load

`deploy/reproduce soak`

Submitting, cancelling, pausing, resuming, retrying, deleting, listing, waiting, series, downloads whole and in parts, event
streams, and clients that break off in the middle. Growth is the slope of Theil and Sen over what was sampled after the
first third, times its length.
"""


def runs_of(path):
    runs = {}
    if path.exists():
        for line in path.read_text().splitlines():
            run = json.loads(line)
            runs[run["scene"]] = run
        path.write_text("".join(json.dumps(run) + "\n" for run in runs.values()))
    return runs


def table(*rows):
    head, *body = rows
    return "\n" + "".join("| " + " | ".join(map(str, row)) + " |\n" for row in (head, ["---"] * len(head), *body))


def queue_page(run):
    rates = {}
    for row in run["rows"]:
        rates.setdefault(row["queue"], {})[row["measure"]] = row
    rows = [["queue", "enqueue, 1/s", "least to most", "p99, ms", "claim and complete, 1/s", "least to most", "p99, ms"]]
    for queue, measures in rates.items():
        cells = [queue]
        for measure in ("enqueue", "claim and complete"):
            row = measures[measure]
            cells += [f"{row['rate']:.0f}", f"{row['least']:.0f} to {row['most']:.0f}", f"{row['p99_ms']:.1f}"]
        rows.append(cells)
    return QUEUE.format(**run) + table(*rows) + QUEUE_AFTER


def latency(report):
    return [f"{report['rate']:.0f}", f"{report['p50_ms']:.2f}", f"{report['p99_ms']:.2f}", f"{report['p99_9_ms']:.2f}"]


def load_page(runs):
    rows = [["who asks", "what", "1/s", "median, ms", "p99, ms", "p99.9, ms", "wrong answers"]]
    for scene, name in LOAD_NAMES.items():
        if run := runs.get(scene):
            name = name.format(**run)
            rows.append([name, "`GET /v1/jobs/{id}`", *latency(run["status"]), run["status"]["wrong"]])
            if run["submit"]:
                rows.append([name, "`POST /v1/jobs`", *latency(run["submit"]), run["submit"]["wrong"]])
    remarks = {run["remark"] for run in runs.values() if "remark" in run}
    return LOAD.format(**next(iter(runs.values()))) + "".join(f"{remark}\n" for remark in remarks) + table(*rows)


def faults_page(runs):
    text = FAULTS
    if run := runs.get("kill_nine"):
        text += f"""
`kill -9` at {run['kills']} random moments while {run['jobs']} jobs, no two alike, were handed in and run by two workers:
"""
        text += table(["promised", "found"], ["accepted jobs that succeeded", f"{run['accepted'] - run['accepted_and_lost']} of {run['accepted']}"],
                      ["accepted and lost", run["accepted_and_lost"]],
                      ["result published more than once", run["ended_more_than_once"]],
                      ["archives that h5py reads to their end", f"{run['archives'] - len(run['broken_archives'])} of {run['archives']}"],
                      ["files left over", len(run["left_over"])], ["attempts", run["attempts"]],
                      ["requests that got no answer, for a kill", run["unanswered_requests"]],
                      ["of these stored, and succeeded", run["jobs_in_the_store"] - run["accepted"]])
    if run := runs.get("anywhere"):
        text += f"""
A disk that is full from one call on (`write`, `fsync`, `ftruncate` and the like in the data folder, failed with ENOSPC by
`tests/service/full_disk.c`), at {run['places']} places spread over the {run['calls_of_a_job']} calls of a job's life. While it is full the
service is asked for its jobs, and handed another; then there is room again:
"""
        text += table(["promised", "found"], ["places hit", f"{run['hit']} of {run['places']}"], ["calls failed", run["calls_failed"]],
                      ["submissions refused with 503 `unavailable`", run["refused while full"]],
                      ["answers and ends other than promised", len(run["wrong"])],
                      ["accepted jobs, all of which succeeded", run["jobs"]], ["accepted and lost", run["accepted_and_lost"]],
                      ["stored though refused", run["stored_and_not_accepted"]], ["broken archives", len(run["broken_archives"])],
                      ["files left over", len(run["left_over"])])
    return text + """
`tests/service/test_faults.py`, with every `deploy/test`: images of the data folder taken at any instant under load, each of
which passes SQLite's checks, has every job accepted by then and runs them; a clock that steps back two hours; archives and
checkpoints cut in half; a worker that cannot write.
"""


def soak_page(run):
    units = {"memory": (1e6, "MB"), "threads": (1, ""), "descriptors": (1, ""), "wal": (1e6, "MB")}
    rows = [["", "median", "most", "growth", "bound", ""]]
    for name, found in run["measures"].items():
        scale, unit = units[name]
        cells = [f"{found[key] / scale:.3g} {unit}" for key in ("median", "most", "growth", "bound")]
        rows.append([name, *cells, "flat" if found["flat"] else "**grows**"])
    did = ", ".join(f"{count} {what}" for what, count in run["did"].items())
    return SOAK + f"\n{run['minutes']:.0f} minutes, {run['samples']} samples; requests: {did}; wrong answers: {sum(run['wrong'].values())}.\n" + table(*rows)


def main(folder):
    queue, load, faults, soak = (runs_of(folder / f"{name}.jsonl") for name in ("queue", "load", "faults", "soak"))
    text = INTRODUCTION
    if queue:
        text += queue_page(queue["durable"])
    if load:
        text += load_page(load)
    if faults:
        text += faults_page(faults)
    if soak:
        text += soak_page(soak["mixed"])
    (folder / "load.md").write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
