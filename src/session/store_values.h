// Values that go into the store and come out of it. Units are in store.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session/model_key.h"

namespace macula::session {

// A damaged database that was set aside: its folder, and how many rows were rescued from it.
struct SetAside {
    std::filesystem::path folder;
    std::size_t rowsRescued = 0;
    std::size_t modelsRescued = 0;
    std::size_t documentsRescued = 0;
};

// What is worth telling a person of the opening.
struct OpeningNotes {
    bool isNew = false;
    int versionBefore = 0;       // of the schema, where it was migrated
    bool othersMayRead = false;  // the file system has no modes, or the folder is somebody else's
    std::optional<SetAside> setAside;
};

// What a list gives: sound rows, and how many others there were.
template <class T>
struct Listing {
    std::vector<T> entries;
    std::size_t damaged = 0;
};

struct OpenedVolume {
    std::string study;   // studyIdentity(); both are empty for a file that belongs to no study
    std::string series;  // seriesIdentity()
    std::string volume;  // digest
    std::optional<std::string> readableStudy;  // what a person may read of it, as the caller formats it
    std::optional<std::string> readableSeries;
};

struct StudyEntry {
    std::string identity;
    std::optional<std::string> readable;
    std::int64_t firstOpenedMs = 0;
    std::int64_t lastOpenedMs = 0;
    std::size_t series = 0;
    std::size_t models = 0;  // that are not set aside
    std::uint64_t modelBytes = 0;
    std::size_t documents = 0;
};

struct SeriesEntry {
    std::string identity;
    std::optional<std::string> readable;
    std::int64_t firstOpenedMs = 0;
    std::int64_t lastOpenedMs = 0;
    std::vector<std::string> volumes;
};

struct ModelInfo {
    std::int64_t id = 0;
    ModelKey key;
    std::uint64_t bytes = 0;
    std::string checksum;  // SHA-256 of the blob
    std::int64_t createdMs = 0;
    std::int64_t savedMs = 0;
    // The order of use. It is the time, but for a clock that was put back: then it goes on from the last.
    std::int64_t usedMs = 0;
    // Why it was set aside: "missing", "size", "checksum", or what setModelAside() was given. Empty: it was
    // not.
    std::string aside;
};

struct ModelCandidate {
    ModelInfo info;
    std::vector<std::string> differing;  // names of parts, "trainer" among them
};

struct LoadedModel {
    ModelInfo info;
    std::vector<std::byte> blob;
};

struct EvictionReport {
    std::size_t models = 0;
    std::uint64_t bytes = 0;
    std::uint64_t bytesLeft = 0;  // above the cap only where all that is left is open
};

struct SaveReport {
    ModelInfo info;
    EvictionReport evicted;
};

// Kinds of documents. `preset` to `clip` are the user's own; `view` is a bookmark; `session` is the state of
// a study; `calibration` is of the machine.
enum class DocumentKind { preset, favourite, clip, view, session, layout, measurement, calibration };
std::string_view nameOf(DocumentKind kind);

struct DocumentId {
    DocumentKind kind = DocumentKind::session;
    std::string study;  // identity; empty: of the machine, for all studies
    // 1 to 200 bytes; others are found nowhere, and refused where one is put. A view, session, layout or
    // measurement without a study whose name begins with the digest of a volume and a space is of that
    // volume, and is purged with it.
    std::string name;
};

// As `name` says above.
bool isOfVolume(const DocumentId& id);

struct DocumentEntry {
    DocumentId id;
    std::int64_t version = 0;  // of its format, as the program that wrote it counts
    std::int64_t createdMs = 0;
    std::int64_t changedMs = 0;
};

struct Document : DocumentEntry {
    std::string json;
};

// `held`: nothing was deleted for its age, as the clock was doubted.
enum class AuditAction { opened, exported, deleted, imported, expired, held };
enum class AuditKind { study, series, volume, model, document, picture, store };
std::string_view nameOf(AuditAction action);
std::string_view nameOf(AuditKind kind);

struct AuditEntry {
    std::int64_t id = 0;
    std::int64_t atMs = 0;
    std::string action;
    std::string kind;
    std::string subject;      // a digest or identity, or empty
    std::int64_t amount = 0;  // how many
};

// What a purge does with what is damaged, files that were set aside and rows of models and documents: nobody
// can tell of which study it is.
enum class DamagedFiles { keep, remove };

// Why the clock of the machine is not believed: it shows less than an opening has stored, or so much more
// than the last one that all of them would be old.
enum class ClockDoubt { none, behind, ahead };
std::string_view nameOf(ClockDoubt doubt);

struct PurgeReport {
    std::size_t studies = 0;
    std::size_t volumes = 0;
    std::size_t models = 0;  // damaged ones too, where they are removed; of documents as well
    std::size_t documents = 0;
    std::size_t skippedOpen = 0;          // of purgeUnused and purgeAll: a model of theirs is open
    std::size_t damagedFolders = 0;       // that are still there
    ClockDoubt clock = ClockDoubt::none;  // of purgeUnused: why what seems to be old has stayed
};

struct VerifyReport {
    bool isDatabaseSound = false;  // pages, indexes and references
    std::size_t rows = 0;
    std::size_t blobs = 0;
    std::size_t damagedRows = 0;
    std::size_t damagedBlobs = 0;  // missing ones too
    std::size_t setAside = 0;      // models and documents, by now and before
    std::size_t orphans = 0;       // blobs without a row
    std::size_t damagedFolders = 0;
    bool isSound() const { return isDatabaseSound && damagedRows == 0 && damagedBlobs == 0; }
};

struct GcReport {
    std::size_t blobs = 0;
    std::uint64_t bytes = 0;
};

struct SnapshotReport {
    std::size_t studies = 0;
    std::size_t models = 0;
    std::size_t documents = 0;
    std::size_t skipped = 0;  // the store's own was newer, or there was no room
    std::size_t damaged = 0;  // rows and blobs that were left out
};

}  // namespace macula::session
