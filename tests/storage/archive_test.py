"""An archive opened by the programs that people use: h5py, MDAnalysis, and an XML parser for ParaView's
sidecar.  usage: archive_test.py WRITE_SYNTHETIC_ARCHIVE"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
import warnings
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

WRITER = sys.argv.pop()
FRAMES, CELLS, NODES, PLASMA, CAPACITY = 6, 2, 12, 20, 49


def setUpModule():
    global folder, path
    folder = tempfile.TemporaryDirectory()
    path = os.path.join(folder.name, "run.h5")
    subprocess.run([WRITER, path], check=True)


def tearDownModule():
    folder.cleanup()


class InH5py(unittest.TestCase):
    def setUp(self):
        self.file = h5py.File(path, "r")
        self.trajectory = self.file["particles/trajectory"]

    def tearDown(self):
        self.file.close()

    def test_says_that_it_is_h5md(self):
        self.assertEqual(list(self.file["h5md"].attrs["version"]), [1, 1])
        self.assertEqual(self.file["h5md/creator"].attrs["name"].decode(), "rouleau")
        self.assertIn("name", self.file["h5md/author"].attrs)
        box = self.trajectory["box"].attrs
        self.assertEqual(box["dimension"], 3)
        self.assertEqual([b.decode() for b in box["boundary"]], ["none"] * 3)

    def test_elements_have_one_record_a_frame(self):
        for name, shape in {"position": (CAPACITY, 3), "velocity": (CAPACITY, 3), "pressure": (CAPACITY,),
                            "species": (CAPACITY,), "id": (CAPACITY,), "alive": (CAPACITY,),
                            "cell": (CAPACITY,)}.items():
            element = self.trajectory[name]
            self.assertEqual(element["value"].shape, (FRAMES, *shape), name)
            self.assertEqual(element["value"].chunks, (1, *shape), name)
            self.assertEqual(element["step"], self.trajectory["position/step"], name)
            self.assertEqual(element["time"], self.trajectory["position/time"], name)
            self.assertNotIn("unit", element["value"].attrs)
        np.testing.assert_allclose(self.trajectory["position/time"], 1e-4 * np.arange(FRAMES))
        np.testing.assert_array_equal(self.trajectory["position/step"], 100 * np.arange(FRAMES))
        self.assertEqual(self.trajectory["id/value"].fillvalue, -1)

    def test_a_particle_keeps_its_slot_and_the_dead_are_parked(self):
        ids, alive = self.trajectory["id/value"][:], self.trajectory["alive/value"][:] == 1
        position = self.trajectory["position/value"][:]
        self.assertTrue((alive.sum(axis=1) == CELLS * NODES + PLASMA).all())
        self.assertTrue(((ids == -1) == ~alive).all())
        slots = {}
        for k in range(FRAMES):
            for slot in np.flatnonzero(alive[k]):
                self.assertEqual(slots.setdefault(ids[k, slot], slot), slot)
        self.assertGreater(len(slots), CELLS * NODES + PLASMA, "nobody came")
        np.testing.assert_allclose(position[~alive], np.tile([40e-6, 5e-6, 0], ((~alive).sum(), 1)), rtol=1e-6)

    def test_series_with_units_in_order(self):
        columns = [c.decode() for c in self.file["series"].attrs["columns"]]
        self.assertEqual(columns, ["time", "cell0.x", "particles"])
        self.assertEqual(self.file["series/cell0.x"].attrs["unit"].decode(), "m")
        np.testing.assert_allclose(self.file["series/time"], 2e-5 * np.arange(5 * FRAMES))

    def test_probes_with_units_in_order(self):
        probes = self.file["probes"]
        self.assertEqual([n.decode() for n in probes.attrs["names"]], ["line", "point"])
        line, point = probes["line"], probes["point"]
        np.testing.assert_allclose(line["x"], [1e-6] * 3)
        np.testing.assert_allclose(line["y"], [-1e-6, 0, 1e-6])
        rows = np.arange(5 * FRAMES)
        np.testing.assert_array_equal(line["time"], self.file["series/time"])
        np.testing.assert_allclose(line["u"], np.stack([rows * np.nan, 0 * rows, 1e-3 * rows], axis=1))
        np.testing.assert_allclose(line["v"], np.stack([rows * np.nan, 0 * rows, -1e-3 * rows], axis=1))
        np.testing.assert_allclose(line["p"], np.stack([rows * np.nan, 40 - rows, 41 - rows], axis=1))
        np.testing.assert_allclose(line["flux"], 1e-9 * rows)
        np.testing.assert_allclose(point["u"], 2e-3 * rows[:, None])
        self.assertNotIn("flux", point)
        self.assertEqual(line["p"].attrs["unit"].decode(), "Pa")

    def test_stress_on_the_walls(self):
        walls = self.file["walls"]
        np.testing.assert_allclose(walls["arc_length"], [0, 4e-5, 0, 4e-5])
        np.testing.assert_array_equal(walls["normal"], [[0, 1], [0, 1], [0, -1], [0, -1]])
        np.testing.assert_array_equal(walls["wall"], [0, 0, 1, 1])
        self.assertEqual(walls["time"], self.trajectory["position/time"])
        frames, nodes = np.arange(FRAMES)[:, None], np.arange(4)
        np.testing.assert_allclose(walls["shear_stress"], frames + 0.25 * nodes)

    def test_fields_of_the_membranes(self):
        self.assertEqual([n.decode() for n in self.file["outlines"].attrs["fields"]], ["strain", "tension"])
        cell = self.file["outlines/cell1"]
        frames, links = np.arange(FRAMES)[:, None], NODES + np.arange(NODES)
        np.testing.assert_allclose(cell["strain"], frames + 0.01 * links, rtol=1e-6)
        np.testing.assert_allclose(cell["tension"], 0 * frames + 1e-6 * links, rtol=1e-6)
        self.assertEqual(cell["tension"].attrs["unit"].decode(), "N/m")

    def test_outlines_areas_and_bonds(self):
        outline = self.file["outlines/cell1/value"][:]
        self.assertEqual(outline.shape, (FRAMES, NODES, 2))
        x, y = outline[..., 0].astype(float), outline[..., 1].astype(float)
        area = 0.5 * (x * np.roll(y, -1, 1) - np.roll(x, -1, 1) * y).sum(axis=1)
        np.testing.assert_allclose(self.file["observables/cell1_area/value"], area, rtol=1e-4)
        np.testing.assert_allclose(area, 0.5 * NODES * np.sin(2 * np.pi / NODES) * 2e-6**2, rtol=1e-4)
        bonds = self.file["connectivity/membrane_bonds"]
        self.assertEqual(bonds.shape, (CELLS * NODES, 2))
        self.assertEqual(self.file[bonds.attrs["particles_group"]], self.trajectory)
        neighbours = dict(bonds[:])
        node, seen = 0, []
        for _ in range(NODES):
            seen.append(node)
            node = neighbours[node]
        self.assertEqual((sorted(seen), node), (list(range(NODES)), 0), "the first cell is one ring")

    def test_case_plan_and_ending(self):
        parameters = self.file["parameters"]
        self.assertEqual(json.loads(parameters["case_given"][()])["name"], "érythrocyte")
        self.assertEqual(json.loads(parameters["case_resolved"][()])["vessel"]["length"], 80e-6)
        self.assertEqual(json.loads(parameters["plan"][()])["particles"], CELLS * NODES + PLASMA)
        self.assertEqual(json.loads(parameters["summary"][()])["steps"], 1000)
        self.assertEqual(parameters["ending"][()].decode(), "completed")
        self.assertEqual(parameters["units"].attrs["velocity"].decode(), "m/s")


class InMDAnalysis(unittest.TestCase):
    def test_a_universe_moves_through_the_frames(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
            from MDAnalysis.coordinates.H5MD import H5MDReader
            universe = MDAnalysis.Universe.empty(CAPACITY, trajectory=False)
            universe.load_new(path, format=H5MDReader, convert_units=False)
        self.assertEqual(len(universe.trajectory), FRAMES)
        for k, frame in enumerate(universe.trajectory):
            self.assertAlmostEqual(frame.time, 1e-4 * k)
            self.assertEqual(frame.data["step"], 100 * k)
            self.assertIn("cell0_area", frame.data)
            first_cell = universe.atoms[:NODES]
            np.testing.assert_allclose(first_cell.positions[:, 0].mean(), 1e-5 + 1e-6 * k, rtol=1e-5)
            np.testing.assert_allclose(first_cell.velocities[:, 1], -1e-3 * k, rtol=1e-6)


class TheSidecar(unittest.TestCase):
    """Every frame that the XDMF names is where it says, and is that frame."""

    def setUp(self):
        self.domain = ElementTree.parse(path.replace(".h5", ".xdmf")).getroot().find("Domain")
        self.file = h5py.File(path, "r")

    def tearDown(self):
        self.file.close()

    def record(self, item):
        selection, source = item.findall("DataItem")
        name, inside = source.text.split(":")
        self.assertEqual(name, "run.h5")
        dataset = self.file[inside]
        self.assertEqual(source.get("Dimensions"), " ".join(map(str, dataset.shape)))
        start, stride, count = np.array(selection.text.split(), dtype=int).reshape(3, -1)
        self.assertTrue((stride == 1).all())
        block = dataset[tuple(slice(s, s + c) for s, c in zip(start, count))][0]
        self.assertEqual(item.get("Dimensions"), " ".join(map(str, block.shape)))
        return block

    def test_particles(self):
        frames = self.domain.findall("Grid")[0].findall("Grid")
        self.assertEqual(len(frames), FRAMES)
        for k, grid in enumerate(frames):
            self.assertAlmostEqual(float(grid.find("Time").get("Value")), 1e-4 * k)
            found = self.record(grid.find("Geometry/DataItem"))
            np.testing.assert_array_equal(found, self.file["particles/trajectory/position/value"][k])
            names = {}
            for attribute in grid.findall("Attribute"):
                names[attribute.get("Name")] = self.record(attribute.find("DataItem"))
            self.assertEqual(set(names), {"velocity", "pressure", "species", "alive", "cell", "id"})
            np.testing.assert_array_equal(names["id"], self.file["particles/trajectory/id/value"][k])

    def test_outlines(self):
        cells = self.domain.findall("Grid")[1:]
        self.assertEqual(len(cells), CELLS)
        for c, cell in enumerate(cells):
            for k, grid in enumerate(cell.findall("Grid")):
                found = self.record(grid.find("Geometry/DataItem"))
                np.testing.assert_array_equal(found, self.file[f"outlines/cell{c}/value"][k])
                for attribute in grid.findall("Attribute"):
                    name = attribute.get("Name")
                    found = self.record(attribute.find("DataItem"))
                    np.testing.assert_array_equal(found, self.file[f"outlines/cell{c}/{name}"][k])
                self.assertEqual([a.get("Name") for a in grid.findall("Attribute")], ["strain", "tension"])
            order = grid.find("Topology/DataItem").text.split()
            self.assertEqual(order, [str(i) for i in range(NODES)] + ["0"])


if __name__ == "__main__":
    unittest.main()
