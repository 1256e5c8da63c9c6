"""The API's own description, and whether an answer is as it says."""

import json

import jsonschema

methods = ("get", "post", "put", "patch", "delete")


class Description:
    def __init__(self, document):
        self.document = document

    def operations(self):
        """{operationId: (path, method, operation)}"""
        return {operation["operationId"]: (path, method, operation)
                for path, item in self.document["paths"].items() for method, operation in item.items() if method in methods}

    def examples(self):
        """(operationId, path, method, media type, schema, example) of every body that is shown."""
        for name, (path, method, operation) in self.operations().items():
            for media, content in operation.get("requestBody", {}).get("content", {}).items():
                shown = [content["example"]] if "example" in content else []
                shown += [one["value"] for one in content.get("examples", {}).values()]
                for example in shown:
                    yield name, path, method, media, content["schema"], example

    def check(self, name, answer):
        """Whether an answer is one that the operation may give: its status, its type, its body to the last member."""
        _, _, operation = self.operations()[name]
        responses = operation["responses"]
        assert str(answer.status) in responses, f"{name} answered {answer.status}: {answer.body[:300]}"
        content = responses[str(answer.status)].get("content")
        if content is None:
            assert not answer.body, f"{name} {answer.status} has a body that is not described"
            return
        media = answer.headers["Content-Type"].split(";")[0]
        assert media in content, f"{name} {answer.status} answered with {media}"
        schema = content[media].get("schema")
        if schema and media.endswith("json"):
            self.validate(answer.json(), schema, name)
        for header in answer.headers:
            if header in ("Location", "Retry-After", "Allow", "ETag", "Content-Range") and answer.status < 400:
                described = {one.lower() for one in responses[str(answer.status)].get("headers", {})}
                assert header.lower() in described or answer.status == 304, f"{name} {answer.status} has {header}"

    def validate(self, value, schema, what):
        whole = {"$ref": "#/__schema", **{key: value for key, value in self.document.items()}, "__schema": schema}
        jsonschema.Draft202012Validator(whole).validate(value)
        unknown = list(self.undescribed(value, schema, ""))
        assert not unknown, f"{what} has what is not described: {unknown[:10]}"

    def undescribed(self, value, schema, pointer):
        """Members that an object has and its schema does not name, where it names any."""
        while "$ref" in schema:
            schema = self.resolve(schema["$ref"])
        for choice in schema.get("anyOf", []) + schema.get("oneOf", []):
            if not list(self.undescribed(value, choice, pointer)) and jsonschema.Draft202012Validator(
                    {**choice, "components": self.document["components"]}).is_valid(value):
                return
        if isinstance(value, dict) and "properties" in schema:
            for key, member in value.items():
                if key in schema["properties"]:
                    yield from self.undescribed(member, schema["properties"][key], f"{pointer}/{key}")
                elif "additionalProperties" not in schema:
                    yield f"{pointer}/{key}"
        if isinstance(value, list) and isinstance(schema.get("items"), dict):
            for index, item in enumerate(value[:3]):
                yield from self.undescribed(item, schema["items"], f"{pointer}/{index}")

    def resolve(self, reference):
        found = self.document
        for key in reference.removeprefix("#/").split("/"):
            found = found[key.replace("~1", "/").replace("~0", "~")]
        return found


def load(server):
    return Description(json.loads(server.get("/openapi.json").body))
