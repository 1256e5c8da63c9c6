"""A client of server-sent events, as a browser's EventSource is one: it hands back the id of the last event."""

import http.client
import json


class Event:
    def __init__(self, identity, name, data):
        self.id, self.name, self.data = identity, name, data

    def __repr__(self):
        return f"{self.name}({self.id}): {str(self.data)[:200]}"


class EventStream:
    def __init__(self, server, job_id, last_id=None, timeout=60):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=timeout)
        headers = {"Accept": "text/event-stream"}
        if last_id is not None:
            headers["Last-Event-ID"] = last_id
        self.connection.request("GET", f"/v1/jobs/{job_id}/events", headers=headers)
        self.response = self.connection.getresponse()
        self.status = self.response.status
        self.last_id = last_id
        self.comments = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.response.close()
        self.connection.close()

    def __iter__(self):
        fields = {}
        while True:
            line = self.response.readline()
            if not line:
                return
            text = line.decode().rstrip("\n")
            if text.startswith(":"):
                self.comments += 1
            elif text:
                name, _, value = text.partition(": ")
                fields[name] = value
            else:
                if "data" in fields:
                    self.last_id = fields.get("id", self.last_id)
                    yield Event(self.last_id, fields.get("event"), json.loads(fields["data"]))
                fields = {}


class Followed:
    """A series put together from events: rows from `from` on are replaced, as a client is told to."""

    def __init__(self):
        self.columns = None
        self.rows = []
        self.states = []
        self.progress = []

    def take(self, event):
        if event.name == "state":
            self.states.append(event.data["state"])
        elif event.name == "progress":
            self.progress.append(event.data["fraction"])
        elif event.name == "series":
            self.columns = event.data.get("columns", self.columns)
            assert event.data["from"] == len(self.rows), "a gap, or rows that came twice"
            self.rows += event.data["rows"]
