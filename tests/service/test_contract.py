"""The description of the API, held against the running server: every operation, every example, every problem.

An operation or a problem that is added and that this suite does not know fails it: say in contract_calls.py how the one is
called, in contract_problems.py how the other comes about.
"""

import pathlib
import re

import jsonschema
import pytest
from contract_calls import World, calls, nowhere
from contract_description import load
from contract_problems import catalogue, provocations, server_that_removed

# What only a fault of the server itself brings about.
beyond_a_test = {"internal"}


# Read before a server runs, so that each operation is a test.
described = sorted(name for part in (pathlib.Path(__file__).parents[2] / "service/openapi").glob("*.json")
                   for name in re.findall(r'"operationId": "(\w+)"', part.read_text()))


@pytest.fixture(scope="module")
def world(server):
    return World(server)


@pytest.fixture(scope="module")
def description(server):
    return load(server)


def test_every_operation_is_known_here(description):
    assert sorted(description.operations()) == described
    assert set(described) == set(calls)


@pytest.mark.parametrize("name", described)
def test_an_operation_answers_as_it_is_described(world, description, name):
    answers = calls[name](world)
    for answer in answers:
        description.check(name, answer)
    given = {str(answer.status) for answer in answers}
    sound = {status for status in description.operations()[name][2]["responses"] if status < "400"}
    assert sound <= given, f"{name} is said to answer {sound - given}, too"


def test_what_was_removed_is_answered_so_as_described(description, tmp_path):
    with server_that_removed(tmp_path, nowhere) as server:
        for name, (path, method, _) in description.operations().items():
            if not re.match(r"/v1/(jobs|sweeps)/\{id\}", path):
                continue
            answer = server.request(method.upper(), re.sub(r"\{\w+\}", "0", path.replace("{id}", nowhere)))
            assert answer.status == 410, name
            description.check(name, answer)


def test_every_example_is_taken(server, description):
    shown = 0
    for name, path, method, media, schema, example in description.examples():
        description.validate(example, schema, name)
        answer = server.request(method.upper(), path, example, {"Content-Type": media})
        assert answer.status < 300, f"{name}: {answer.body}"
        description.check(name, answer)
        shown += 1
    bodies = [name for name, (_, _, operation) in description.operations().items() if "requestBody" in operation]
    assert shown >= len(bodies), "every body is shown by an example"


def test_the_cases_that_are_taken_are_those_of_the_schema(server, world):
    schema = server.get("/v1/schema/case.json").json()
    jsonschema.Draft7Validator.check_schema(schema)
    jsonschema.Draft7Validator(schema).validate(world.given)
    jsonschema.Draft7Validator(schema).validate(server.job(world.succeeded)["case"])


def test_every_problem_is_known_here():
    assert set(catalogue()) <= set(provocations) | beyond_a_test


@pytest.mark.parametrize("name", sorted(catalogue()))
def test_a_problem_is_as_its_page_says(server, world, description, tmp_path, name):
    page = server.get(f"/problems/{name}")
    assert page.status == 200 and page.headers["Content-Type"].startswith("text/html")
    assert name in page.body.decode() and str(catalogue()[name]) in page.body.decode()
    if name in beyond_a_test:
        return
    answer = provocations[name](world, tmp_path)
    assert answer.status == catalogue()[name], answer.body
    assert answer.headers["Content-Type"] == "application/problem+json"
    problem = answer.json()
    description.validate(problem, {"$ref": "#/components/schemas/Problem"}, name)
    assert problem["type"] == f"/problems/{name}" and problem["status"] == answer.status
    assert problem["title"] in page.body.decode()
    assert problem["request_id"] == answer.headers["X-Request-Id"]
    if answer.status in (429, 503):
        assert int(answer.headers["Retry-After"]) > 0
