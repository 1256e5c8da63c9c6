-- A run that went unstable keeps what it computed until then: a failed job may have a result, too. SQLite cannot
-- change a CHECK, so the table is made anew; the rows that it had satisfy the new one as they are.
CREATE TABLE jobs_new (
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
  CONSTRAINT success_has_a_result CHECK (state <> 'succeeded' OR summary IS NOT NULL),
  CONSTRAINT result_of_what_ran_to_an_end CHECK (summary IS NULL OR state IN ('succeeded', 'failed')),
  CONSTRAINT result_is_whole
    CHECK ((summary IS NOT NULL) = (archive_size IS NOT NULL)
       AND (summary IS NOT NULL) = (archive_sha256 IS NOT NULL)),
  CONSTRAINT failure_has_an_error CHECK ((state = 'failed') = (error IS NOT NULL))
) STRICT;

INSERT INTO jobs_new (id, state, name, case_hash, labels, priority, attempt, created_at, started_at, ended_at, not_before,
                      lease_owner, lease_until, progress, summary, error, archive_size, archive_sha256)
SELECT id, state, name, case_hash, labels, priority, attempt, created_at, started_at, ended_at, not_before,
       lease_owner, lease_until, progress, summary, error, archive_size, archive_sha256
FROM jobs;

DROP TABLE jobs;
ALTER TABLE jobs_new RENAME TO jobs;

-- In the order in which jobs are claimed.
CREATE INDEX jobs_waiting ON jobs (priority DESC, id) WHERE state = 'queued';
-- For expiring leases and for start-up; as small as the number of workers.
CREATE INDEX jobs_held ON jobs (lease_until) WHERE lease_owner IS NOT NULL;
-- For lists and counts by state.
CREATE INDEX jobs_by_state ON jobs (state, id);
