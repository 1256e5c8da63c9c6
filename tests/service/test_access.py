"""Who may call: addresses, tokens, and the page."""

import subprocess

import pytest
from rouleau_server import Server

token = "a-token-of-this-test"


@pytest.fixture(scope="module")
def guarded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("guarded")
    tokens = folder / "tokens"
    tokens.write_text(f"# for the test\n{token}\n")
    web = folder / "web"
    (web / "assets").mkdir(parents=True)
    (web / "index.html").write_text("<!doctype html><title>page</title>")
    (web / "assets" / "main.js").write_text("export {}")
    (folder / "secret.txt").write_text("secret")
    arguments = ["--host", "0.0.0.0", "--token-file", str(tokens), "--web", str(web)]
    with Server(folder / "data", arguments=arguments) as running:
        yield running


def test_an_open_address_needs_tokens(tmp_path, server):
    command = [server.binary, "serve", "--host", "0.0.0.0", "--port", "0", "--data", str(tmp_path / "data")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30)
    assert done.returncode == 2 and "--token-file" in done.stderr


def test_the_api_wants_the_token(guarded):
    assert guarded.get("/v1/jobs").status == 401
    assert guarded.get("/v1/jobs").headers["WWW-Authenticate"] == "Bearer"
    assert guarded.get("/%76%31/jobs").status == 401, "the same path, written otherwise"
    assert guarded.get("/v1/jobs", Authorization="Bearer " + token[:-1]).status == 401
    assert guarded.get("/v1/nothing").status == 401
    assert guarded.get("/v1/jobs", Authorization=f"Bearer {token}").status == 200


def test_the_client_sends_the_token(guarded):
    command = [guarded.binary, "status", "--server", guarded.url]
    assert subprocess.run(command, capture_output=True, timeout=30).returncode == 1
    assert subprocess.run([*command, "--token", token], capture_output=True, timeout=30).returncode == 0


def test_the_page_and_its_files(guarded):
    page = guarded.get("/")
    assert page.status == 200 and page.headers["Content-Type"].startswith("text/html")
    assert "default-src 'none'" in page.headers["Content-Security-Policy"]
    assert guarded.get("/", If_None_Match=page.headers["ETag"]).status == 304
    assert guarded.get("/assets/main.js").headers["Content-Type"].startswith("text/javascript")
    for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt", "/assets", "/assets/"):
        assert guarded.get(path).status == 404
