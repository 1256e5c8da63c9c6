"""Whether two archives hold the same to the last bit, but for the time that it took."""

import json

import h5py
import numpy

TIMES = {"wall_time", "steps_per_second", "effect_times"}


def contents(path):
    """Every dataset and attribute by its name."""
    found = {}
    with h5py.File(path) as archive:

        def add(name, item):
            for key, value in item.attrs.items():
                found[f"{name}@{key}"] = archive[value].name if isinstance(value, h5py.Reference) else value
            if isinstance(item, h5py.Dataset):
                found[name] = item.asstr()[()] if h5py.check_string_dtype(item.dtype) else item[()]

        add("", archive)
        archive.visititems(add)
    summary = json.loads(found.pop("parameters/summary"))
    return found, {key: value for key, value in summary.items() if key not in TIMES}


def assert_same(one, other):
    (data, summary), (expected, expected_summary) = contents(one), contents(other)
    assert data.keys() == expected.keys()
    assert len(data["series/time"]) > 1
    for name, value in data.items():
        assert numpy.asarray(value).tobytes() == numpy.asarray(expected[name]).tobytes(), name
    assert summary == expected_summary
