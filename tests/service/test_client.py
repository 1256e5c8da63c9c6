"""The command line against a service: sweeps, many jobs at once, and a service that is busy or goes away."""

import csv
import hashlib
import http.server
import json
import os
import pathlib
import subprocess
import sys
import threading
import time

import pytest
from rouleau_server import Server, endless, free_port, plasma, unstable

example = pathlib.Path(__file__).parents[2] / "docs/examples/client.py"


@pytest.fixture
def call(server, rouleau, tmp_path):
    def run(*arguments, url=None, timeout=60):
        kept = {name: os.environ[name] for name in ("ROULEAU_MACHINE",) if name in os.environ}
        return subprocess.run([rouleau, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True, timeout=timeout,
                              env={"ROULEAU_SERVER": url or server.url, "PATH": "/usr/bin", **kept})
    return run


@pytest.fixture
def sweep_file(tmp_path):
    def write(*velocities, case=None):
        body = {"case": case or plasma(), "axes": [{"pointer": "/inflow/velocity", "values": list(velocities)}]}
        (tmp_path / "sweep.json").write_text(json.dumps(body))
        return "sweep.json"
    return write


def table(folder):
    with open(folder / "table.csv", newline="") as file:
        return list(csv.DictReader(file))


def jobs_of(server, query):
    return server.get(f"/v1/jobs?page_size=1000&{query}").json()["jobs"]


def test_a_sweep_is_handed_in(server, call, sweep_file):
    sweep_id, url = call("sweep", sweep_file(0.001, 0.002), "--server", server.url).stdout.split()
    assert url == f"{server.url}/v1/sweeps/{sweep_id}"
    assert call("wait", "--all", "--sweep", sweep_id).returncode == 0
    assert call("status", "--sweep", sweep_id).stdout.count("succeeded") == 2
    assert call("status", "--sweep", sweep_id, "--state", "failed,queued").stdout == ""


def test_a_sweep_is_followed_and_fetched_and_found_here(server, call, sweep_file, tmp_path):
    file = sweep_file(0.0011, 0.0012)
    done = call("sweep", file, "--server", server.url, "-o", "out")
    assert done.returncode == 0 and "2 archives" in done.stdout, done.stderr
    rows = table(tmp_path / "out")
    for row in rows:
        digest = hashlib.sha256((tmp_path / "out" / (row["case_hash"][:16] + ".h5")).read_bytes()).hexdigest()
        assert server.get(f"/v1/jobs/{row['job']}/archive.h5").headers["ETag"] == f'"{digest}"'
        assert row["case_hash"][:16] + ".h5" in (tmp_path / "out" / (row["case_hash"][:16] + ".xdmf")).read_text()
    told = json.loads(call("sweep", sweep_file(0.0011, 0.0012, 0.0013), "-o", "out", "--json").stdout)
    assert (told["succeeded"], told["reused"]) == (3, 2), "a sweep here finds what the service computed"


def test_a_sweep_with_a_point_that_fails(server, call, sweep_file, tmp_path):
    (tmp_path / "bad.json").write_text(json.dumps({"case": unstable(), "axes": [{"pointer": "/duration", "values": [3e-3, 1e-4]}]}))
    done = call("sweep", "bad.json", "--server", server.url, "-o", "bad", "--json")
    assert done.returncode == 1 and json.loads(done.stdout)["counts"]["failed"] == 1
    assert len(list((tmp_path / "bad").glob("*.h5"))) == 2, "also what it computed until it failed"
    assert call("sweep", sweep_file("fast"), "--server", server.url).returncode == 2


def test_waiting_for_and_fetching_all_of_a_label(server, call, tmp_path):
    (tmp_path / "case.json").write_text(json.dumps(plasma()))
    for density in (1010, 1020):
        assert call("submit", "case.json", "--set", f"/plasma/density={density}", "--label", "study=all").returncode == 0
    assert call("wait", "--all", "--label", "study:all").returncode == 0
    ids = {job["id"] for job in jobs_of(server, "label=study:all")}
    done = json.loads(call("fetch", "--all", "--label", "study=all", "-o", "got", "--json").stdout)
    assert {path.stem for path in (tmp_path / "got").glob("*.h5")} == ids and len(done["archives"]) == 2
    again = json.loads(call("fetch", "--all", "--label", "study=all", "-o", "got", "--json").stdout)
    assert all(archive["was_there"] for archive in again["archives"])

    cancelled = call("submit", "case.json", "--set", "/duration=1", "--label", "study=all").stdout.split()[0]
    waiting = threading.Timer(0.5, lambda: call("cancel", cancelled))
    waiting.start()
    told = call("wait", "--label", "study=all", "--json")
    assert told.returncode == 1 and json.loads(told.stdout)["counts"] == {"cancelled": 1, "succeeded": 2}
    waiting.join()
    assert call("wait").returncode == 2 and call("fetch").returncode == 2


def test_a_submission_under_a_key_is_one_job(server, call, tmp_path):
    (tmp_path / "case.json").write_text(json.dumps(plasma()))
    submit = ("submit", "case.json", "--label", "study=key", "--idempotency-key", "one")
    assert call(*submit).stdout == call(*submit).stdout
    assert len(jobs_of(server, "label=study:key")) == 1
    assert call(*submit, "--priority", "3").returncode == 2
    call("wait", "--label", "study=key")


def test_a_download_that_broke_off_goes_on(server, call, tmp_path):
    job_id = server.submit(plasma())
    server.wait(job_id)
    whole = server.get(f"/v1/jobs/{job_id}/archive.h5").body
    part = tmp_path / "out.h5.part"
    for rest in (whole[:1000], whole, b"x" * 1000, whole + b"more"):
        part.write_bytes(rest)
        (tmp_path / "out.h5").unlink(missing_ok=True)
        assert call("fetch", job_id, "-o", "out.h5").returncode == 0
        assert (tmp_path / "out.h5").read_bytes() == whole and not part.exists()


def test_the_queue(server, call):
    assert json.loads(call("queue", "pause", "--json").stdout)["paused"] is True
    assert "paused" in call("queue").stdout
    assert json.loads(call("queue", "resume", "--json").stdout)["paused"] is False
    assert call("queue", "stop").returncode == 2


class Busy(http.server.BaseHTTPRequestHandler):
    """Refuses twice, breaks the connection once, and then is the service that it stands before."""

    behind, seen = None, []

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.seen.append(self.headers["Idempotency-Key"])
        if len(self.seen) <= 2:
            self.send_response((429, 503)[len(self.seen) - 1])
            self.send_header("Retry-After", "1")
            self.end_headers()
            return
        answer = self.behind.request("POST", self.path, body, {"Content-Type": "application/json",
                                                               "Idempotency-Key": self.headers["Idempotency-Key"]})
        if len(self.seen) == 3:
            self.connection.close()
            return
        self.send_response(answer.status)
        self.send_header("Content-Length", str(len(answer.body)))
        self.end_headers()
        self.wfile.write(answer.body)

    def log_message(self, *_):
        pass


def test_a_busy_service_is_asked_again_and_nothing_is_doubled(server, call, tmp_path):
    (tmp_path / "case.json").write_text(json.dumps(plasma()))
    Busy.behind, Busy.seen = server, []
    proxy = http.server.HTTPServer(("127.0.0.1", 0), Busy)
    threading.Thread(target=proxy.serve_forever).start()
    begun = time.monotonic()
    done = call("submit", "case.json", "--label", "study=busy", url=f"http://127.0.0.1:{proxy.server_port}")
    assert done.returncode == 0 and time.monotonic() - begun >= 2
    assert len(Busy.seen) == 4 and len(set(Busy.seen)) == 1, "one key for all that was sent"
    assert [job["id"] for job in jobs_of(server, "label=study:busy")] == [done.stdout.split()[0]]
    Busy.seen = []
    assert call("submit", "case.json", "--patience", "0", url=f"http://127.0.0.1:{proxy.server_port}").returncode == 1
    proxy.shutdown()
    call("wait", "--label", "study=busy")


def test_waiting_outlives_a_service_that_is_started_anew(tmp_path, rouleau):
    service = Server(tmp_path / "data")
    service.command[service.command.index("--port") + 1] = str(free_port())
    with service as server:
        job_id = server.submit(endless())
        server.wait_until_running(job_id)
        waiting = subprocess.Popen([rouleau, "wait", job_id, "--server", server.url], stdout=subprocess.PIPE, text=True)
        time.sleep(1.5)
        server.kill_nine()
        time.sleep(0.5)
        server.start()
        server.request("POST", f"/v1/jobs/{job_id}:cancel")
        output, _ = waiting.communicate(timeout=60)
        assert waiting.returncode == 1 and "cancelled" in output


def test_the_python_example(server, tmp_path):
    body = {"name": "example", "case": plasma(), "axes": [{"pointer": "/inflow/velocity", "from": 0.0014, "to": 0.0015, "count": 2}]}
    (tmp_path / "sweep.json").write_text(json.dumps(body))
    command = [sys.executable, example, "sweep.json", "out", "--server", server.url]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    rows = table(tmp_path / "out")
    archives = [tmp_path / "out" / (row["case_hash"][:16] + ".h5") for row in rows]
    for row, file in zip(rows, archives):
        assert server.get(f"/v1/jobs/{row['job']}/archive.h5").body == file.read_bytes()
    whole = archives[0].read_bytes()
    archives[0].with_name(archives[0].name + ".part").write_bytes(whole[:1000])
    archives[0].unlink()
    again = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert again.returncode == 0 and "0 of 2 points to compute" in again.stderr
    assert archives[0].read_bytes() == whole
    body["axes"][0]["pointer"] = "/none"
    (tmp_path / "sweep.json").write_text(json.dumps(body))
    refused = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert refused.returncode == 1 and "422" in refused.stderr and "/axes/0/pointer" in refused.stderr
