"""What deploy/run refuses, before it installs or builds anything."""

import fcntl
import os
import socket
import subprocess

import pytest

from repository import ROOT


def run(*arguments, **environment):
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("ROULEAU_", "XDG_"))}
    return subprocess.run([ROOT / "deploy/run", *arguments], capture_output=True, text=True, timeout=20,
                          stdin=subprocess.DEVNULL, env={**clean, **environment})


def refusal(*arguments, **environment):
    result = run(*arguments, **environment)
    assert result.returncode == 1
    assert "== build" not in result.stdout
    return result.stderr


def test_help():
    result = run("--help")
    assert result.returncode == 0
    assert result.stdout.startswith("usage: deploy/run")


def test_an_unknown_option_is_refused():
    result = run("--twice")
    assert result.returncode == 2
    assert result.stderr.startswith("usage: deploy/run")


@pytest.mark.parametrize("port", ["0", "65535", "99999", "http", "-1", "08080", ""])
def test_a_port_that_cannot_be_is_refused(port, tmp_path):
    assert "the port must be a number from 1 to 65534" in refusal("--port", port, HOME=str(tmp_path))


@pytest.mark.parametrize("below", [0, 1])
def test_a_taken_port_is_named(below, tmp_path):
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        answer = refusal("--port", str(port - below), ROULEAU_DATA=str(tmp_path))
    assert f"port {port} of 127.0.0.1 is taken" in answer


def test_a_second_service_on_the_same_data_is_refused(tmp_path):
    with open(tmp_path / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        lock.write("4321\n")
        lock.flush()
        answer = refusal(ROULEAU_DATA=str(tmp_path))
    assert f"a rouleau already serves the data in {tmp_path} (process 4321)" in answer
