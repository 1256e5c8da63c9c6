"""Outputs that a case asks for by its effects, from the case to the API and the archive."""

import io

import h5py
import pytest
from rouleau_server import endless, plasma

EFFECTS = {
    "hydraulic_resistance": "on",
    "cell_free_layer": "on",
    "fahraeus": "on",
    "membrane_maps": {"strain_threshold": 0.01},
    "hemolysis": "on",
}
CELLS = {"cells": [{"x": 10e-6, "y": 5e-6}], "effects": EFFECTS}


@pytest.fixture(scope="module")
def job(server):
    job = server.wait(server.submit(plasma(**CELLS, output={"series_interval": 2e-5, "frame_interval": 5e-5})))
    assert job["state"] == "succeeded"
    return job


def test_the_plan_says_that_the_case_asks_for_them(server, job):
    effects = {effect["name"]: effect for effect in job["plan"]["effects"]}
    assert all(effects[name]["on"] and effects[name]["stage"] == "observers" for name in EFFECTS)
    without = server.job(server.submit(plasma()))["plan"]["effects"]
    assert not any(effect["on"] for effect in without if effect["name"] in EFFECTS)


def test_their_columns_stand_behind_the_others(server, job):
    table = server.get(f"/v1/jobs/{job['id']}/series").json()
    columns = table["columns"]
    assert columns.index("resistance") > columns.index("spacing")
    last = dict(zip(columns, table["rows"][-1]))
    free = 12e-3 * 20e-6 / (10e-6) ** 3
    assert last["resistance_free"] == pytest.approx(free, rel=0.1) and last["resistance"] > 0
    assert 0 < last["cell_free_layer.lower"] < 5e-6
    assert 0.5 < last["fahraeus.ratio"] < 1
    assert last["cell0.hemolysis"] > 0
    assert table["units"]["resistance"] == "Pa s/m2" and table["units"]["cell0.scalar_shear_stress"] == "Pa"


def test_the_summary_has_what_they_found_and_warns(job):
    findings = job["summary"]["findings"]
    assert findings["cell0.hemolysis"]["value"] > 0
    assert findings["resistance.mean"]["unit"] == "Pa s/m2"
    assert any("calibration" in warning for warning in job["summary"]["warnings"])


def test_frames_and_archive_carry_strain_and_tension(server, job):
    frame = server.get(f"/v1/jobs/{job['id']}/frames/1").json()
    outline = frame["outlines"][0]
    assert len(outline["x"]) == len(outline["strain"]) == len(outline["tension"]) > 20
    with h5py.File(io.BytesIO(server.get(f"/v1/jobs/{job['id']}/archive.h5").body)) as file:
        assert file["outlines/cell0/tension"][1] == pytest.approx(outline["tension"], rel=1e-6)
        assert file["outlines/cell0/strain"].attrs["unit"].decode() == "1"


def test_outlines_of_a_running_job_have_them_too(server):
    job_id = server.submit(endless(**CELLS))
    server.wait_until_running(job_id)
    outline = server.get(f"/v1/jobs/{job_id}/frames/0").json()["outlines"][0]
    assert len(outline["strain"]) == len(outline["x"])
    server.request("POST", f"/v1/jobs/{job_id}:cancel")


def test_what_a_scene_cannot_carry_is_refused(server):
    answer = server.request("POST", "/v1/cases:validate", plasma(effects={"hemolysis": "on"}))
    assert answer.status == 422
    assert [error["pointer"] for error in answer.json()["errors"]] == ["/effects/hemolysis"]
