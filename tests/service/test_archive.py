"""The archive over HTTP: whole, in parts, and to readers."""

import hashlib
import io
import socket

import h5py
import pytest
from rouleau_server import plasma


@pytest.fixture(scope="module")
def job(server):
    job = server.wait(server.submit(plasma()))
    assert job["state"] == "succeeded"
    return job


@pytest.fixture(scope="module")
def path(job):
    return f"/v1/jobs/{job['id']}/archive.h5"


@pytest.fixture(scope="module")
def whole(server, path):
    return server.get(path).body


def test_h5py_opens_the_download(server, job, whole):
    with h5py.File(io.BytesIO(whole)) as archive:
        assert "series" in archive and "particles/trajectory" in archive
    times = [row[0] for row in server.get(f"/v1/jobs/{job['id']}/series?columns=time").json()["rows"]]
    assert len(times) > 1


def test_the_etag_is_the_digest_of_the_file(server, path, whole):
    head = server.request("HEAD", path)
    assert head.status == 200 and head.body == b""
    assert head.headers["ETag"] == f'"{hashlib.sha256(whole).hexdigest()}"'
    assert head.headers["Accept-Ranges"] == "bytes"
    assert int(head.headers["Content-Length"]) == len(whole)
    assert server.get(path, If_None_Match=head.headers["ETag"]).status == 304


@pytest.mark.parametrize("header, part", [
    ("bytes=0-0", slice(0, 1)),
    ("bytes=100-199", slice(100, 200)),
    ("bytes=-10", slice(-10, None)),
    ("bytes=5-", slice(5, None)),
    ("bytes=10-99999999999999999999999999", slice(10, None)),
    ("bytes=-99999999999999999999999999", slice(0, None)),
])
def test_ranges(server, path, whole, header, part):
    answer = server.get(path, Range=header)
    wanted = whole[part]
    first = range(len(whole))[part][0]
    assert answer.status == 206
    assert answer.body == wanted
    assert answer.headers["Content-Range"] == f"bytes {first}-{first + len(wanted) - 1}/{len(whole)}"


@pytest.mark.parametrize("header", ["bytes=99999999-", "bytes=-0", "bytes=99999999999999999999999-"])
def test_ranges_past_the_end(server, path, whole, header):
    answer = server.get(path, Range=header)
    assert answer.status == 416
    assert answer.headers["Content-Range"] == f"bytes */{len(whole)}"
    assert answer.json()["type"] == "/problems/range-not-satisfiable"


@pytest.mark.parametrize("header", ["bytes=0-1,5-6", "bytes=5-2", "bytes=a-b", "items=0-1", "bytes=0--1", "",
                                    "bytes=" + "0-1," * 1000 + "0-1"])
def test_ranges_that_are_not_applied(server, path, whole, header):
    answer = server.get(path, Range=header)
    assert answer.status == 200 and answer.body == whole


def test_a_range_counts_only_for_the_file_that_the_client_has(server, path, whole):
    etag = server.get(path).headers["ETag"]
    assert server.get(path, Range="bytes=0-9", If_Range=etag).status == 206
    assert server.get(path, Range="bytes=0-9", If_Range='"other"').body == whole
    assert server.get(path, Range="bytes=0-9", If_Range="Wed, 21 Oct 2026 07:28:00 GMT").body == whole


def test_ranges_of_other_answers_are_ignored(server, job):
    answer = server.get(f"/v1/jobs/{job['id']}", Range="bytes=0-9999999")
    assert answer.status == 200 and answer.json()["id"] == job["id"]


def test_a_reader_that_leaves_does_no_harm(server, path, whole):
    for _ in range(5):
        with socket.create_connection(("127.0.0.1", server.port)) as connection:
            connection.sendall(f"GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
            connection.recv(10)
    assert server.get(path).body == whole


def test_the_sidecar_names_the_archive(server, job, path):
    answer = server.get(path.replace(".h5", ".xdmf"))
    assert answer.status == 200 and f"{job['id']}.h5".encode() in answer.body
