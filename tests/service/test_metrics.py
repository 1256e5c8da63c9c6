"""What a Prometheus sees."""

import pathlib
import re

import pytest
from rouleau_server import Server, endless, plasma

documentation = pathlib.Path(__file__).parents[2] / "docs" / "operations.md"


def scrape(server):
    """{(name, labels): value} and {name: type}, after the text format's own rules."""
    answer = server.health("/metrics")
    assert answer.status == 200 and answer.headers["Content-Type"].startswith("text/plain; version=0.0.4")
    values, types = {}, {}
    for line in answer.body.decode().splitlines():
        if line.startswith("# TYPE "):
            _, _, name, kind = line.split()
            assert name not in types
            types[name] = kind
        elif not line.startswith("#"):
            match = re.fullmatch(r'([a-z_:]+)(?:\{(.*)\})? (\S+)', line)
            assert match, line
            values[match[1], match[2] or ""] = float(match[3])
    return values, types


def value(values, name, *labels):
    found = [number for (one, text), number in values.items() if one == "rouleau_" + name and all(label in text for label in labels)]
    return sum(found) if found else None


@pytest.fixture(scope="module")
def watched(tmp_path_factory):
    with Server(tmp_path_factory.mktemp("metrics") / "data", workers=1) as running:
        yield running


def test_the_job_in_the_queue_and_its_end_are_counted(watched):
    running = watched.submit(endless())
    watched.wait_until_running(running)
    watched.submit(plasma(2e-4))
    values, _ = scrape(watched)
    assert value(values, "jobs", 'state="running"') == 1
    assert value(values, "jobs", 'state="queued"') == value(values, "queue_depth") == 1
    assert value(values, "queue_oldest_age_seconds") >= 0
    assert value(values, "queue_paused") == 0 and value(values, "workers") == 1
    assert value(values, "steps_per_second") > 0
    watched.request("POST", f"/v1/jobs/{running}:cancel")
    watched.wait(running)
    watched.wait(watched.submit(plasma(3e-4)))
    values, _ = scrape(watched)
    assert value(values, "attempts_total", 'outcome="cancelled"') == 1
    assert value(values, "attempts_total", 'outcome="succeeded"') == 2
    assert value(values, "job_wait_seconds_count") == value(values, "attempt_seconds_count") == 3
    assert value(values, "queue_depth") == 0 and value(values, "queue_oldest_age_seconds") == 0
    assert value(values, "archive_bytes") > 10000


def test_requests_are_counted_by_route(watched):
    before, _ = scrape(watched)
    for _ in range(3):
        watched.get("/v1/jobs/none")
    watched.get("/nothing/of/any/name")
    after, _ = scrape(watched)

    def more(name, *labels):
        return value(after, name, *labels) - (value(before, name, *labels) or 0)

    assert more("http_requests_total", 'method="GET"', 'route="/v1/jobs/{id}"', 'status="404"') == 3
    assert more("http_request_seconds_count", 'route="/v1/jobs/{id}"') == 3
    assert more("http_requests_total", 'route=""', 'status="404"') == 1
    assert not any("nothing/of" in labels for _, labels in after), "an address that a client made up"


def test_what_is_left_on_the_disk_is_shown(watched):
    values, _ = scrape(watched)
    assert value(values, "database_bytes") > 0 and value(values, "wal_bytes") >= 0
    assert value(values, "disk_free_bytes") > 0
    assert value(values, "build_info", "version=") == 1
    for name in ("http_connections", "http_waiting_requests", "http_streams"):
        assert value(values, name) >= 0


def test_each_metric_is_documented_and_each_documented_one_is_there(watched):
    _, types = scrape(watched)
    documented = dict(re.findall(r"^\| `(rouleau_\w+)`[^|]*\| (\w+) \|", documentation.read_text(), re.M))
    assert documented == types


def test_metrics_are_not_on_the_api(watched):
    assert watched.get("/metrics").status == 404
