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

// What the user may need to know about the opening.
struct OpeningNotes {
    bool isNew = false;
    int versionBefore = 0;       // of the schema, if it was migrated; else 0
    bool othersMayRead = false;  // the file system has no modes, or the folder is somebody else's
    std::optional<SetAside> setAside;
};

// The sound rows of a list, and the number of damaged ones.
template <class T>
struct Listing {
    std::vector<T> entries;
    std::size_t damaged = 0;
};

struct OpenedVolume {
    std::string study;   // studyIdentity(); both are empty for a file that belongs to no study
    std::string series;  // seriesIdentity()
    std::string volume;  // digest
    std::optional<std::string> readableStudy;  // readable text, as the caller formats it
    std::optional<std::string> readableSeries;
};

struct StudyEntry {
    std::string identity;
    std::optional<std::string> readable;
    std::int64_t firstOpenedMs = 0;
    std::int64_t lastOpenedMs = 0;
    std::size_t series = 0;
    std::size_t models = 0;  // without those set aside
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
    // The time of last use, by which models are ordered: if the clock was set back, counts on from the last
    // use.
    std::int64_t usedMs = 0;
    // Why it was set aside: "missing", "size", "checksum", or the word given to setModelAside(). Empty: it
    // was not.
    std::string aside;
};

struct ModelCandidate {
    ModelInfo info;
    std::vector<std::string> differing;  // names of the parts that differ; may include "trainer"
};

struct LoadedModel {
    ModelInfo info;
    std::vector<std::byte> blob;
};

struct EvictionReport {
    std::size_t models = 0;
    std::uint64_t bytes = 0;
    std::uint64_t bytesLeft = 0;  // above the cap only if all that are left are open
};

struct SaveReport {
    ModelInfo info;
    EvictionReport evicted;
};

// Kinds of documents. `preset` to `clip` are the user's own; `view` is a bookmark; `studyState` is the state
// of a study, stored as "session"; `calibration` belongs to the machine.
enum class DocumentKind { preset, favourite, clip, view, studyState, layout, measurement, calibration };
std::string_view nameOf(DocumentKind kind);

struct DocumentId {
    DocumentKind kind = DocumentKind::studyState;
    std::string study;  // identity; empty: the document belongs to the machine and is for all studies
    // 1 to 200 bytes; other names are never found, and putting one fails. A view, study state, layout or
    // measurement without a study belongs to a volume, and is purged with it, if its name begins with the
    // volume's digest and a space.
    std::string name;
};

// Whether the document belongs to a volume: see `name`.
bool isOfVolume(const DocumentId& id);

struct DocumentEntry {
    DocumentId id;
    std::int64_t version = 0;  // of its format, as counted by the program that wrote it
    std::int64_t createdMs = 0;
    std::int64_t changedMs = 0;
};

struct Document : DocumentEntry {
    std::string json;
};

// `held`: the clock was doubted when things were to be deleted for their age.
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
    std::int64_t amount = 0;  // number of things
};

// What a purge does with damaged data, whose study is unknown: database files that were set aside, and rows
// of models and documents.
enum class DamagedFiles { keep, remove };

// Why the machine's clock is doubted: it shows less than a stored opening, or so much more than the last one
// that everything would be old.
enum class ClockDoubt { none, behind, ahead };
std::string_view nameOf(ClockDoubt doubt);

struct PurgeReport {
    std::size_t studies = 0;
    std::size_t volumes = 0;
    std::size_t models = 0;  // includes damaged ones that were removed; so does `documents`
    std::size_t documents = 0;
    // Studies and volumes that purgeUnused or purgeAll left alone because a model of theirs is open.
    std::size_t skippedOpen = 0;
    std::size_t damagedFolders = 0;       // damaged databases that are still set aside
    ClockDoubt clock = ClockDoubt::none;  // purgeUnused: why old entries may have stayed
};

struct VerifyReport {
    bool isDatabaseSound = false;  // pages, indexes and references
    std::size_t rows = 0;
    std::size_t blobs = 0;
    std::size_t damagedRows = 0;
    std::size_t damagedBlobs = 0;  // includes missing ones
    std::size_t setAside = 0;      // models and documents, now and earlier
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
    std::size_t skipped = 0;  // models and documents: newer in the store, or no room for them
    std::size_t damaged = 0;  // rows and blobs left out
};

}  // namespace macula::session
