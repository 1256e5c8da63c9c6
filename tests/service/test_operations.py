"""Backup while the service runs, restore, and what the doctor finds and mends."""

import json
import os
import pathlib
import shutil
import sqlite3
import subprocess
import threading

import h5py
import pytest

from rouleau_server import Server, endless, plasma


def rouleau(*arguments):
    return subprocess.run([os.environ["ROULEAU_BINARY"], *map(str, arguments)], capture_output=True, text=True, timeout=100)


def doctor(data, *options):
    result = rouleau("doctor", "--data", data, "--json", *options)
    return result.returncode, json.loads(result.stdout)


def findings(report):
    return {(finding["kind"], finding["subject"]) for finding in report["findings"] if finding["kind"] != "note"}


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """The data folder of a service that has ended, with three jobs of which one was cancelled."""
    data = tmp_path_factory.mktemp("operations") / "data"
    with Server(data) as server:
        done = [server.submit(plasma(duration=duration)) for duration in (1e-5, 2e-5)]
        cancelled = server.submit(endless())
        server.wait_until_running(cancelled)
        server.request("POST", f"/v1/jobs/{cancelled}:cancel")
        for job in (*done, cancelled):
            server.wait(job)
        assert server.terminate() == 0
    return data, done


@pytest.fixture
def data(served, tmp_path):
    shutil.copytree(served[0], tmp_path / "data")
    return tmp_path / "data"


@pytest.fixture
def done(served):
    return served[1]


class TestDoctor:
    def test_a_folder_as_the_service_left_it_is_healthy(self, data):
        code, report = doctor(data, "--deep")
        assert (code, report["healthy"], report["jobs"], report["archives"]) == (0, True, 3, 2)
        assert findings(report) == set()

    def test_a_folder_in_use_is_left_alone(self, tmp_path):
        with Server(tmp_path / "data") as server:
            result = rouleau("doctor", "--data", server.data)
            assert result.returncode == 2
            assert f"in use by process {server.process.pid}: stop it first" in result.stderr

    def test_what_is_no_data_folder_is_not_made_one(self, tmp_path):
        result = rouleau("doctor", "--data", tmp_path)
        assert result.returncode == 2 and "no job store" in result.stderr
        assert list(tmp_path.iterdir()) == []

    def test_leftovers_are_found_and_put_away(self, data, done):
        stranger = "01900000-0000-7000-8000-000000000000"
        left = [f"archives/{stranger}.h5", f"archives/{stranger}.xdmf", f"archives/{stranger}.h5.part",
                f"archives/{done[0]}.h5.checkpoint", f"archives/{done[0]}.h5.checkpoint.part", "archives/notes.txt",
                f"logs/{stranger}.log"]
        for name in left:
            (data / name).parent.mkdir(exist_ok=True)
            (data / name).write_text(name)
        code, report = doctor(data)
        assert code == 1
        assert findings(report) == {("leftover", name) for name in left}
        assert all((data / name).exists() for name in left), "looking changes nothing"
        code, report = doctor(data, "--mend")
        assert code == 0 and all(finding["mended"] for finding in report["findings"] if finding["kind"] != "note")
        assert [(data / "lost+found" / name).read_text() for name in left] == left
        assert doctor(data)[0] == 0

    @pytest.mark.parametrize("damage", ["gone", "cut", "overwritten", "changed"])
    def test_a_job_whose_archive_is_lost_can_be_tried_again(self, data, done, damage):
        archive = data / "archives" / f"{done[0]}.h5"
        content = archive.read_bytes()
        deep = ["--deep"] if damage == "changed" else []
        if damage == "gone":
            archive.unlink()
        elif damage == "cut":
            archive.write_bytes(content[:-1000])
        elif damage == "overwritten":
            archive.write_bytes(bytes(len(content)))
        else:  # in the middle of some numbers, where HDF5 sees nothing
            archive.write_bytes(content[:-9] + bytes([content[-9] ^ 1]) + content[-8:])
        code, report = doctor(data, *deep)
        assert code == 1 and findings(report) == {("lost", f"archives/{done[0]}.h5")}
        assert doctor(data, "--mend", *deep)[0] == 0
        assert doctor(data, "--deep")[0] == 0
        with Server(data) as server:
            job = server.job(done[0])
            assert job["state"] == "failed" and job["error"]["kind"] == "infrastructure"
            assert "retry" in job["error"]["message"]
            assert server.request("POST", f"/v1/jobs/{done[0]}:retry").status in (200, 202)
            assert server.wait(done[0])["state"] == "succeeded"
            assert server.terminate() == 0
        assert doctor(data, "--deep")[0] == 0
        assert (data / "lost+found/archives" / archive.name).exists() == (damage != "gone")

    def test_what_a_job_can_go_on_from_stays(self, data, done):
        """One that failed for want of room may be tried again; another's archive was published just before a kill."""
        database = sqlite3.connect(data / "jobs.sqlite")
        database.execute("UPDATE jobs SET state = 'failed', error = '{}', summary = NULL, archive_id = NULL, archive_size = NULL, "
                         "archive_sha256 = NULL WHERE id = ?", (done[0],))
        database.commit()
        database.close()
        (data / "archives" / f"{done[0]}.h5.checkpoint").write_text("here it goes on")
        assert doctor(data, "--mend")[0] == 0
        assert (data / "archives" / f"{done[0]}.h5.checkpoint").exists() and (data / "archives" / f"{done[0]}.h5").exists()

    def test_a_disk_that_is_not_there_loses_no_job(self, data, done):
        (data / "archives").rename(data / "elsewhere")
        (data / "archives").mkdir()
        code, report = doctor(data, "--mend")
        assert code == 1 and findings(report) == {("damage", "archives")}
        (data / "archives").rmdir()
        (data / "elsewhere").rename(data / "archives")
        assert doctor(data, "--deep")[0] == 0

    def test_a_damaged_store_is_named_and_nothing_is_touched(self, data):
        database = data / "jobs.sqlite"
        content = bytearray(database.read_bytes())
        content[4096:12288] = bytes(8192)
        database.write_bytes(content)
        code, report = doctor(data, "--mend")
        assert code == 1
        assert {kind for kind, _ in findings(report)} == {"damage"}
        assert any("restore" in finding["mend"] for finding in report["findings"])
        assert database.read_bytes() == content


class TestBackup:
    def test_a_service_at_work_is_copied_and_restored(self, tmp_path):
        backup, other = tmp_path / "backup", tmp_path / "other"
        with Server(tmp_path / "data") as server:
            first = [server.submit(plasma(duration=1.01e-5 * (k + 1))) for k in range(3)]
            for job in first:
                server.wait(job)
            going_on = threading.Event()
            more = []

            def submit():
                while not going_on.is_set():
                    more.append(server.submit(plasma(duration=1.5e-6 * (len(more) + 1))))

            submitting = threading.Thread(target=submit)
            submitting.start()
            result = rouleau("backup", backup, "--data", server.data, "--json")
            going_on.set()
            submitting.join()
            assert result.returncode == 0, result.stderr
            before = json.loads(result.stdout)
            assert before["jobs"] >= 3 and before["missing"] == []
            for job in more:
                server.wait(job)
            again = json.loads(rouleau("backup", backup, "--data", server.data, "--json").stdout)
            assert again["jobs"] == 3 + len(more)
            assert again["added"] <= again["files"] - 3, "what the backup had was not copied again"
            stored = {job: (server.data / "archives" / f"{job}.h5").read_bytes() for job in first + more}
        assert rouleau("restore", backup, "--data", other).returncode == 0
        code, report = doctor(other, "--deep")
        assert (code, report["healthy"], report["jobs"]) == (0, True, 3 + len(more))
        with Server(other) as server:
            for job, content in stored.items():
                assert server.get(f"/v1/jobs/{job}/archive.h5").body == content
            job = server.submit(plasma(duration=3e-5, name="another"))
            assert server.wait(job)["state"] == "succeeded"

    def test_what_else_is_in_a_folder_stays(self, data, tmp_path):
        for name in ("files/thesis.pdf", "notes.txt"):
            folder = tmp_path / name.replace("/", "_")
            (folder / name).parent.mkdir(parents=True)
            (folder / name).write_text("not to be had again")
            result = rouleau("backup", folder, "--data", data)
            assert result.returncode == 1 and "a folder for the backup alone" in result.stderr
            assert [path.read_text() for path in folder.rglob("*") if path.is_file()] == ["not to be had again"]

    def test_a_damaged_store_takes_no_good_ones_place(self, data, tmp_path):
        backup = tmp_path / "backup"
        assert rouleau("backup", backup, "--data", data).returncode == 0
        before = {path: path.read_bytes() for path in backup.rglob("*") if path.is_file() and path.name != "lock"}
        database = data / "jobs.sqlite"
        content = bytearray(database.read_bytes())
        pages = sqlite3.connect(database)
        root = pages.execute("SELECT rootpage FROM sqlite_schema WHERE name = 'job_inputs'").fetchone()[0]
        pages.close()
        content[(root - 1) * 4096:root * 4096] = bytes(4096)
        database.write_bytes(content)
        result = rouleau("backup", backup, "--data", data)
        assert result.returncode != 0 and "damaged" in result.stderr
        assert {path: path.read_bytes() for path in before} == before
        assert rouleau("restore", backup, "--data", tmp_path / "other").returncode == 0

    def test_links_take_no_room_and_outlive_what_they_link_to(self, data, done, tmp_path):
        backup = tmp_path / "backup"
        assert rouleau("backup", backup, "--data", data, "--link").returncode == 0
        archive = data / "archives" / f"{done[0]}.h5"
        assert archive.stat().st_nlink == 2
        shutil.rmtree(data)
        assert rouleau("restore", backup, "--data", data).returncode == 0
        assert h5py.is_hdf5(archive) and archive.stat().st_nlink == 1

    def test_a_damaged_archive_is_not_linked(self, data, done, tmp_path):
        archive = data / "archives" / f"{done[1]}.h5"
        content = archive.read_bytes()
        archive.write_bytes(content[:-9] + bytes([content[-9] ^ 1]) + content[-8:])
        result = rouleau("backup", tmp_path / "backup", "--data", data, "--link", "--json")
        assert result.returncode == 1 and json.loads(result.stdout)["missing"] == [f"archives/{done[1]}.h5"]

    def test_an_archive_that_is_gone_is_said(self, data, done, tmp_path):
        (data / "archives" / f"{done[1]}.h5").unlink()
        result = rouleau("backup", tmp_path / "backup", "--data", data, "--json")
        assert result.returncode == 1
        assert json.loads(result.stdout)["missing"] == [f"archives/{done[1]}.h5"]
        assert f"archives/{done[1]}.h5 is gone" in result.stderr
        assert rouleau("restore", tmp_path / "backup", "--data", tmp_path / "other").returncode == 0
        assert findings(doctor(tmp_path / "other")[1]) == {("lost", f"archives/{done[1]}.h5")}

    def test_contents_that_no_backup_names_any_more_are_removed(self, data, done, tmp_path):
        backup = tmp_path / "backup"
        rouleau("backup", backup, "--data", data)
        held = {path.name for path in (backup / "files").iterdir()}
        database = sqlite3.connect(data / "jobs.sqlite")
        database.execute("DELETE FROM jobs WHERE id = ?", (done[0],))
        database.commit()
        database.close()
        assert rouleau("backup", backup, "--data", data).returncode == 0
        manifest = json.loads((backup / "manifest.json").read_text())
        assert {path.name for path in (backup / "files").iterdir()} == {file["sha256"] for file in manifest["files"]} != held

    def test_a_folder_that_is_not_empty_is_not_restored_into(self, data, tmp_path):
        rouleau("backup", tmp_path / "backup", "--data", data)
        before = sorted(data.rglob("*"))
        result = rouleau("restore", tmp_path / "backup", "--data", data)
        assert result.returncode == 1 and "not empty" in result.stderr
        assert sorted(data.rglob("*")) == before

    def test_every_fault_of_a_backup_is_named_and_nothing_is_there(self, data, tmp_path):
        backup, other = tmp_path / "backup", tmp_path / "other"
        rouleau("backup", backup, "--data", data)
        files = {file["path"]: backup / "files" / file["sha256"]
                 for file in json.loads((backup / "manifest.json").read_text())["files"]}
        archives = [path for path in files if path.endswith(".h5")]
        files[archives[0]].unlink()
        content = files[archives[1]].read_bytes()
        files[archives[1]].write_bytes(content[:-1] + b"!")
        result = rouleau("restore", backup, "--data", other)
        assert result.returncode == 1
        assert f"{archives[0]} is not there" in result.stderr and f"{archives[1]} is damaged" in result.stderr
        assert [path.name for path in tmp_path.iterdir() if path.name.startswith("other")] == []

    @pytest.mark.parametrize("path", ["../outside", "/etc/outside", "archives/../../outside"])
    def test_a_manifest_names_nothing_outside(self, data, tmp_path, path):
        backup = tmp_path / "backup"
        rouleau("backup", backup, "--data", data)
        manifest = json.loads((backup / "manifest.json").read_text())
        manifest["files"][0]["path"] = path
        (backup / "manifest.json").write_text(json.dumps(manifest))
        result = rouleau("restore", backup, "--data", tmp_path / "other")
        assert result.returncode == 1 and "names a file that no data folder has" in result.stderr
        assert not pathlib.Path("/etc/outside").exists() and not (tmp_path / "outside").exists()

    def test_what_was_not_finished_is_no_backup(self, data, tmp_path):
        backup = tmp_path / "backup"
        rouleau("backup", backup, "--data", data)
        (backup / "manifest.json").unlink()
        result = rouleau("restore", backup, "--data", tmp_path / "other")
        assert result.returncode == 1 and "not finished" in result.stderr
