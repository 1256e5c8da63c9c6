"""deploy/install on machines that it has to find out about: what it asks them is answered from a folder of
commands of our own, first on its PATH."""

import os
import subprocess

import pytest

from repository import ROOT, packages


@pytest.fixture
def machine(tmp_path):
    """Sets what a command answers on the machine, and runs deploy/install there."""
    tools = tmp_path / "tools"
    tools.mkdir()

    class Machine:
        def answers(self, command, script):
            path = tools / command
            path.write_text("#!/bin/bash\n" + script + "\n")
            path.chmod(0o755)

        def install(self, *arguments):
            return subprocess.run([ROOT / "deploy/install", *arguments], capture_output=True, text=True,
                                  stdin=subprocess.DEVNULL, env={**os.environ, "PATH": f"{tools}:/usr/bin:/bin"})

    return Machine()


def of_group(*groups):
    return [package for group, package, _ in packages() if group in groups]


def test_a_bare_machine_lacks_the_whole_list(machine):
    machine.answers("dpkg-query", "exit 1")
    machine.answers("node", "exit 1")
    assert machine.install("--list").stdout.split() == of_group("build", "test")
    assert machine.install("--list", "build").stdout.split() == of_group("build")


def test_a_removed_package_is_missing(machine):
    machine.answers("dpkg-query", 'if [[ ${@: -1} == cmake ]]; then echo config-files; else echo installed; fi')
    machine.answers("node", "exit 0")
    machine.answers("npm", "exit 0")
    assert machine.install("--list").stdout.split() == ["cmake"]


def test_nothing_is_installed_where_nothing_is_missing(machine):
    machine.answers("dpkg-query", "echo installed")
    machine.answers("node", "exit 0")
    machine.answers("npm", "exit 0")
    machine.answers("apt-get", "exit 99")
    result = machine.install()
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


def test_a_node_that_is_too_old_is_replaced(machine):
    machine.answers("dpkg-query", "echo installed")
    machine.answers("node", "exit 1")
    machine.answers("npm", "exit 0")
    assert machine.install("--list", "build").stdout.split() == ["nodejs", "npm"]


def test_lists_are_fetched_where_a_package_is_not_found(machine, tmp_path):
    log, fetched = tmp_path / "log", tmp_path / "fetched"
    machine.answers("id", "echo 0")
    machine.answers("dpkg-query", 'if [[ ${@: -1} == cmake ]]; then exit 1; else echo installed; fi')
    machine.answers("node", "exit 0")
    machine.answers("npm", "exit 0")
    machine.answers("apt-get", f'echo "$1" >>{log}; if [[ $1 == update ]]; then touch {fetched}; else [[ -e {fetched} ]]; fi')
    assert machine.install().returncode == 0
    assert log.read_text().split() == ["install", "update", "install"]


def test_who_may_not_install_is_told_what_to_ask_for(machine):
    if os.path.exists("/usr/bin/sudo"):
        pytest.skip("this machine has sudo")
    machine.answers("id", "echo 1000")
    machine.answers("dpkg-query", 'if [[ ${@: -1} == cmake ]]; then exit 1; else echo installed; fi')
    machine.answers("node", "exit 0")
    machine.answers("npm", "exit 0")
    result = machine.install()
    assert result.returncode == 1
    assert "neither root nor has it sudo" in result.stderr
    assert "apt-get install --no-install-recommends cmake\n" in result.stderr


def test_an_unknown_group_is_refused(machine):
    result = machine.install("everything")
    assert result.returncode == 2
    assert result.stderr.startswith("usage: deploy/install")
