"""What a hostile or broken client may send."""

import concurrent.futures
import json
import socket
import time

import pytest
from rouleau_server import plasma


def status_of(reply):
    assert reply.startswith(b"HTTP/1.1 "), reply[:200]
    return int(reply.split()[1])


def post(headers, body="", path="/v1/jobs"):
    return f"POST {path} HTTP/1.1\r\nHost: localhost\r\n{headers}\r\n{body}"


as_json = "Content-Type: application/json\r\n"


@pytest.mark.parametrize("status, request_text", [
    (411, post(as_json + "Transfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n")),
    (411, post(as_json + "Transfer-Encoding: chunked\r\nContent-Length: 2\r\n", "{}")),
    (415, post(as_json + "Content-Encoding: gzip\r\nContent-Length: 20\r\n", "x" * 20)),
    (415, post("Content-Type: multipart/form-data; boundary=x\r\nContent-Length: 5\r\n", "--x--")),
    (415, post("Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 3\r\n", "a=b")),
    (415, post("Content-Length: 2\r\n", "{}")),
    (413, post(as_json + "Content-Length: 1048577\r\n")),
    (413, post(as_json + "Content-Length: 99999999999999999999999999\r\n")),
    (400, post(as_json + "Content-Length: 2\r\nContent-Length: 2\r\n", "{}")),
    (400, post(as_json + "Content-Length: -2\r\n", "{}")),
    (400, post(as_json + "Content-Length: two\r\n", "{}")),
    (431, "GET / HTTP/1.1\r\nHost: localhost\r\n" + "A: 1\r\n" * 100 + "\r\n"),
    (431, "GET / HTTP/1.1\r\nHost: localhost\r\nA: " + "x" * 20000 + "\r\n\r\n"),
    (431, "GET / HTTP/1.1\r\nA: " + "x" * 2000000),
    (414, "GET /" + "x" * 5000 + " HTTP/1.1\r\nHost: localhost\r\n\r\n"),
    (400, "GET / HTTP/1.1\r\n\r\n"),
    (400, "GET /\r\n\r\n"),
    (400, "\x16\x03\x01\x02\r\n\r\n"),
    (400, "GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nhello"),
    (421, "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"),
    (403, post(as_json + "Origin: http://evil.example\r\nContent-Length: 2\r\n", "{}")),
    (403, post("Origin: null\r\n", path="/v1/jobs/x:cancel")),
])
def test_a_bad_request_is_refused_and_the_connection_closed(server, status, request_text):
    begun = time.monotonic()
    reply = server.raw(request_text)
    assert status_of(reply) == status
    assert b"application/problem+json" in reply
    assert reply.count(b"HTTP/1.1 ") == 1, "the body was taken for a request"
    assert time.monotonic() - begun < 5


def test_a_body_that_is_not_read_is_not_taken_for_a_request(server):
    smuggled = "GET /livez HTTP/1.1\r\nHost: localhost\r\n\r\n"
    reply = server.raw(post(as_json + f"Content-Length: {len(smuggled)}\r\n", smuggled, "/v1/nothing"))
    assert status_of(reply) == 404 and reply.count(b"HTTP/1.1 ") == 1


def test_requests_may_follow_one_another(server):
    one = "GET /v1/jobs HTTP/1.1\r\nHost: localhost\r\n\r\n"
    reply = server.raw(one * 3)
    assert reply.count(b"HTTP/1.1 200 OK") == 3


def test_a_post_without_a_body_needs_no_length(server):
    reply = server.raw(post("", path="/v1/jobs/none:cancel"))
    assert status_of(reply) == 404


def test_input_is_not_echoed_into_headers(server):
    reply = server.raw("GET /v1/jobs/a%0d%0aX-Evil:%201 HTTP/1.1\r\nHost: localhost\r\n"
                       "X-Request-Id: mine%0d%0aX-Evil: 1\r\nRouleau-Request-Id: mine\r\nREMOTE_ADDR: 1.2.3.4\r\n\r\n")
    head = reply.split(b"\r\n\r\n")[0].lower()
    assert status_of(reply) == 404
    assert b"x-evil" not in head and b"mine" not in head
    assert "1.2.3.4" not in server.log()


@pytest.mark.parametrize("method, path, allow", [
    ("PUT", "/v1/jobs", "GET, HEAD, POST"),
    ("PUT", "/v1/jobs/x", "DELETE, GET, HEAD"),
    ("GET", "/v1/jobs/x:cancel", "POST"),
    ("OPTIONS", "/v1/jobs", "GET, HEAD, POST"),
    ("TRACE", "/openapi.json", "GET, HEAD"),
])
def test_a_method_that_a_path_does_not_take(server, method, path, allow):
    answer = server.request(method, path)
    assert answer.status == 405 and answer.headers["Allow"] == allow


@pytest.mark.parametrize("path", ["/nothing", "/v1/", "/v1/jobs/", "/v1/jobs/x/y", "/..%2f..%2fetc/passwd",
                                  "/../../etc/passwd", "/assets/../../CMakeCache.txt", "//", "/%00", "/v1/jobs/%ff"])
def test_paths_that_are_not_there(server, path):
    answer = server.get(path)
    assert answer.status == 404
    assert answer.json()["type"] == "/problems/not-found"
    assert answer.headers["X-Content-Type-Options"] == "nosniff"


def test_deep_and_long_bodies_do_no_harm(server):
    for body in (b'{"case":' * 50000, b"[" * 500000, b'{"a":"' + b"\xff" * 900000 + b'"}'):
        answer = server.request("POST", "/v1/jobs", body, {"Content-Type": "application/json"})
        assert answer.status == 400


def test_keep_alive_is_quick(server):
    with socket.create_connection(("127.0.0.1", server.port)) as connection:
        begun = time.monotonic()
        for _ in range(50):
            connection.sendall(b"GET /v1/jobs/none HTTP/1.1\r\nHost: localhost\r\n\r\n")
            received = b""
            while b"not-found" not in received:
                received += connection.recv(65536)
        assert time.monotonic() - begun < 1.9, "40 ms a request: TCP_NODELAY is missing"


def test_slow_clients_do_not_hold_up_others(server):
    slow = []
    for _ in range(40):
        connection = socket.create_connection(("127.0.0.1", server.port))
        connection.sendall(b"POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\n")
        slow.append(connection)
    begun = time.monotonic()
    assert server.get("/v1/jobs").status == 200
    assert time.monotonic() - begun < 2
    slow[0].settimeout(15)
    assert b" 408 " in slow[0].recv(65536), "a head that never ends is given up"
    for connection in slow:
        connection.close()


def test_many_at_once(server):
    with concurrent.futures.ThreadPoolExecutor(32) as pool:
        answers = list(pool.map(lambda _: server.request("POST", "/v1/cases:validate", plasma()).status, range(200)))
    assert answers == [200] * 200


def test_noise(server):
    """Whatever is sent, the server answers or closes, and goes on."""
    import random
    source = random.Random(7)
    valid = post(as_json + "Content-Length: 12\r\n", json.dumps({"case": {}})).encode()
    for _ in range(100):
        noise = bytearray(valid)
        for _ in range(source.randrange(1, 8)):
            noise[source.randrange(len(noise))] = source.randrange(256)
        with socket.create_connection(("127.0.0.1", server.port)) as connection:
            connection.sendall(noise)
    assert server.get("/v1/jobs").status == 200
