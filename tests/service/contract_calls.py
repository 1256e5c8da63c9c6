"""How each operation of the API is called, so that it gives every answer that it has for a sound request."""

from rouleau_server import endless, plasma, unstable

nowhere = "01900000-0000-7000-8000-000000000000"
calls = {}


def call(function):
    calls[function.__name__] = function
    return function


class World:
    """A server that has one of each: jobs in their states, a sweep."""

    def __init__(self, server):
        self.server = server
        cell = {"x": 8e-6, "y": 5e-6, "diameter": 4e-6}
        self.given = plasma(cells=[cell], vessel={"length": 4e-5, "diameter": 1e-5}, effects={"membrane_maps": "on"},
                            output={"series_interval": 2e-5, "frame_interval": 5e-5,
                                    "fields": ["velocity", "pressure", "wall_shear_stress"]},
                            probes=[{"name": "middle", "from": [5e-6, 0], "to": [5e-6, 10e-6], "points": 3}])
        self.succeeded = server.submit(self.given)
        self.failed = server.submit(unstable())
        for job_id in (self.succeeded, self.failed):
            server.wait(job_id)
        self.sweep_body = {"case": plasma(), "axes": [{"pointer": "/inflow/velocity", "values": [0.001, 0.002]}]}
        self.sweep = server.request("POST", "/v1/sweeps", self.sweep_body).json()["id"]
        self.server.get(f"/v1/sweeps/{self.sweep}?wait=60s")
        self.others = 0

    def get(self, path, **headers):
        return self.server.get(path, **headers)

    def post(self, path, body=None, headers=None):
        return self.server.request("POST", path, body, headers)

    def a_running_job(self):
        """Another one each time: whoever asks may end it."""
        self.others += 1
        job_id = self.server.submit(endless(inflow={"velocity": 1e-3 + 1e-6 * self.others}), priority=10)
        self.server.wait_until_running(job_id)
        return job_id

    def a_cancelled_job(self):
        job_id = self.a_running_job()
        self.end(job_id)
        return job_id

    def end(self, job_id):
        self.post(f"/v1/jobs/{job_id}:cancel")
        self.server.wait(job_id)


def unless_changed(world, path):
    first = world.get(path)
    return [first, world.get(path, If_None_Match=first.headers["ETag"])]


@call
def submitJob(world):
    return [world.post("/v1/jobs", {"case": world.given}), world.post("/v1/jobs", {"case": plasma(duration=-1)}),
            world.post("/v1/jobs", [])]


@call
def listJobs(world):
    return [world.get("/v1/jobs?page_size=2"), world.get("/v1/jobs?state=none"), world.get(f"/v1/jobs?sweep={world.sweep}")]


@call
def getJob(world):
    running = world.a_running_job()
    answers = unless_changed(world, f"/v1/jobs/{world.succeeded}")
    answers += [world.get(f"/v1/jobs/{job}") for job in (running, world.failed, nowhere)]
    world.end(running)
    return answers + [world.get(f"/v1/jobs/{running}?wait=1")]


@call
def deleteJob(world):
    job_id = world.a_cancelled_job()
    path = f"/v1/jobs/{job_id}"
    running = world.a_running_job()
    answers = [world.server.request("DELETE", one) for one in (path, f"/v1/jobs/{running}", f"/v1/jobs/{nowhere}")]
    world.end(running)
    return answers


@call
def cancelJob(world):
    running = world.a_running_job()
    answers = [world.post(f"/v1/jobs/{running}:cancel")]
    world.server.wait(running)
    return answers + [world.post(f"/v1/jobs/{job}:cancel") for job in (running, world.succeeded, nowhere)]


@call
def pauseJob(world):
    running = world.a_running_job()
    answers = [world.post(f"/v1/jobs/{running}:pause")]
    world.server.wait(running, lambda job: job["state"] == "paused")
    answers += [world.post(f"/v1/jobs/{job}:pause") for job in (running, world.succeeded, nowhere)]
    world.end(running)
    return answers


@call
def resumeJob(world):
    running = world.a_running_job()
    world.post(f"/v1/jobs/{running}:pause")
    world.server.wait(running, lambda job: job["state"] == "paused")
    answers = [world.post(f"/v1/jobs/{job}:resume") for job in (running, world.succeeded, nowhere)]
    world.end(running)
    return answers


@call
def retryJob(world):
    cancelled = world.a_cancelled_job()
    answers = [world.post(f"/v1/jobs/{job}:retry") for job in (cancelled, world.succeeded, nowhere)]
    world.end(cancelled)
    return answers


@call
def getEvents(world):
    whole = world.get(f"/v1/jobs/{world.succeeded}/events")
    last = [line.split(":", 1)[1].strip() for line in whole.body.decode().splitlines() if line.startswith("id:")][-1]
    return [whole, world.get(f"/v1/jobs/{world.succeeded}/events", Last_Event_ID=last), world.get(f"/v1/jobs/{nowhere}/events")]


@call
def getLog(world):
    path = f"/v1/jobs/{world.succeeded}/log"
    return [world.get(path), world.get(path + "?from_byte=5"), world.get(path + "?from_byte=x"), world.get(f"/v1/jobs/{nowhere}/log")]


@call
def getSeries(world):
    path = f"/v1/jobs/{world.succeeded}/series"
    return [world.get(path), world.get(path, Accept="text/csv"), world.get(path + "?columns=none"),
            world.get(f"/v1/jobs/{nowhere}/series")]


@call
def listFrames(world):
    path = f"/v1/jobs/{world.succeeded}/frames"
    return [world.get(path), world.get(path + "?fields=outlines&from=1"), world.get(f"/v1/jobs/{nowhere}/frames")]


@call
def getFrame(world):
    path = f"/v1/jobs/{world.succeeded}/frames"
    return [world.get(path + "/1"), world.get(path + "/1?fields=outlines"), world.get(path + "/1000")]


@call
def listProbes(world):
    running = world.a_running_job()
    answers = [world.get(f"/v1/jobs/{job}/probes") for job in (world.succeeded, running, nowhere)]
    world.end(running)
    return answers


@call
def getProbe(world):
    running = world.a_running_job()
    answers = [world.get(f"/v1/jobs/{job}/probes/middle") for job in (world.succeeded, running, nowhere)]
    world.end(running)
    return answers


@call
def getArchive(world):
    path = f"/v1/jobs/{world.succeeded}/archive.h5"
    running = world.a_running_job()
    answers = unless_changed(world, path) + [world.get(path, Range="bytes=1-5"), world.get(path, Range="bytes=999999999-")]
    answers += [world.get(f"/v1/jobs/{job}/archive.h5") for job in (running, nowhere)]
    world.end(running)
    return answers


@call
def getSidecar(world):
    running = world.a_running_job()
    answers = [world.get(f"/v1/jobs/{job}/archive.xdmf") for job in (world.succeeded, running, nowhere)]
    world.end(running)
    return answers


@call
def submitSweep(world):
    bad = {**world.sweep_body, "axes": [{"pointer": "/none", "values": [1]}]}
    return [world.post("/v1/sweeps", world.sweep_body), world.post("/v1/sweeps", bad), world.post("/v1/sweeps", [])]


@call
def listSweeps(world):
    return [world.get("/v1/sweeps"), world.get("/v1/sweeps?page_size=0")]


@call
def getSweep(world):
    path = f"/v1/sweeps/{world.sweep}"
    return unless_changed(world, path) + [world.get(path + "?jobs=false"), world.get(path + "?jobs=some"),
                                          world.get(f"/v1/sweeps/{nowhere}")]


@call
def cancelSweep(world):
    body = {"case": endless(), "axes": [{"pointer": "/inflow/velocity", "values": [0.0021, 0.0022]}], "priority": 20}
    sweep = world.post("/v1/sweeps", body).json()["id"]
    world.server.wait_until_running(world.get(f"/v1/sweeps/{sweep}").json()["jobs"][0]["id"])
    answers = [world.post(f"/v1/sweeps/{sweep}:cancel")]
    world.get(f"/v1/sweeps/{sweep}?wait=30s")
    return answers + [world.post(f"/v1/sweeps/{one}:cancel") for one in (sweep, nowhere)]


@call
def getSweepTable(world):
    path = f"/v1/sweeps/{world.sweep}/table"
    return [world.get(path), world.get(path, Accept="text/csv"), world.get(f"/v1/sweeps/{nowhere}/table")]


@call
def getQueue(world):
    return [world.get("/v1/queue")]


@call
def pauseQueue(world):
    answers = [world.post("/v1/queue:pause")]
    world.post("/v1/queue:resume")
    return answers


@call
def resumeQueue(world):
    return [world.post("/v1/queue:resume")]


@call
def validateCase(world):
    return [world.post("/v1/cases:validate", world.given), world.post("/v1/cases:validate", {})]


@call
def planCase(world):
    return [world.post("/v1/cases:plan", world.given), world.post("/v1/cases:plan", {})]


@call
def getCaseSchema(world):
    return [world.get("/v1/schema/case.json")]


@call
def getDescription(world):
    return [world.get("/openapi.json")]


@call
def getProblem(world):
    return [world.get("/problems/not-found"), world.get("/problems/none")]
