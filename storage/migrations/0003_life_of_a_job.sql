-- Jobs can be paused and retried, share one result, wait in lanes and belong to a sweep. SQLite cannot change a
-- CHECK, so the table is made anew; the rows that it had satisfy the new one as they are.
CREATE TABLE sweeps (
  id         TEXT    NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  name       TEXT    NOT NULL,
  labels     TEXT    NOT NULL CHECK (json_valid(labels) AND json_type(labels) = 'object'),
  lane       TEXT    NOT NULL,
  priority   INTEGER NOT NULL,
  given      TEXT    NOT NULL CHECK (json_valid(given)),
  created_at INTEGER NOT NULL
) STRICT;

CREATE TABLE jobs_new (
  id              TEXT    NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  state           TEXT    NOT NULL
                  CHECK (state IN ('queued', 'running', 'paused', 'cancelling', 'succeeded', 'failed', 'cancelled')),
  name            TEXT    NOT NULL,
  case_hash       TEXT    NOT NULL CHECK (length(case_hash) = 64),
  labels          TEXT    NOT NULL CHECK (json_valid(labels) AND json_type(labels) = 'object'),
  -- Whose turn it is goes round the lanes of one priority.
  lane            TEXT    NOT NULL DEFAULT '',
  priority        INTEGER NOT NULL,
  sweep           TEXT REFERENCES sweeps (id),
  sweep_index     INTEGER,
  -- To be computed even if the result is there.
  fresh           INTEGER NOT NULL DEFAULT 0 CHECK (fresh IN (0, 1)),
  -- The job with the same hash whose result this one waits for.
  follows         TEXT,
  -- The job that computed the result that this one was given.
  result_of       TEXT,
  attempt         INTEGER NOT NULL DEFAULT 0 CHECK (attempt >= 0),
  -- Attempts that died since the last one that left a checkpoint.
  setbacks        INTEGER NOT NULL DEFAULT 0 CHECK (setbacks >= 0),
  pause_requested INTEGER NOT NULL DEFAULT 0 CHECK (pause_requested IN (0, 1)),
  created_at      INTEGER NOT NULL,
  started_at      INTEGER,
  ended_at        INTEGER,
  not_before      INTEGER,
  lease_owner     TEXT,
  lease_until     INTEGER,
  progress        TEXT CHECK (progress IS NULL OR json_valid(progress)),
  summary         TEXT CHECK (summary IS NULL OR json_valid(summary)),
  error           TEXT CHECK (error IS NULL OR json_valid(error)),
  -- The job that wrote the archive; several may share it.
  archive_id      TEXT CHECK (archive_id IS NULL OR length(archive_id) = 36),
  archive_size    INTEGER CHECK (archive_size IS NULL OR archive_size > 0),
  archive_sha256  TEXT CHECK (archive_sha256 IS NULL OR length(archive_sha256) = 64),

  CONSTRAINT ended_has_its_time CHECK ((ended_at IS NOT NULL) = (state IN ('succeeded', 'failed', 'cancelled'))),
  CONSTRAINT held_by_an_owner CHECK ((lease_owner IS NOT NULL) = (state IN ('running', 'cancelling'))),
  CONSTRAINT owner_until_a_time CHECK ((lease_until IS NOT NULL) = (lease_owner IS NOT NULL)),
  CONSTRAINT begun_by_a_claim
    CHECK (state IN ('queued', 'paused', 'cancelled') OR result_of IS NOT NULL OR (attempt > 0 AND started_at IS NOT NULL)),
  CONSTRAINT waiting_does_not_run CHECK (state NOT IN ('queued', 'paused') OR started_at IS NULL),
  CONSTRAINT only_the_queue_waits CHECK (state = 'queued' OR (not_before IS NULL AND follows IS NULL)),
  CONSTRAINT only_a_run_is_to_pause CHECK (pause_requested = 0 OR state = 'running'),
  CONSTRAINT success_has_a_result CHECK (state <> 'succeeded' OR summary IS NOT NULL),
  CONSTRAINT result_of_what_ran_to_an_end CHECK (summary IS NULL OR state IN ('succeeded', 'failed')),
  CONSTRAINT result_is_whole
    CHECK ((summary IS NOT NULL) = (archive_size IS NOT NULL)
       AND (summary IS NOT NULL) = (archive_sha256 IS NOT NULL)
       AND (summary IS NOT NULL) = (archive_id IS NOT NULL)),
  CONSTRAINT failure_has_an_error CHECK ((state = 'failed') = (error IS NOT NULL)),
  CONSTRAINT place_in_a_sweep CHECK ((sweep IS NULL) = (sweep_index IS NULL))
) STRICT;

INSERT INTO jobs_new (id, state, name, case_hash, labels, priority, attempt, created_at, started_at, ended_at, not_before,
                      lease_owner, lease_until, progress, summary, error, archive_id, archive_size, archive_sha256)
SELECT id, state, name, case_hash, labels, priority, attempt, created_at, started_at, ended_at, not_before,
       lease_owner, lease_until, progress, summary, error, iif(summary IS NULL, NULL, id), archive_size, archive_sha256
FROM jobs;

DROP TABLE jobs;
ALTER TABLE jobs_new RENAME TO jobs;

-- In the order in which jobs are claimed; what waits for its time or for another's result is not among them.
CREATE INDEX jobs_waiting ON jobs (priority DESC, lane, id)
  WHERE state = 'queued' AND not_before IS NULL AND follows IS NULL;
CREATE INDEX jobs_delayed ON jobs (not_before) WHERE not_before IS NOT NULL;
CREATE INDEX jobs_following ON jobs (follows) WHERE follows IS NOT NULL;
-- For expiring leases and for start-up; as small as the number of workers.
CREATE INDEX jobs_held ON jobs (lease_until) WHERE lease_owner IS NOT NULL;
-- For lists and counts by state.
CREATE INDEX jobs_by_state ON jobs (state, id);
-- For results that are there already.
CREATE INDEX jobs_by_case ON jobs (case_hash);
CREATE INDEX jobs_by_sweep ON jobs (sweep, sweep_index) WHERE sweep IS NOT NULL;
CREATE INDEX jobs_by_archive ON jobs (archive_id) WHERE archive_id IS NOT NULL;
-- For what is removed by age.
CREATE INDEX jobs_by_end ON jobs (ended_at) WHERE ended_at IS NOT NULL;

-- What a client's key was first used for: the same again is answered as it was then.
CREATE TABLE idempotency_keys (
  caller      TEXT    NOT NULL,
  key         TEXT    NOT NULL,
  fingerprint TEXT    NOT NULL CHECK (length(fingerprint) = 64),
  job         TEXT REFERENCES jobs (id) ON DELETE CASCADE,
  sweep       TEXT REFERENCES sweeps (id) ON DELETE CASCADE,
  created_at  INTEGER NOT NULL,
  PRIMARY KEY (caller, key),
  CONSTRAINT of_one_thing CHECK ((job IS NULL) <> (sweep IS NULL))
) STRICT;
CREATE INDEX idempotency_keys_by_job ON idempotency_keys (job);
CREATE INDEX idempotency_keys_by_sweep ON idempotency_keys (sweep);
CREATE INDEX idempotency_keys_by_age ON idempotency_keys (created_at);

-- Jobs that were removed to make room: an id of one of them is known to have been there.
CREATE TABLE removed_jobs (
  id         TEXT    NOT NULL PRIMARY KEY,
  removed_at INTEGER NOT NULL
) STRICT;

-- What an operator has set and a restart must not forget.
CREATE TABLE settings (
  name  TEXT NOT NULL PRIMARY KEY,
  value TEXT NOT NULL
) STRICT;
