"""Probes and the fields of frames, from the case to the command line and the API."""

import csv
import io
import json
import subprocess

import pytest
from rouleau_server import endless, plasma

PROBES = [
    {"name": "across", "from": [10e-6, 0], "to": [10e-6, 10e-6], "points": 5},
    {"name": "beyond", "from": [12e-6, 3e-6], "to": [12e-6, 3e-6]},
]


def case():
    return plasma(probes=PROBES, inflow={"profile": "parabolic"},
                  output={"series_interval": 2e-5, "frame_interval": 5e-5, "fields": ["pressure", "wall_shear_stress"]})


@pytest.fixture(scope="module")
def job(server):
    job = server.wait(server.submit(case()))
    assert job["state"] == "succeeded"
    return job


def test_the_api_lists_and_gives_them(server, job):
    url = f"/v1/jobs/{job['id']}/probes"
    assert server.get(url).json() == {"names": ["across", "beyond"]}
    across = server.get(f"{url}/across").json()
    rows = server.get(f"/v1/jobs/{job['id']}/series?columns=time").json()["rows"]
    assert across["time"] == [row[0] for row in rows]
    assert across["x"] == [10e-6] * 5 and len(across["flux"]) == len(rows)
    assert all(len(row) == 5 for name in "uvp" for row in across[name]) and len(across["u"]) == len(rows)
    assert across["u"][-1][2] == pytest.approx(7.5e-3, rel=0.1)
    assert across["flux"][-1] == pytest.approx(5e-8, rel=0.05)
    assert "flux" not in server.get(f"{url}/beyond").json()
    assert server.get(f"{url}/none").status == 404


def test_a_running_job_has_none_yet(server):
    job_id = server.submit(endless(probes=PROBES))
    assert server.get(f"/v1/jobs/{job_id}/probes/across").status == 409
    server.request("POST", f"/v1/jobs/{job_id}:cancel")


def test_frames_carry_the_fields_that_the_case_names(server, job):
    frame = server.get(f"/v1/jobs/{job['id']}/frames/2").json()
    particles, walls = frame["particles"], frame["walls"]
    assert len(particles["p"]) == len(particles["id"])
    assert "u" not in particles and "v" not in particles
    assert len(walls["shear_stress"]) == len(walls["x"]) == len(walls["arc_length"])
    in_the_middle = [s for s, x in zip(walls["shear_stress"], walls["x"]) if 8e-6 < x < 12e-6]
    assert in_the_middle and all(s == pytest.approx(3, rel=0.2) for s in in_the_middle)


def test_series_prints_a_probe(server, tmp_path):
    (tmp_path / "case.json").write_text(json.dumps(case()))

    def call(*arguments):
        return subprocess.run([server.binary, *arguments], cwd=tmp_path, capture_output=True, text=True)

    assert call("run", "case.json", "-o", "out.h5").returncode == 0
    table = list(csv.DictReader(io.StringIO(call("series", "out.h5", "--probe", "across", "--csv").stdout)))
    assert list(table[0]) == ["time", "x", "y", "u", "v", "p", "flux"]
    assert [float(row["y"]) for row in table[:5]] == pytest.approx([0, 2.5e-6, 5e-6, 7.5e-6, 10e-6])
    assert len(table) % 5 == 0 and len({row["time"] for row in table}) == len(table) // 5
    point = json.loads(call("series", "out.h5", "--probe", "beyond", "--json").stdout)
    assert point["columns"] == ["time", "x", "y", "u", "v", "p"] and len(point["rows"]) == len(table) // 5
    two = call("series", "out.h5", "--probe", "beyond", "--columns", "time,u", "--csv").stdout.splitlines()
    assert two[0] == "time,u"
    for arguments, said in ((("--probe", "none"), "across, beyond"),
                            (("--probe", "across", "--columns", "nope"), "nope")):
        done = call("series", "out.h5", *arguments)
        assert done.returncode == 2 and said in done.stderr
