#!/usr/bin/python3
"""Runs a sweep on a Rouleau service and fetches what it computed, with Python's standard library alone.

    client.py SWEEP.json FOLDER [--server http://127.0.0.1:8080]

A token, where the service asks for one, is taken from ROULEAU_TOKEN. Run again, it submits the same sweep: what was computed
before answers at once, and an archive that is there already is not fetched again.
"""

import argparse
import hashlib
import json
import os
import pathlib
import sys
import time
import urllib.error
import urllib.request
import uuid


class Service:
    def __init__(self, url, token=None, patience=300):
        self.url, self.token, self.patience = url.rstrip("/"), token, patience

    def open(self, path, body=None, headers=None):
        """Asks until there is an answer: a busy service says when to come again, one that restarts does not."""
        headers = {**(headers or {}), **({"Authorization": f"Bearer {self.token}"} if self.token else {})}
        if body is not None:
            headers["Content-Type"] = "application/json"
            body = json.dumps(body).encode()
        gap, deadline = 0.2, time.monotonic() + self.patience
        while True:
            try:
                return urllib.request.urlopen(urllib.request.Request(self.url + path, body, headers), timeout=90)
            except urllib.error.HTTPError as error:
                # 502 and 504 are a proxy's; 409 with Retry-After: an earlier try is still being worked on.
                busy = error.code in (429, 502, 503, 504) or error.code == 409 and "Retry-After" in error.headers
                if not busy or time.monotonic() > deadline:
                    raise
                time.sleep(float(error.headers.get("Retry-After", gap)))
            except OSError:
                if time.monotonic() > deadline:
                    raise
                time.sleep(gap)
                gap = min(2 * gap, 5)

    def json(self, path, body=None, headers=None):
        with self.open(path, body, headers) as answer:
            return json.load(answer)

    def submit(self, sweep):
        # Under this key the submission is known, however often it has to be sent.
        return self.json("/v1/sweeps", sweep, {"Idempotency-Key": str(uuid.uuid4())})

    def wait(self, sweep_id):
        """The service holds each answer for as long as nothing has ended, 30 s at most: nobody polls in a loop."""
        while True:
            sweep = self.json(f"/v1/sweeps/{sweep_id}?jobs=false&wait=30s")
            if sweep["active"] == 0:
                return sweep

    def fetch(self, job_id, file):
        """The archive of a job, whole: the ETag is its SHA-256, and what a broken download left is gone on from."""
        part = file.with_name(file.name + ".part")
        while True:
            there = part.stat().st_size if part.exists() else 0
            try:
                with self.open(f"/v1/jobs/{job_id}/archive.h5", headers={"Range": f"bytes={there}-"} if there else {}) as answer:
                    digest = answer.headers["ETag"].strip('"')
                    left = int(answer.headers["Content-Length"])
                    with open(part, "ab" if answer.status == 206 else "wb") as stream:
                        while chunk := some_of(answer):
                            left -= stream.write(chunk)
            except urllib.error.HTTPError as error:
                if error.code != 416:
                    raise
                part.unlink()  # nothing is left to send: as long as the archive, or longer
                continue
            if left > 0:
                continue
            if hashlib.sha256(part.read_bytes()).hexdigest() == digest:
                part.rename(file)
                return
            part.unlink()


def some_of(answer):
    """Nothing at the end, and where the connection broke off."""
    try:
        return answer.read(1 << 20)
    except OSError:
        return b""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sweep", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--server", default="http://127.0.0.1:8080")
    options = parser.parse_args()
    service = Service(options.server, os.environ.get("ROULEAU_TOKEN"))
    options.folder.mkdir(parents=True, exist_ok=True)

    sweep = service.submit(json.loads(options.sweep.read_text()))
    print(f"sweep {sweep['id']}: {sweep['active']} of {sum(sweep['counts'].values())} points to compute", file=sys.stderr)
    sweep = service.wait(sweep["id"])
    with service.open(f"/v1/sweeps/{sweep['id']}/table", headers={"Accept": "text/csv"}) as table:
        (options.folder / "table.csv").write_bytes(table.read())
    table = service.json(f"/v1/sweeps/{sweep['id']}/table")
    for row in (dict(zip(table["columns"], values)) for values in table["rows"]):
        file = options.folder / f"{row['case_hash'][:16]}.h5"
        if row["state"] == "succeeded" and not file.exists():
            service.fetch(row["job"], file)
    print({state: count for state, count in sweep["counts"].items() if count})
    return 0 if sweep["counts"]["succeeded"] == len(table["rows"]) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except urllib.error.HTTPError as refused:
        sys.exit(f"{refused.url}: {refused.code} {refused.read().decode()}")
