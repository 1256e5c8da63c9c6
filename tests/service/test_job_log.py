"""The log of a job: one line an event of its life."""

import re

from rouleau_server import endless, plasma

line_form = re.compile(r'^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z event=("[a-z ]+"|[a-z]+)( [a-z_]+=("([^"\\]|\\.)*"|\S+))*$')


def events(log):
    return [re.search(r'event=(?:"([^"]*)"|(\S+))', line).group(1, 2) for line in log.splitlines()]


def names(log):
    return [quoted or plain for quoted, plain in events(log)]


def test_the_log_of_a_job_from_its_beginning_to_its_end(server):
    job_id = server.submit(plasma(name='event=forged "quoted"'))
    server.wait(job_id)
    answer = server.get(f"/v1/jobs/{job_id}/log")
    assert answer.headers["Content-Type"] == "text/plain; charset=utf-8"
    log = answer.body.decode()
    assert all(line_form.match(line) for line in log.splitlines()), log
    assert names(log) == ["accepted", "started", "ended", "succeeded"]
    assert 'reason="the whole duration was simulated"' in log
    assert (server.data / "logs" / f"{job_id}.log").read_text() == log


def test_a_part_of_it(server):
    job_id = server.submit(plasma(name="a part"))
    server.wait(job_id)
    whole = server.get(f"/v1/jobs/{job_id}/log").body
    for start in (0, 7, len(whole) - 1, len(whole), len(whole) + 1000):
        assert server.get(f"/v1/jobs/{job_id}/log?from_byte={start}").body == whole[start:]
    for start in ("-1", "x", "1.5"):
        assert server.get(f"/v1/jobs/{job_id}/log?from_byte={start}").status == 400
    assert server.get("/v1/jobs/01900000-0000-7000-8000-000000000000/log").status == 404


def test_a_job_that_waits_was_accepted(server):
    running = [server.submit(endless(vessel={"length": length, "diameter": 10e-6})) for length in (21e-6, 23e-6)]
    for job_id in running:
        server.wait_until_running(job_id)
    queued = server.submit(endless(vessel={"length": 25e-6, "diameter": 10e-6}))
    log = server.get(f"/v1/jobs/{queued}/log").body
    assert names(log.decode()) == ["accepted"]
    server.request("POST", f"/v1/jobs/{queued}:cancel")
    assert server.get(f"/v1/jobs/{queued}/log").body.startswith(log), "what was read stays as it was"
    for job_id in running:
        server.request("POST", f"/v1/jobs/{job_id}:cancel")
    for job_id in running:
        server.wait(job_id)
        assert names(server.get(f"/v1/jobs/{job_id}/log").body.decode())[-2:] == ["checkpoint", "cancelled"]
