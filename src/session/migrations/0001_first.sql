-- What a person opened, made and learnt: docs/session-schema.md says what each column holds.
CREATE TABLE studies (
    identity TEXT NOT NULL PRIMARY KEY CHECK (length(identity) = 64),
    readable TEXT,
    first_opened INTEGER NOT NULL,
    last_opened INTEGER NOT NULL,
    row_check INTEGER NOT NULL
) STRICT;

CREATE TABLE series (
    identity TEXT NOT NULL PRIMARY KEY CHECK (length(identity) = 64),
    study TEXT NOT NULL REFERENCES studies (identity) ON DELETE CASCADE,
    readable TEXT,
    first_opened INTEGER NOT NULL,
    last_opened INTEGER NOT NULL,
    row_check INTEGER NOT NULL
) STRICT;
CREATE INDEX series_of_study ON series (study);

CREATE TABLE volumes (
    digest TEXT NOT NULL PRIMARY KEY CHECK (length(digest) = 64),
    first_opened INTEGER NOT NULL,
    last_opened INTEGER NOT NULL,
    row_check INTEGER NOT NULL
) STRICT;

CREATE TABLE series_volumes (
    series TEXT NOT NULL REFERENCES series (identity) ON DELETE CASCADE,
    volume TEXT NOT NULL REFERENCES volumes (digest) ON DELETE CASCADE,
    row_check INTEGER NOT NULL,
    PRIMARY KEY (series, volume)
) STRICT;
CREATE INDEX series_of_volume ON series_volumes (volume);

CREATE TABLE models (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    key TEXT NOT NULL CHECK (length(key) = 64),
    volume TEXT NOT NULL REFERENCES volumes (digest) ON DELETE CASCADE,
    trainer INTEGER NOT NULL,
    parts TEXT NOT NULL,
    bytes INTEGER NOT NULL CHECK (bytes >= 0),
    blob TEXT NOT NULL CHECK (length(blob) = 64),
    created INTEGER NOT NULL,
    saved INTEGER NOT NULL,
    used INTEGER NOT NULL,
    aside TEXT,
    row_check INTEGER NOT NULL
) STRICT;
CREATE UNIQUE INDEX models_by_key ON models (key) WHERE aside IS NULL;
CREATE INDEX models_of_volume ON models (volume);
CREATE INDEX models_by_use ON models (used);
CREATE INDEX models_by_blob ON models (blob);

CREATE TABLE documents (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    kind TEXT NOT NULL,
    study TEXT REFERENCES studies (identity) ON DELETE CASCADE,
    name TEXT NOT NULL,
    version INTEGER NOT NULL,
    json TEXT NOT NULL,
    created INTEGER NOT NULL,
    changed INTEGER NOT NULL,
    aside TEXT,
    row_check INTEGER NOT NULL
) STRICT;
CREATE UNIQUE INDEX documents_by_name ON documents (kind, coalesce(study, ''), name) WHERE aside IS NULL;
CREATE INDEX documents_of_study ON documents (study);

CREATE TABLE audit (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    at INTEGER NOT NULL,
    action TEXT NOT NULL,
    kind TEXT NOT NULL,
    subject TEXT NOT NULL CHECK (length(subject) IN (0, 64)),
    amount INTEGER NOT NULL,
    row_check INTEGER NOT NULL
) STRICT;
CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit
BEGIN
    SELECT raise(ABORT, 'the audit trail is only added to');
END;
CREATE TRIGGER audit_is_not_deleted BEFORE DELETE ON audit
BEGIN
    SELECT raise(ABORT, 'the audit trail is only added to');
END;
-- INSERT OR REPLACE deletes without asking the trigger above.
CREATE TRIGGER audit_is_not_replaced BEFORE INSERT ON audit
WHEN EXISTS (SELECT 1 FROM audit WHERE id = NEW.id)
BEGIN
    SELECT raise(ABORT, 'the audit trail is only added to');
END;
