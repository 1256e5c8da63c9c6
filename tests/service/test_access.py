"""Who may call: addresses, tokens and their scopes, how often, and the page."""

import json
import signal
import socket
import subprocess
import time

import pytest
from rouleau_server import Server, endless, plasma


def new_token(binary, name, scopes):
    """The token and its line for the token file."""
    done = subprocess.run([binary, "token", name, "--scopes", scopes, "--json"], capture_output=True, text=True, timeout=30)
    assert done.returncode == 0, done.stderr
    made = json.loads(done.stdout)
    return made["token"], made["line"]


class Guarded:
    def __init__(self, folder, binary):
        self.file = folder / "tokens"
        self.tokens, lines = {}, []
        for scopes in ("read", "read,submit", "admin"):
            name = scopes.split(",")[-1] + "er"
            self.tokens[name], line = new_token(binary, name, scopes)
            lines.append(line)
        self.file.write_text("# for the test\n" + "\n".join(lines) + "\n")

    def bearer(self, name):
        return {"Authorization": "Bearer " + self.tokens[name]}


@pytest.fixture(scope="module")
def tokens(tmp_path_factory, server):
    return Guarded(tmp_path_factory.mktemp("tokens"), server.binary)


@pytest.fixture(scope="module")
def guarded(tmp_path_factory, tokens):
    folder = tmp_path_factory.mktemp("guarded")
    web = folder / "web"
    (web / "assets").mkdir(parents=True)
    (web / "index.html").write_text("<!doctype html><title>page</title>")
    (web / "assets" / "main.js").write_text("export {}")
    (folder / "secret.txt").write_text("secret")
    arguments = ["--host", "0.0.0.0", "--token-file", str(tokens.file), "--web", str(web)]
    with Server(folder / "data", arguments=arguments) as running:
        yield running


def test_an_open_address_needs_tokens(tmp_path, server):
    command = [server.binary, "serve", "--host", "0.0.0.0", "--port", "0", "--data", str(tmp_path / "data")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30)
    assert done.returncode == 2 and "--token-file" in done.stderr


def test_a_file_of_plain_tokens_is_refused_with_what_to_do(tmp_path, server):
    file = tmp_path / "tokens"
    file.write_text("0123456789abcdef\n")
    command = [server.binary, "serve", "--port", "0", "--data", str(tmp_path / "data"), "--token-file", str(file)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30)
    assert done.returncode == 1
    assert "line 1" in done.stderr and "rouleau token" in done.stderr and "0123456789abcdef" not in done.stderr


def test_the_token_command(server):
    done = subprocess.run([server.binary, "token", "bench"], capture_output=True, text=True, timeout=30)
    assert done.returncode == 0 and "rouleau_" in done.stdout and "\n  bench submit " in done.stdout
    for wrong in (["a/b"], ["x", "--scopes", "write"], []):
        assert subprocess.run([server.binary, "token", *wrong], capture_output=True, timeout=30).returncode == 2


def test_the_api_wants_a_token(guarded, tokens):
    assert guarded.get("/v1/jobs").status == 401
    assert guarded.get("/v1/jobs").headers["WWW-Authenticate"] == "Bearer"
    assert guarded.get("/%76%31/jobs").status == 401, "the same path, written otherwise"
    assert guarded.get("/v1/jobs", Authorization="Bearer " + tokens.tokens["reader"][:-1]).status == 401
    assert guarded.get("/v1/nothing").status == 401
    for target in ("v1/queue", "x/v1/queue", "http://localhost/v1/queue", "*", "?/v1/queue"):
        answer = guarded.raw(f"POST {target}:pause HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n")
        assert b" 400 " in answer.splitlines()[0], target
    assert guarded.get("/v1/jobs", **tokens.bearer("reader")).status == 200


@pytest.mark.parametrize("method, path, needed", [
    ("GET", "/v1/jobs", "read"),
    ("GET", "/v1/jobs/none", "read"),
    ("POST", "/v1/cases:validate", "read"),
    ("POST", "/v1/cases:plan", "read"),
    ("POST", "/v1/jobs", "submit"),
    ("POST", "/v1/jobs/none:cancel", "submit"),
])
def test_each_token_may_do_what_its_scopes_say(guarded, tokens, method, path, needed):
    scopes = ["read", "submit", "admin"]
    for name in ("reader", "submiter", "adminer"):
        may = scopes.index(name.removesuffix("er")) >= scopes.index(needed)
        body = {} if method == "POST" else None
        answer = guarded.request(method, path, body, tokens.bearer(name))
        assert (answer.status == 403) == (not may), (name, answer.body)
        if not may:
            assert answer.json()["type"] == "/problems/forbidden" and needed in answer.json()["detail"]


def test_tokens_are_read_again(tmp_path, server):
    first, first_line = new_token(server.binary, "first", "read,submit")
    second, second_line = new_token(server.binary, "second", "read")
    file = tmp_path / "tokens"
    file.write_text(first_line + "\n")

    def wait_for(server, text, count=1):
        deadline = time.monotonic() + 20
        while server.log().count(text) < count:
            assert time.monotonic() < deadline, server.log()
            time.sleep(0.02)

    with Server(tmp_path / "data", arguments=["--token-file", str(file)]) as guarded:
        assert guarded.get("/v1/jobs", Authorization=f"Bearer {second}").status == 401
        job_id = guarded.request("POST", "/v1/jobs", {"case": endless()}, {"Authorization": f"Bearer {first}"}).json()["id"]
        stream = socket.create_connection(("127.0.0.1", guarded.port), timeout=20)
        stream.sendall(f"GET /v1/jobs/{job_id}/events HTTP/1.1\r\nHost: localhost\r\n"
                       f"Connection: close\r\nAuthorization: Bearer {first}\r\n\r\n".encode())
        file.write_text("nonsense\n")
        guarded.process.send_signal(signal.SIGHUP)
        wait_for(guarded, "the tokens in use stay")
        assert guarded.get("/v1/jobs", Authorization=f"Bearer {first}").status == 200
        file.write_text(second_line + "\n")
        guarded.process.send_signal(signal.SIGHUP)
        wait_for(guarded, "tokens read again")
        assert guarded.get("/v1/jobs", Authorization=f"Bearer {first}").status == 401
        assert guarded.get("/v1/jobs", Authorization=f"Bearer {second}").status == 200
        with stream:
            while stream.recv(65536):
                pass  # until it is closed: whoever may still read connects again


def test_the_log_names_the_caller_and_never_a_token(guarded, tokens):
    answer = guarded.get("/v1/jobs/nothing", **tokens.bearer("reader"))
    guarded.get("/v1/jobs", Authorization="Bearer a-guess-at-a-token")
    line = next(line for line in guarded.log().splitlines() if answer.headers["X-Request-Id"] in line)
    assert "caller=reader" in line and "status=404" in line
    for token in [*tokens.tokens.values(), "a-guess-at-a-token"]:
        assert token not in guarded.log()


def test_the_client_sends_the_token(guarded, tokens):
    command = [guarded.binary, "status", "--server", guarded.url]
    assert subprocess.run(command, capture_output=True, timeout=30).returncode == 1
    token = tokens.tokens["reader"]
    assert subprocess.run([*command, "--token", token], capture_output=True, timeout=30).returncode == 0


def test_requests_are_limited_by_token(tmp_path, server):
    a, a_line = new_token(server.binary, "a", "submit")
    b, b_line = new_token(server.binary, "b", "submit")
    file = tmp_path / "tokens"
    file.write_text(f"{a_line}\n{b_line}\n")
    arguments = ["--token-file", str(file), "--rate-limit", "0.01", "--rate-burst", "3"]
    with Server(tmp_path / "data", arguments=arguments) as limited:
        answers = [limited.get("/v1/jobs", Authorization=f"Bearer {a}") for _ in range(4)]
        assert [answer.status for answer in answers] == [200, 200, 200, 429]
        assert [answer.headers["RateLimit"].split(";")[1] for answer in answers] == ["r=2", "r=1", "r=0", "r=0"]
        assert all(answer.headers["RateLimit-Policy"] == '"default";q=3;w=300' for answer in answers)
        assert answers[3].json()["type"] == "/problems/too-many-requests"
        assert 90 <= int(answers[3].headers["Retry-After"]) <= 100
        body = {"case": plasma()}
        assert limited.request("POST", "/v1/jobs", body, {"Authorization": f"Bearer {a}"}).status == 429
        assert limited.get("/v1/jobs", Authorization=f"Bearer {b}").status == 200
        assert [limited.get("/v1/jobs").status for _ in range(4)] == [401, 401, 401, 429], "by address"
        assert limited.get("/openapi.json").status == 200, "only /v1 is counted"


def test_the_log_in_json(tmp_path):
    with Server(tmp_path / "data", arguments=["--log-format", "json"]) as server:
        server.get('/v1/jobs/a"b%0a')
        assert server.terminate() == 0
        lines = [json.loads(line) for line in server.log().splitlines() if not line.startswith("serving ")]
    assert all({"time", "level", "event"} <= line.keys() for line in lines)
    assert {"serving", "answered", "drained"} <= {line["event"] for line in lines}
    answered = next(line for line in lines if line["event"] == "answered")
    assert answered["target"] == '/v1/jobs/a"b%0a' and answered["status"] == "404"


def test_the_page_and_its_files(guarded):
    page = guarded.get("/")
    assert page.status == 200 and page.headers["Content-Type"].startswith("text/html")
    assert "default-src 'none'" in page.headers["Content-Security-Policy"]
    assert guarded.get("/", If_None_Match=page.headers["ETag"]).status == 304
    assert guarded.get("/assets/main.js").headers["Content-Type"].startswith("text/javascript")
    for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt", "/assets", "/assets/"):
        assert guarded.get(path).status == 404
