PRAGMA foreign_keys = OFF;
BEGIN TRANSACTION;
CREATE TABLE job_inputs (
  job_id        TEXT NOT NULL PRIMARY KEY REFERENCES jobs (id) ON DELETE CASCADE,
  case_given    TEXT NOT NULL CHECK (json_valid(case_given)),
  case_resolved TEXT NOT NULL CHECK (json_valid(case_resolved)),
  plan          TEXT NOT NULL CHECK (json_valid(plan))
) STRICT;
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000000','{"version":1,"name":"waits","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"waits","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000001','{"version":1,"name":"waits for its time","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"waits for its time","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000002','{"version":1,"name":"runs","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"runs","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000003','{"version":1,"name":"is being cancelled","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"is being cancelled","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000004','{"version":1,"name":"succeeded","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"succeeded","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000005','{"version":1,"name":"failed","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"failed","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000006','{"version":1,"name":"cancelled before it ran","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"cancelled before it ran","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
INSERT INTO "job_inputs" VALUES('01900000-0001-7000-8000-000000000007','{"version":1,"name":"cancelled while it ran","vessel":{"length":2e-05,"diameter":1e-05},"numerics":{"preset":"draft"},"duration":2e-05}','{"cells":[],"duration":2e-05,"effects":{},"inflow":{"profile":"plug","velocity":0.005,"waveform":[]},"initial":{"flow":"auto"},"name":"cancelled while it ran","numerics":{"kernel_radius":3.1,"preset":"draft","pressure_tolerance":0.01,"refine":"auto","spacing":5e-07,"threads":1,"time_step":"auto","viscosity":"implicit"},"outflow":{"pressure":0.0},"output":{"fields":["velocity","pressure"],"frame_interval":0.0001,"series_interval":2e-05},"plasma":{"density":1000.0,"kinematic_viscosity":1e-06},"probes":[],"thrombi":[],"version":1,"vessel":{"diameter":1e-05,"ends":"open","length":2e-05,"shape":"straight"}}','{"particles": 1250, "time_step": 1e-06, "effects": []}');
CREATE TABLE jobs (
  id             TEXT    NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  state          TEXT    NOT NULL
                 CHECK (state IN ('queued', 'running', 'cancelling', 'succeeded', 'failed', 'cancelled')),
  name           TEXT    NOT NULL,
  case_hash      TEXT    NOT NULL CHECK (length(case_hash) = 64),
  labels         TEXT    NOT NULL CHECK (json_valid(labels) AND json_type(labels) = 'object'),
  priority       INTEGER NOT NULL,
  attempt        INTEGER NOT NULL DEFAULT 0 CHECK (attempt >= 0),
  created_at     INTEGER NOT NULL,
  started_at     INTEGER,
  ended_at       INTEGER,
  not_before     INTEGER,
  lease_owner    TEXT,
  lease_until    INTEGER,
  progress       TEXT CHECK (progress IS NULL OR json_valid(progress)),
  summary        TEXT CHECK (summary IS NULL OR json_valid(summary)),
  error          TEXT CHECK (error IS NULL OR json_valid(error)),
  archive_size   INTEGER CHECK (archive_size IS NULL OR archive_size > 0),
  archive_sha256 TEXT CHECK (archive_sha256 IS NULL OR length(archive_sha256) = 64),

  CONSTRAINT ended_has_its_time CHECK ((ended_at IS NOT NULL) = (state IN ('succeeded', 'failed', 'cancelled'))),
  CONSTRAINT held_by_an_owner CHECK ((lease_owner IS NOT NULL) = (state IN ('running', 'cancelling'))),
  CONSTRAINT owner_until_a_time CHECK ((lease_until IS NOT NULL) = (lease_owner IS NOT NULL)),
  CONSTRAINT begun_by_a_claim
    CHECK (state IN ('queued', 'cancelled') OR (attempt > 0 AND started_at IS NOT NULL)),
  CONSTRAINT waiting_has_not_begun CHECK (state <> 'queued' OR (started_at IS NULL AND progress IS NULL)),
  CONSTRAINT only_the_queue_waits CHECK (not_before IS NULL OR state = 'queued'),
  CONSTRAINT success_has_a_result
    CHECK ((state = 'succeeded') = (summary IS NOT NULL)
       AND (state = 'succeeded') = (archive_size IS NOT NULL)
       AND (state = 'succeeded') = (archive_sha256 IS NOT NULL)),
  CONSTRAINT failure_has_an_error CHECK ((state = 'failed') = (error IS NOT NULL))
) STRICT;
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000000','queued','waits','d95f2e1779d132f70001aebf0306cb0f4fa7febd8c8be9ca4d83531ba0c7f3f0','{}',-1,0,1790000000000,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000001','queued','waits for its time','4f40e30d17647defe10264185801cdfe4bcc1b049ce41af2f25d75874bfde6db','{"lab": "A", "it''s": "50 % \"x\""}',0,0,1790000000001,NULL,NULL,1790000000500,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000002','running','runs','074c253beed213ef2d06668e44b029b31835a60f871b654c4a028b14df16736a','{}',1,3,1790000000002,1790000001002,NULL,NULL,'local-01',1790000009000,'{"fraction": 0.5, "simulated_time": 1e-05}',NULL,NULL,NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000003','cancelling','is being cancelled','607bf7440cb7e665b3d229861bad9a2bcb2fde6f09b51cc4cb1ec49dace4888f','{"lab": "A", "it''s": "50 % \"x\""}',-1,1,1790000000003,1790000001003,NULL,NULL,'local-01',1790000009000,'{"fraction": 0.5, "simulated_time": 1e-05}',NULL,NULL,NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000004','succeeded','succeeded','568441047ffed5423adff18845c42a3fc5b590fdf8e3e5c29a7db0e3e5f99161','{}',0,2,1790000000004,1790000001004,1790000002004,NULL,NULL,NULL,'{"fraction": 0.5, "simulated_time": 1e-05}','{"ending": "completed", "steps": 20, "wall_time": 0.1}',NULL,1238,'41bbc455783b378b040823245fe59ad7503007d4237d2b51896befedebd7e43b');
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000005','failed','failed','2411d28e645efee1008a18e42d4a239569a8a6ffe92a12431427b64e111d6511','{"lab": "A", "it''s": "50 % \"x\""}',1,3,1790000000005,1790000001005,1790000002005,NULL,NULL,NULL,'{"fraction": 0.5, "simulated_time": 1e-05}',NULL,'{"kind": "engine", "message": "not finite"}',NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000006','cancelled','cancelled before it ran','1a447edd7771829278c9d0f82b614888c317e61de99c2b2d43bad1acc20f72e1','{}',-1,0,1790000000006,NULL,1790000002006,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO "jobs" VALUES('01900000-0001-7000-8000-000000000007','cancelled','cancelled while it ran','30b3244d8d1fb7f52191f1aab95757f2ae364a54a7448b496491b9a4af85f682','{"lab": "A", "it''s": "50 % \"x\""}',0,2,1790000000007,1790000001007,1790000002007,NULL,NULL,NULL,'{"fraction": 0.5, "simulated_time": 1e-05}',NULL,NULL,NULL,NULL);
CREATE INDEX jobs_waiting ON jobs (priority DESC, id) WHERE state = 'queued';
CREATE INDEX jobs_held ON jobs (lease_until) WHERE lease_owner IS NOT NULL;
CREATE INDEX jobs_by_state ON jobs (state, id);
COMMIT;
PRAGMA user_version = 1;
