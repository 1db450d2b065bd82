// The store: what a person opened, made and learnt, kept between runs. It holds plain values and blobs, and
// does not know what they mean.
//
// A folder (0700) with the database, the blobs of models in models/, and a lock file:
//
//     sessions.db   sessions.lock   models/<SHA-256>.model   damaged/<time>/...
//
// Threads: one at a time, as a rule a session thread that owns the store; nothing here belongs on a thread
// that draws. Each call that writes waits for the disk, and for other processes up to StoreOptions::patience.
// Any number of processes may have the same folder open. None of them may fork while it has.
//
// Errors: every call may fail with the troubles of session/trouble.h, of which troubleOf() tells which one it
// is. After an error the store is as it was before the call, but where the call says otherwise, and may be
// used on. A program that gets no store goes on without one, and says so once.
//
// Units: times are milliseconds since 1970 (UTC), sizes are bytes. Digests and identities are 64 lower-case
// hexadecimal digits; to pass another text for one is an error of the program. What is damaged is never
// returned: rows have checksums, blobs are named by theirs.
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
    // All blobs together. Models above it go, the least recently used first; those that are open stay.
    std::uint64_t modelCapBytes = 2'000'000'000;
    std::chrono::milliseconds patience{5000};
    // `full` looks at indexes too; see verify(), and use it to have a damaged file set aside.
    enum class Check { quick, full } check = Check::quick;
    std::string vfs;                      // for tests: SQLite's file layer
    std::function<std::int64_t()> nowMs;  // for tests: the clock; empty: that of the system
};

struct StoreState;

// A model that is open: as long as this lives, no process evicts or purges it. Get it before looking the
// model up. Any thread may let it go, and after the store too.
class OpenMark {
  public:
    OpenMark(OpenMark&&) noexcept;
    OpenMark& operator=(OpenMark&&) = delete;
    ~OpenMark();

  private:
    friend class Store;
    struct Held;
    explicit OpenMark(std::unique_ptr<Held> held);
    std::unique_ptr<Held> held_;
};

class Store {
  public:
    // Makes what is missing, migrates what is old, and checks what is there. A damaged database is set aside
    // and what can be read of it is rescued: notes() tells. Fails, and changes no file that is there, where
    // the folder cannot be used, is somebody else's, or was written by a newer version.
    static Result<Store> open(const StoreOptions& options);
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;
    ~Store();

    const OpeningNotes& notes() const;
    const std::filesystem::path& folder() const;

    // Studies. -------------------------------------------------------------------------------------------

    // Remembers that this was opened now, and puts it on the audit trail. Readable texts are stored as given,
    // and those that are missing are removed: pass them only where the site allows it.
    Result<void> recordOpened(const OpenedVolume& opened);
    // Latest opened first.
    Result<Listing<StudyEntry>> listStudies();
    Result<Listing<SeriesEntry>> listSeries(const std::string& study);

    // Models. --------------------------------------------------------------------------------------------

    // One transaction: a stop at any moment leaves this blob under the key, or the one of before. Makes room
    // by eviction; fails with modelTooLarge where the blob alone is above the cap.
    Result<SaveReport> saveModel(const ModelKey& key, std::span<const std::byte> blob);
    // Of just this key. Fails with modelDamaged, and sets the row aside, where the row is damaged.
    Result<std::optional<ModelInfo>> findModel(const ModelKey& key);
    // Models of the same volume for other keys, those that differ in the fewest parts first, then the last
    // used. At most so many.
    Result<std::vector<ModelCandidate>> nearestModels(const ModelKey& key, std::size_t most);
    // Its blob, as it was saved last: `info` of what is returned may be newer than the one given. A wrong
    // size or checksum is modelDamaged: the row is set aside and found no more.
    Result<LoadedModel> readModel(const ModelInfo& info);
    // The file of its blob, of which one may read the beginning alone. Nothing of it is checked: what is read
    // must have checksums of its own. It may vanish at any moment, but while an OpenMark is held only when
    // the key is saved anew; an open descriptor keeps it. Fails with modelGone where it is not there.
    Result<std::filesystem::path> modelFile(const ModelInfo& info) const;
    // For who found its content damaged, or does not understand it: the row is found no more, and goes first
    // when room is made. `why` is a word of letters a to z and '-', and says nothing of a patient. Nothing
    // happens where the key was saved anew since.
    Result<void> setModelAside(const ModelInfo& info, std::string_view why);
    // Latest used first, those set aside too; of all volumes, or of one.
    Result<Listing<ModelInfo>> listModels(const std::string& volume = {});
    // Counts as used now. Reading does not: that would make opening wait for the disk.
    Result<void> touchModel(const ModelKey& key);
    Result<OpenMark> markOpen(const ModelKey& key);
    // Least recently used first, and before them those that are damaged or set aside, until all together have
    // at most so many bytes or all that is left is open.
    Result<EvictionReport> evictModels(std::uint64_t capBytes);

    // Documents. -----------------------------------------------------------------------------------------

    // `json` is an object. Members of the stored document that this program does not know stay: those whose
    // path ("camera", "camera.eye") is neither in `json` nor in `known`. A member of `known` without members
    // of its own in the list belongs to the program altogether.
    Result<void> putDocument(const DocumentId& id, std::int64_t version, std::string_view json,
                             std::span<const std::string_view> known);
    // The same for what depends on what is stored now, of which no other process changes anything meanwhile.
    // `edit` is given the JSON that is stored, or nothing, and returns the one to store; it uses no store.
    using DocumentEdit = std::function<std::string(const std::optional<std::string>& stored)>;
    Result<void> changeDocument(const DocumentId& id, std::int64_t version, const DocumentEdit& edit,
                                std::span<const std::string_view> known);
    Result<std::optional<Document>> getDocument(const DocumentId& id);
    // Without their JSON, by name. `study` empty: those of the machine.
    Result<Listing<DocumentEntry>> listDocuments(DocumentKind kind, const std::string& study);
    // False where there was none.
    Result<bool> removeDocument(const DocumentId& id);

    // Audit trail: only ever added to. The store itself adds what was opened, purged, exported and imported.

    Result<void> addAudit(AuditAction action, AuditKind kind, const std::string& subject,
                          std::int64_t amount = 0);
    // The last so many, oldest first.
    Result<Listing<AuditEntry>> listAudit(std::size_t most);

    // Care. ----------------------------------------------------------------------------------------------

    // Deletes a study with its series, documents, and the volumes and models that no other study has; or a
    // volume with its models and documents, unless a study has it. Then the file is written anew and blobs
    // are overwritten, so that no file of the folder holds any of it; the audit trail keeps its identity.
    // What is damaged stays, unless it goes too. Fails with lockedByAnother where one of its models is open.
    // Fails with purgeIncomplete where rows are deleted and another process keeps bytes from being
    // overwritten: do it again, or collectGarbage(), which do what a purge that was stopped has left.
    Result<PurgeReport> purgeStudy(const std::string& study, DamagedFiles damaged);
    Result<PurgeReport> purgeVolume(const std::string& volume, DamagedFiles damaged);
    // All studies, and volumes without one, that were not opened for so many days. Where the clock is doubted
    // (age_clock.h) nothing is deleted, and the report and the audit trail say so; one that is `trusted` is
    // not asked, and openings that are later than it are of now from then on.
    enum class Clock { checked, trusted };
    Result<PurgeReport> purgeUnused(std::chrono::days retention, DamagedFiles damaged,
                                    Clock clock = Clock::checked);
    // What purgeUnused would say of the clock.
    Result<ClockDoubt> clockDoubt(std::chrono::days retention);
    // All studies, and volumes without one, but for those of which a model is open. The machine's documents
    // that are of no volume, and the audit trail, stay.
    Result<PurgeReport> purgeAll(DamagedFiles damaged);

    // Reads everything: pages, indexes, references, rows, blobs. Sets models and documents aside that do not
    // pass. Where isDatabaseSound is false, close all stores and open one with Check::full.
    Result<VerifyReport> verify(Progress& progress);
    // Removes blobs without a row, and what killed programs left half written or half purged.
    Result<GcReport> collectGarbage();

    // A copy of one moment, made by SQLite and not by copying its file: a new folder (0700) with the database
    // and its blobs, not below the store's own. Nothing is there when it fails.
    Result<SnapshotReport> exportTo(const std::filesystem::path& newFolder, Progress& progress);
    // Adds what such a folder holds and this store lacks; of what both have, the newer stays. The audit trail
    // of the other is left out. The folder is not changed. Where it fails or is stopped on the way, what was
    // added by then stays.
    Result<SnapshotReport> importFrom(const std::filesystem::path& folder, Progress& progress);

  private:
    explicit Store(std::unique_ptr<StoreState> state);

    std::unique_ptr<StoreState> state_;
};

}  // namespace macula::session
