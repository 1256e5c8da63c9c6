import os

import pytest

from rouleau_server import Server


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    with Server(tmp_path_factory.mktemp("service") / "data") as running:
        yield running


@pytest.fixture
def rouleau():
    return os.environ["ROULEAU_BINARY"]
