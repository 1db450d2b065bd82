// The study store: what the user opened and made, and what models learnt, kept between runs. It holds plain
// values and blobs, and does not interpret them.
//
// The store is a folder (0700) with the database, the blobs of models in models/, and a lock file:
//
//     sessions.db   sessions.lock   models/<SHA-256>.model   damaged/<time>/...
//
// Threads: one at a time, usually a session thread that owns the store; call nothing here from a thread that
// draws. Each call that writes waits for the disk, and for other processes up to StoreOptions::patience. Any
// number of processes may have the same folder open. None of them may fork while it does.
//
// Errors: every call may fail with a Trouble (session/trouble.h), which troubleOf() returns. After an error
// the store is as it was before the call, unless the call's comment says otherwise, and remains usable. A
// program that cannot open the store continues without one, and tells the user once.
//
// Units: times are milliseconds since 1970 (UTC), sizes are bytes. Digests and identities are 64 lower-case
// hexadecimal digits; passing other text for one is a programming error. Damaged data is never returned: rows
// have checksums, and blobs are named by theirs.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "session/model_key.h"
#include "session/store_values.h"
#include "session/trouble.h"

namespace macula::session {

// $MACULA_SESSIONS, else $XDG_DATA_HOME/macula/sessions, else ~/.local/share/macula/sessions.
std::filesystem::path defaultFolder();

struct StoreOptions {
    std::filesystem::path folder = defaultFolder();
    // The limit for all blobs together. Above it, the least recently used models are evicted; open ones stay.
    std::uint64_t modelCapBytes = 2'000'000'000;
    std::chrono::milliseconds patience{5000};
    // `full` checks indexes too; use it to have a damaged file set aside, see verify().
    enum class Check { quick, full } check = Check::quick;
    std::string vfs;                      // for tests: SQLite's file layer
    std::function<std::int64_t()> nowMs;  // for tests: the clock; empty: the system's
};

struct StoreState;

// Marks a model as open: while the mark lives, no process evicts or purges the model. Get the mark before
// looking the model up. Any thread may destroy it, even after the store.
class OpenMark {
  public:
    OpenMark(OpenMark&&) noexcept;
    OpenMark& operator=(OpenMark&&) = delete;
    ~OpenMark();

  private:
    friend class StoreModels;
    struct Held;
    explicit OpenMark(std::unique_ptr<Held> held);
    std::unique_ptr<Held> held_;
};

class Store {
  public:
    // Creates what is missing, migrates an old schema, and checks the database. Sets a damaged database aside
    // and rescues its readable rows; see notes(). Fails, changing no existing file, if the folder cannot be
    // used, belongs to somebody else, or was written by a newer version.
    static Result<Store> open(const StoreOptions& options);
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;
    ~Store();

    const OpeningNotes& notes() const;
    const std::filesystem::path& folder() const;

    // Studies. -------------------------------------------------------------------------------------------

    // Records in the store and its audit trail that the volume was opened now. Stores readable texts as
    // given, and removes those that are missing: pass them only if the site allows it.
    Result<void> recordOpened(const OpenedVolume& opened);
    // Latest opened first.
    Result<Listing<StudyEntry>> listStudies();
    Result<Listing<SeriesEntry>> listSeries(const std::string& study);

    // Models. --------------------------------------------------------------------------------------------

    // One transaction: a stop at any moment leaves this blob under the key, or the previous one. Evicts
    // models to make room; fails with modelTooLarge if the blob alone is above the cap.
    Result<SaveReport> saveModel(const ModelKey& key, std::span<const std::byte> blob);
    // The model of exactly this key. If its row is damaged, sets it aside and fails with modelDamaged.
    Result<std::optional<ModelInfo>> findModel(const ModelKey& key);
    // At most `most` models of the same volume with other keys: those that differ in the fewest parts first,
    // then the most recently used.
    Result<std::vector<ModelCandidate>> nearestModels(const ModelKey& key, std::size_t most);
    // The blob as last saved: the returned `info` may be newer than the one given. With a wrong size or
    // checksum, sets the row aside, so that it is no longer found, and fails with modelDamaged.
    Result<LoadedModel> readModel(const ModelInfo& info);
    // The file of the blob, to read its beginning alone. The content is not checked, so it must have its own
    // checksums. The file may vanish at any moment; while an OpenMark is held, only when the key is saved
    // again. An open descriptor keeps the content. Fails with modelGone if there is no file.
    Result<std::filesystem::path> modelFile(const ModelInfo& info) const;
    // For a caller that finds the content damaged or cannot read it: the row is no longer found, and is
    // evicted first. `why` is a word of letters a to z and '-', without patient data. Does nothing if the key
    // has been saved again since.
    Result<void> setModelAside(const ModelInfo& info, std::string_view why);
    // Latest used first, including those set aside; of one volume, or of all if `volume` is empty.
    Result<Listing<ModelInfo>> listModels(const std::string& volume = {});
    // Marks the model as used now. Reading it does not, because opening would then wait for the disk.
    Result<void> touchModel(const ModelKey& key);
    Result<OpenMark> markOpen(const ModelKey& key);
    // Removes models, damaged and set-aside ones first, then the least recently used, until all together have
    // at most `capBytes` or only open ones are left.
    Result<EvictionReport> evictModels(std::uint64_t capBytes);

    // Documents. -----------------------------------------------------------------------------------------

    // `json` is an object. Members of the stored document that this program does not know stay: those whose
    // path ("camera", "camera.eye") is neither in `json` nor in `known`. If a member is in `known` and none
    // of its own members are, the program owns the whole of it.
    Result<void> putDocument(const DocumentId& id, std::int64_t version, std::string_view json,
                             std::span<const std::string_view> known);
    // The same, for a change that depends on the stored document, which no other process changes meanwhile.
    // `edit` gets the stored JSON, or nothing, and returns the JSON to store; it must not use a store.
    using DocumentEdit = std::function<std::string(const std::optional<std::string>& stored)>;
    Result<void> changeDocument(const DocumentId& id, std::int64_t version, const DocumentEdit& edit,
                                std::span<const std::string_view> known);
    Result<std::optional<Document>> getDocument(const DocumentId& id);
    // Ordered by name, without their JSON. `study` empty: the documents that belong to the machine.
    Result<Listing<DocumentEntry>> listDocuments(DocumentKind kind, const std::string& study);
    // False if there was no such document.
    Result<bool> removeDocument(const DocumentId& id);

    // Audit trail: append-only. The store itself adds openings, purges, exports, imports and clock doubts.

    Result<void> addAudit(AuditAction action, AuditKind kind, const std::string& subject,
                          std::int64_t amount = 0);
    // The last `most` entries, oldest first.
    Result<Listing<AuditEntry>> listAudit(std::size_t most);

    // Care. ----------------------------------------------------------------------------------------------

    // Deletes a study with its series, documents, and the volumes and models that no other study has; or a
    // volume with its models and documents, unless a study has it. Then rewrites the database file and
    // overwrites the blobs, so that no file of the folder holds any of it; the audit trail keeps its
    // identity. `damaged` decides about damaged data. Fails with lockedByAnother if one of its models is
    // open. Fails with purgeIncomplete if the rows are deleted, but another process prevents overwriting:
    // purge again or call collectGarbage(), which finish a purge that was stopped.
    Result<PurgeReport> purgeStudy(const std::string& study, DamagedFiles damaged);
    Result<PurgeReport> purgeVolume(const std::string& volume, DamagedFiles damaged);
    // Deletes all studies, and volumes without a study, that were not opened for `retention`. While the clock
    // is doubted (age_clock.h), deletes nothing, or only what was old at the last trusted time; report and
    // audit trail say so. A `trusted` clock is not checked, and openings later than it are set to it.
    enum class Clock { checked, trusted };
    Result<PurgeReport> purgeUnused(std::chrono::days retention, DamagedFiles damaged,
                                    Clock clock = Clock::checked);
    // The doubt about the clock that purgeUnused would report.
    Result<ClockDoubt> clockDoubt(std::chrono::days retention);
    // Deletes all studies, and volumes without a study, except those with an open model. Keeps the audit
    // trail, and the machine's documents that belong to no volume.
    Result<PurgeReport> purgeAll(DamagedFiles damaged);

    // Reads everything: pages, indexes, references, rows, blobs. Sets damaged models and documents aside. If
    // isDatabaseSound is false, close all stores and open one with Check::full.
    Result<VerifyReport> verify(Progress& progress);
    // Removes blobs without a row, and what killed programs left half written or half purged.
    Result<GcReport> collectGarbage();

    // Copies the store as it is at one moment, through SQLite and not by copying its file: makes a new folder
    // (0700) with the database and its blobs, not below the store's own. Leaves nothing there if it fails.
    Result<SnapshotReport> exportTo(const std::filesystem::path& newFolder, Progress& progress);
    // Adds what such a folder holds and this store lacks; of entries in both, the newer stays. Leaves out the
    // other audit trail, and does not change the folder. If it fails or is stopped, entries added by then
    // stay.
    Result<SnapshotReport> importFrom(const std::filesystem::path& folder, Progress& progress);

  private:
    explicit Store(std::unique_ptr<StoreState> state);

    std::unique_ptr<StoreState> state_;
};

}  // namespace macula::session
