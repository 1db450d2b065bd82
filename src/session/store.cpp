#include "session/store.h"

#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <string_view>

#include "base/user_folder.h"
#include "session/damaged_file.h"
#include "session/migrations.h"
#include "session/store_parts.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

bool isOurName(const std::string& name) {
    return name.starts_with(kDatabaseName) || name == kLockName || name == kModelsName ||
           name == kDamagedName || name == kPurgeName || name.starts_with(".sessions.");
}

// Requires a folder that holds nothing but files of a store, and closes it to other users.
Result<void> prepareFolder(const fs::path& folder, OpeningNotes& notes) {
    MACULA_TRY_VOID(makePrivateFolder(folder));
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (!isOurName(entry->path().filename().string())) return errorOf(Trouble::notOurs, folder);
    if (error) return errorOf(troubleOfErrno(error.value()), folder);
    const auto isForOthers = [&] {
        struct stat status {};
        return stat(folder.c_str(), &status) != 0 || (status.st_mode & 077u) != 0;
    };
    if (isForOthers()) {
        // Only removes permissions: a folder that somebody made read-only stays so.
        fs::permissions(folder, fs::perms::group_all | fs::perms::others_all, fs::perm_options::remove,
                        error);
        notes.othersMayRead = isForOthers();
    }
    return {};
}

// Opens the database, checks it, and migrates it to the newest schema. Fails with damaged if it is not what
// was written.
Result<std::unique_ptr<Connection>> openDatabase(const StoreOptions& options, const fs::path& file,
                                                 const BlobFiles& blobs, OpeningNotes& notes) {
    // Lists blobs before opening the database: blobs exist only after tables do, so an empty file next to
    // blobs has lost its tables.
    MACULA_TRY(const auto blobsBefore, blobs.list());
    MACULA_TRY(auto connection,
               connect(file, {.patience = options.patience, .vfs = options.vfs, .isOurs = false}));
    const bool isFull = options.check == StoreOptions::Check::full;
    MACULA_TRY(const Inspection found,
               inspect(*connection, isFull ? Thoroughness::full : Thoroughness::quick));
    if (found.version > newestVersion()) return errorOf(Trouble::newerSchema, file);
    if (found.isEmpty && !blobsBefore.empty()) return errorOf(Trouble::damaged, file);
    MACULA_TRY_VOID(settle(*connection));
    notes.isNew = found.isEmpty;
    notes.versionBefore = found.version == newestVersion() ? 0 : found.version;
    MACULA_TRY_VOID(migrate(*connection));
    MACULA_TRY_VOID(checkSchema(*connection));
    return connection;
}

// Sets the damaged file aside once no other process has the store open, unless another has done so meanwhile.
Result<std::unique_ptr<Connection>> rescueDatabase(const StoreOptions& options, const fs::path& file,
                                                   const std::shared_ptr<LockFile>& locks,
                                                   const BlobFiles& blobs, OpeningNotes& notes) {
    // Two processes that each kept their shared lock and waited for the exclusive one would wait for ever.
    locks->release(LockFile::kPresence);
    auto result = [&]() -> Result<std::unique_ptr<Connection>> {
        MACULA_TRY_VOID(locks->acquire(LockFile::kPresence, Hold::exclusive, options.patience));
        auto again = openDatabase(options, file, blobs, notes);
        if (again || troubleOf(again.error()) != Trouble::damaged) return again;
        if (isOfNewerVersion(file)) return errorOf(Trouble::newerSchema, file);
        MACULA_TRY(notes.setAside, setAsideAndRescue(file, blobs, options.patience));
        return openDatabase(options, file, blobs, notes);
    }();
    if (auto shared = locks->acquire(LockFile::kPresence, Hold::shared, options.patience); !shared)
        return shared.error();
    return result;
}

}  // namespace

fs::path defaultFolder() {
    if (const char* chosen = std::getenv("MACULA_SESSIONS"); chosen != nullptr && *chosen != '\0')
        return chosen;
    return userDataFolder() / "sessions";
}

std::int64_t StoreState::nowMs() const {
    if (options.nowMs) return options.nowMs();
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::milliseconds>(since).count();
}

Store::Store(std::unique_ptr<StoreState> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const StoreOptions& options) {
    OpeningNotes notes;
    MACULA_TRY_VOID(prepareFolder(options.folder, notes));
    std::error_code error;
    const fs::path folder = fs::canonical(options.folder, error);
    if (error) return errorOf(troubleOfErrno(error.value()), options.folder);
    MACULA_TRY(auto locks, LockFile::open(folder / kLockName));
    MACULA_TRY(HeldLock presence, HeldLock::take(locks, LockFile::kPresence, Hold::shared, options.patience));
    MACULA_TRY(BlobFiles blobs, BlobFiles::open(folder / kModelsName));
    const fs::path file = folder / kDatabaseName;
    auto connection = openDatabase(options, file, blobs, notes);
    if (!connection && troubleOf(connection.error()) == Trouble::damaged)
        connection = rescueDatabase(options, file, locks, blobs, notes);
    if (!connection) return connection.error();
    return Store(std::unique_ptr<StoreState>(
        new StoreState{options, folder, std::move(locks), std::move(presence), std::move(blobs),
                       std::move(connection).value(), std::move(notes)}));
}

const OpeningNotes& Store::notes() const {
    return state_->notes;
}
const fs::path& Store::folder() const {
    return state_->folder;
}

Result<void> Store::recordOpened(const OpenedVolume& opened) {
    return StoreStudies(*state_).recordOpened(opened);
}
Result<Listing<StudyEntry>> Store::listStudies() {
    return StoreStudies(*state_).list();
}
Result<Listing<SeriesEntry>> Store::listSeries(const std::string& study) {
    return StoreStudies(*state_).listSeries(study);
}

Result<SaveReport> Store::saveModel(const ModelKey& key, std::span<const std::byte> blob) {
    return StoreModels(*state_).save(key, blob);
}
Result<std::optional<ModelInfo>> Store::findModel(const ModelKey& key) {
    return StoreModels(*state_).find(key);
}
Result<std::vector<ModelCandidate>> Store::nearestModels(const ModelKey& key, std::size_t most) {
    return StoreModels(*state_).nearest(key, most);
}
Result<LoadedModel> Store::readModel(const ModelInfo& info) {
    return StoreModels(*state_).read(info);
}
Result<fs::path> Store::modelFile(const ModelInfo& info) const {
    return StoreModels(*state_).fileOf(info);
}
Result<void> Store::setModelAside(const ModelInfo& info, std::string_view why) {
    return StoreModels(*state_).setAside(info, why);
}
Result<Listing<ModelInfo>> Store::listModels(const std::string& volume) {
    return StoreModels(*state_).list(volume);
}
Result<void> Store::touchModel(const ModelKey& key) {
    return StoreModels(*state_).touch(key);
}
Result<OpenMark> Store::markOpen(const ModelKey& key) {
    return StoreModels(*state_).markOpen(key);
}
Result<EvictionReport> Store::evictModels(std::uint64_t capBytes) {
    return StoreModels(*state_).evict(capBytes);
}

Result<void> Store::putDocument(const DocumentId& id, std::int64_t version, std::string_view json,
                                std::span<const std::string_view> known) {
    return changeDocument(
        id, version, [json](const std::optional<std::string>&) { return std::string(json); }, known);
}
Result<void> Store::changeDocument(const DocumentId& id, std::int64_t version, const DocumentEdit& edit,
                                   std::span<const std::string_view> known) {
    return StoreDocuments(*state_).change(id, version, edit, known);
}
Result<std::optional<Document>> Store::getDocument(const DocumentId& id) {
    return StoreDocuments(*state_).get(id);
}
Result<Listing<DocumentEntry>> Store::listDocuments(DocumentKind kind, const std::string& study) {
    return StoreDocuments(*state_).list(kind, study);
}
Result<bool> Store::removeDocument(const DocumentId& id) {
    return StoreDocuments(*state_).remove(id);
}

Result<void> Store::addAudit(AuditAction action, AuditKind kind, const std::string& subject,
                             std::int64_t amount) {
    return AuditTrail(*state_).add(action, kind, subject, amount);
}
Result<Listing<AuditEntry>> Store::listAudit(std::size_t most) {
    return AuditTrail(*state_).list(most);
}

Result<PurgeReport> Store::purgeStudy(const std::string& study, DamagedFiles damaged) {
    return StorePurge(*state_).study(study, damaged);
}
Result<PurgeReport> Store::purgeVolume(const std::string& volume, DamagedFiles damaged) {
    return StorePurge(*state_).volume(volume, damaged);
}
Result<PurgeReport> Store::purgeUnused(std::chrono::days retention, DamagedFiles damaged, Clock clock) {
    return StorePurge(*state_).unused(retention, damaged, clock);
}
Result<ClockDoubt> Store::clockDoubt(std::chrono::days retention) {
    return StorePurge(*state_).clockDoubt(retention);
}
Result<PurgeReport> Store::purgeAll(DamagedFiles damaged) {
    return StorePurge(*state_).all(damaged);
}

Result<VerifyReport> Store::verify(Progress& progress) {
    return StoreCare(*state_).verify(progress);
}
Result<GcReport> Store::collectGarbage() {
    return StoreCare(*state_).collectGarbage();
}

Result<SnapshotReport> Store::exportTo(const fs::path& newFolder, Progress& progress) {
    return StoreSnapshots(*state_).exportTo(newFolder, progress);
}
Result<SnapshotReport> Store::importFrom(const fs::path& folder, Progress& progress) {
    return StoreSnapshots(*state_).importFrom(folder, progress);
}

}  // namespace macula::session
