"""A data folder that an earlier release left: its jobs are there, and those that had not ended run."""

import pathlib
import sqlite3

import pytest

from rouleau_server import Server

SCHEMAS = sorted((pathlib.Path(__file__).parents[1] / "storage/schemas").glob("[0-9]*.sql"))


def data_folder(tmp_path, text):
    data = tmp_path / "data"
    data.mkdir()
    database = sqlite3.connect(data / "jobs.sqlite")
    database.executescript(text)
    database.close()
    return data


@pytest.mark.parametrize("schema", SCHEMAS, ids=lambda path: path.stem)
def test_jobs_of_an_earlier_release_go_on(tmp_path, schema):
    with Server(data_folder(tmp_path, schema.read_text())) as server:
        jobs = {job["name"]: job for job in server.get("/v1/jobs?page_size=100").json()["jobs"]}
        assert jobs["succeeded"]["state"] == "succeeded" and jobs["succeeded"]["summary"]["ending"] == "completed"
        assert jobs["failed"]["error"] == {"kind": "engine", "message": "not finite"}
        assert jobs["is being cancelled"]["state"] == "cancelled"
        for name in ("waits", "runs"):
            job = server.wait(jobs[name]["id"])
            assert job["state"] == "succeeded", job
            assert server.get(f"/v1/jobs/{job['id']}/archive.h5").status == 200
        assert server.terminate() == 0


def test_a_newer_release_is_asked_for(tmp_path):
    data = data_folder(tmp_path, SCHEMAS[-1].read_text() + "PRAGMA user_version = 999;")
    with pytest.raises(RuntimeError, match="schema version 999.*start the newer program"):
        with Server(data):
            pass
