"""The servers of other queues, each with a folder and a port of its own and the durability that Rouleau has."""

import contextlib
import os
import pathlib
import shutil
import socket
import subprocess
import time

HERE = pathlib.Path(__file__).parent


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(port, process, patience=30):
    deadline = time.monotonic() + patience
    while True:
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=1):
            return
        if process.poll() is not None or time.monotonic() > deadline:
            raise SystemExit(f"{process.args[0]} does not answer on port {port}")
        time.sleep(0.05)


@contextlib.contextmanager
def redis(folder):
    port = free_port()
    process = subprocess.Popen(
        ["redis-server", "--port", str(port), "--bind", "127.0.0.1", "--dir", str(folder), "--save", "", "--appendonly", "yes",
         "--appendfsync", "always"], stdout=subprocess.DEVNULL)
    try:
        wait_for(port, process)
        yield port
    finally:
        process.terminate()
        process.wait()


def postgres_programs():
    """The newest of those that Debian keeps apart by version."""
    found = sorted(pathlib.Path("/usr/lib/postgresql").glob("*/bin"), key=lambda path: int(path.parent.name))
    if not found:
        raise SystemExit("there is no PostgreSQL: apt-get install postgresql")
    return found[-1]


@contextlib.contextmanager
def postgres(folder):
    programs, data, port = postgres_programs(), folder / "data", free_port()
    other = {}
    if os.geteuid() == 0:  # as which it refuses to run
        shutil.chown(folder, "postgres", "postgres")
        other = {"user": "postgres", "group": "postgres", "extra_groups": []}
    subprocess.run([programs / "initdb", "-D", data, "-U", "postgres", "--auth=trust"], check=True, cwd=folder,
                   stdout=subprocess.DEVNULL, **other)
    settings = {"port": port, "listen_addresses": "127.0.0.1", "unix_socket_directories": folder, "fsync": "on",
                "synchronous_commit": "on", "full_page_writes": "on"}
    options = [part for name, value in settings.items() for part in ("-c", f"{name}={value}")]
    process = subprocess.Popen([programs / "postgres", "-D", data, *options], cwd=folder, stderr=subprocess.DEVNULL, **other)
    try:
        wait_for(port, process)
        time.sleep(0.5)  # it takes connections before it serves them
        yield port
    finally:
        process.terminate()
        process.wait()


@contextlib.contextmanager
def no_server(_folder):
    yield None


PEERS = {"BullMQ": ("bullmq.mjs", redis), "plainjob": ("plainjob.mjs", no_server), "pg-boss": ("pg_boss.mjs", postgres)}


def install():
    if not (HERE / "node_modules").is_dir():
        # Not `npm ci`, which does not take the lock where it leaves out what is optional on other platforms.
        subprocess.run(["npm", "install", "--no-save", "--no-audit", "--no-fund"], cwd=HERE, check=True, stdout=subprocess.DEVNULL)


def lines_of(name, folder, jobs, clients, payload):
    """The measures of one turn, as lines of JSON."""
    program, server = PEERS[name]
    with server(folder) as port:
        environment = {**os.environ, **({"PORT": str(port)} if port else {})}
        return subprocess.run(["node", HERE / program, folder, str(jobs), str(clients), str(payload)], env=environment, check=True,
                              stdout=subprocess.PIPE, text=True).stdout.splitlines()
