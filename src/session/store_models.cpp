#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "session/age_clock.h"
#include "session/trouble.h"

namespace macula::session {

namespace {

SQLite::Statement modelOfKey(Connection& connection, const std::string& digest) {
    SQLite::Statement statement = select(connection, kModels, "WHERE t.key = ? AND t.aside IS NULL");
    statement.bind(1, digest);
    return statement;
}

struct Found {
    std::optional<ModelInfo> info;
    std::optional<std::int64_t> damagedId;
};

// The model with this key. If a damaged index leads to another model's row, that row counts as damaged.
Found findByKey(Connection& connection, const std::string& digest) {
    SQLite::Statement statement = modelOfKey(connection, digest);
    if (!statement.executeStep()) return {};
    const auto row = readRow(statement, kModels);
    std::optional<ModelInfo> info = row ? modelOf(*row) : std::nullopt;
    if (info && info->key.digest() == digest) return {.info = std::move(info)};
    return {.damagedId = statement.getColumn(0).getInt64()};
}

// A time of use later than all others, even if the clock was set back. Ignores times a century ahead, which
// come from damaged rows.
std::int64_t nextUse(StoreState& state) {
    constexpr std::int64_t kCentury = std::int64_t{100} * 365 * 86'400'000;
    const std::int64_t now = state.nowMs();
    const std::int64_t last = numberOf(
        *state.connection, "SELECT max(used) FROM models WHERE used < " + std::to_string(now + kCentury));
    return std::max(now, last + 1);
}

// A single word such as "checksum", which cannot hold patient data as a sentence could.
bool isAsideWord(std::string_view why) {
    return !why.empty() && why.size() <= 40 &&
           why.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
}

Error modelDamaged(const StoreState& state) {
    return errorOf(Trouble::modelDamaged, state.blobs.folder());
}

// The row for the blob: the previous one with its id, or a new one.
ModelInfo infoToSave(StoreState& state, const ModelKey& key, std::optional<ModelInfo> before) {
    const std::int64_t now = state.nowMs();
    ModelInfo info = before.value_or(ModelInfo{.key = key, .createdMs = now});
    if (!before) info.id = nextId(*state.connection, kModels);
    info.savedMs = now;
    info.usedMs = nextUse(state);
    return info;
}

// Call in a transaction. Appends to `unused` the blobs that no row needs any more.
Result<void> saveRow(StoreState& state, const ModelKey& key, const BlobFiles::Prepared& prepared,
                     std::uint64_t bytes, SaveReport& report, std::vector<std::string>& unused) {
    Connection& connection = *state.connection;
    rememberVolume(connection, key.volume, openingMs(state));
    Found before = findByKey(connection, key.digest());
    if (before.damagedId) setRowAside(connection, kModels, *before.damagedId);
    if (before.info) unused.push_back(before.info->checksum);
    report.info = infoToSave(state, key, std::move(before.info));
    report.info.bytes = bytes;
    report.info.checksum = prepared.digest;
    MACULA_TRY_VOID(state.blobs.putInPlace(prepared));
    unused.push_back(prepared.digest);  // counts as unused until its row is committed
    putRow(connection, kModels, rowOf(report.info));
    Evicted evicted = evictRows(state, state.options.modelCapBytes, report.info.id);
    report.evicted = evicted.report;
    unused.insert(unused.end(), evicted.blobs.begin(), evicted.blobs.end());
    return {};
}

}  // namespace

std::optional<ModelInfo> modelOf(const Row& row) {
    ModelInfo info{
        .id = row.number(column::modelId),
        .key = {.volume = row.text(column::modelVolume), .trainer = row.number(column::modelTrainer)},
        .bytes = static_cast<std::uint64_t>(row.number(column::modelBytes)),
        .checksum = row.text(column::modelBlob),
        .createdMs = row.number(column::modelCreated),
        .savedMs = row.number(column::modelSaved),
        .usedMs = row.number(column::modelUsed),
        .aside = row.textOrNull(column::modelAside).value_or("")};
    if (!partsOfText(row.text(column::modelParts), info.key.parts)) return {};
    if (!isDigest(info.checksum) || row.number(column::modelBytes) < 0) return {};
    if (!info.key.isValid() || info.key.digest() != row.text(column::modelKey)) return {};
    return info;
}

Row rowOf(const ModelInfo& info) {
    return {{info.id, info.key.digest(), info.key.volume, info.key.trainer, textOfParts(info.key.parts),
             static_cast<std::int64_t>(info.bytes), info.checksum, info.createdMs, info.savedMs, info.usedMs,
             info.aside.empty() ? Value() : Value(info.aside)}};
}

Result<void> setModelAside(StoreState& state, std::int64_t id, const std::string& blob,
                           std::string_view why) {
    return inTransaction(*state.connection, [&]() -> Result<void> {
        SQLite::Statement statement =
            select(*state.connection, kModels, "WHERE t.id = " + std::to_string(id));
        if (!statement.executeStep()) return {};
        auto row = readRow(statement, kModels);
        statement.reset();
        if (!row || row->text(column::modelBlob) != blob) return {};
        row->values[column::modelAside] = std::string(why);
        putRow(*state.connection, kModels, *row);
        return {};
    });
}

Result<SaveReport> StoreModels::save(const ModelKey& key, std::span<const std::byte> blob) {
    MACULA_CHECK(key.isValid());
    if (blob.size() > state_.options.modelCapBytes)
        return errorOf(Trouble::modelTooLarge, state_.blobs.folder());
    MACULA_TRY(const BlobFiles::Prepared prepared, state_.blobs.prepare(blob));
    SaveReport report;
    std::vector<std::string> unused;
    const auto saved = inTransaction(
        *state_.connection, [&] { return saveRow(state_, key, prepared, blob.size(), report, unused); });
    if (saved) std::erase(unused, prepared.digest);
    // A blob that cannot be removed now is left for collectGarbage().
    static_cast<void>(removeBlobs(state_, unused, BlobFiles::Removal::plain, {}));
    if (!saved) return saved.error();
    return report;
}

Result<std::optional<ModelInfo>> StoreModels::find(const ModelKey& key) {
    MACULA_CHECK(key.isValid());
    Connection& connection = *state_.connection;
    MACULA_TRY(const Found found,
               guarded(connection, [&]() -> Result<Found> { return findByKey(connection, key.digest()); }));
    if (!found.damagedId) return found.info;
    MACULA_TRY_VOID(inTransaction(connection, [&]() -> Result<void> {
        if (const Found again = findByKey(connection, key.digest()); again.damagedId)
            setRowAside(connection, kModels, *again.damagedId);
        return {};
    }));
    return modelDamaged(state_);
}

Result<std::vector<ModelCandidate>> StoreModels::nearest(const ModelKey& key, std::size_t most) {
    MACULA_CHECK(key.isValid());
    Connection& connection = *state_.connection;
    return guarded(connection, [&]() -> Result<std::vector<ModelCandidate>> {
        std::vector<ModelCandidate> candidates;
        SQLite::Statement statement =
            select(connection, kModels, "WHERE t.volume = ? AND t.aside IS NULL ORDER BY t.used DESC, t.id");
        statement.bind(1, key.volume);
        while (statement.executeStep()) {
            const auto row = readRow(statement, kModels);
            auto info = row ? modelOf(*row) : std::nullopt;
            if (!info || info->key.volume != key.volume) continue;
            auto differing = differences(key, info->key);
            if (!differing.empty()) candidates.push_back({std::move(*info), std::move(differing)});
        }
        std::ranges::stable_sort(candidates, {},
                                 [](const ModelCandidate& candidate) { return candidate.differing.size(); });
        if (candidates.size() > most) candidates.resize(most);
        return candidates;
    });
}

Result<LoadedModel> StoreModels::read(const ModelInfo& info) {
    std::optional<ModelInfo> found;
    ReadBlob blob;
    {
        // Keeps other processes from removing the blob after its row is read.
        MACULA_TRY(const HeldLock reading,
                   HeldLock::take(state_.locks, LockFile::kBlobs, Hold::shared, state_.options.patience));
        MACULA_TRY(found, guarded(*state_.connection, [&]() -> Result<std::optional<ModelInfo>> {
                       SQLite::Statement statement =
                           select(*state_.connection, kModels,
                                  "WHERE t.id = " + std::to_string(info.id) + " AND t.aside IS NULL");
                       if (!statement.executeStep()) return std::optional<ModelInfo>();
                       const auto row = readRow(statement, kModels);
                       return row ? modelOf(*row) : std::nullopt;
                   }));
        if (!found || found->key.digest() != info.key.digest())
            return errorOf(Trouble::modelGone, state_.blobs.folder());
        MACULA_TRY(blob, state_.blobs.read(found->checksum, found->bytes));
    }
    if (!blob.fault) return LoadedModel{std::move(*found), std::move(blob.bytes)};
    MACULA_TRY_VOID(setModelAside(state_, found->id, found->checksum, nameOf(*blob.fault)));
    return modelDamaged(state_);
}

Result<std::filesystem::path> StoreModels::fileOf(const ModelInfo& info) const {
    std::filesystem::path file = state_.blobs.fileOf(info.checksum);
    struct stat status {};
    if (lstat(file.c_str(), &status) == 0) return file;
    return errorOf(errno == ENOENT ? Trouble::modelGone : troubleOfErrno(errno), state_.blobs.folder());
}

Result<void> StoreModels::setAside(const ModelInfo& info, std::string_view why) {
    MACULA_CHECK(isAsideWord(why));
    return setModelAside(state_, info.id, info.checksum, why);
}

Result<Listing<ModelInfo>> StoreModels::list(const std::string& volume) {
    MACULA_CHECK(volume.empty() || isDigest(volume));
    Connection& connection = *state_.connection;
    return guarded(connection, [&]() -> Result<Listing<ModelInfo>> {
        Listing<ModelInfo> listing;
        SQLite::Statement statement =
            select(connection, kModels,
                   std::string(volume.empty() ? "" : "WHERE t.volume = ? ") + "ORDER BY t.used DESC");
        if (!volume.empty()) statement.bind(1, volume);
        while (statement.executeStep()) {
            const auto row = readRow(statement, kModels);
            auto info = row ? modelOf(*row) : std::nullopt;
            if (info && (volume.empty() || info->key.volume == volume)) {
                listing.entries.push_back(std::move(*info));
            } else {
                ++listing.damaged;
            }
        }
        return listing;
    });
}

Result<void> StoreModels::touch(const ModelKey& key) {
    MACULA_CHECK(key.isValid());
    Connection& connection = *state_.connection;
    return inTransaction(connection, [&]() -> Result<void> {
        Found found = findByKey(connection, key.digest());
        if (!found.info) return {};
        found.info->usedMs = nextUse(state_);
        putRow(connection, kModels, rowOf(*found.info));
        return {};
    });
}

Result<EvictionReport> StoreModels::evict(std::uint64_t capBytes) {
    MACULA_TRY(Evicted evicted, inTransaction(*state_.connection, [&]() -> Result<Evicted> {
                   return evictRows(state_, capBytes, 0);
               }));
    static_cast<void>(removeBlobs(state_, evicted.blobs, BlobFiles::Removal::plain, {}));
    return evicted.report;
}

struct OpenMark::Held {
    std::shared_ptr<LockFile> locks;
    off_t byte = 0;
};

OpenMark::OpenMark(std::unique_ptr<Held> held) : held_(std::move(held)) {}
OpenMark::OpenMark(OpenMark&&) noexcept = default;
OpenMark::~OpenMark() {
    if (held_) held_->locks->removeMark(held_->byte);
}

Result<OpenMark> StoreModels::markOpen(const ModelKey& key) {
    MACULA_CHECK(key.isValid());
    const off_t byte = LockFile::byteOf(key.digest());
    MACULA_TRY_VOID(state_.locks->addMark(byte));
    OpenMark mark(std::unique_ptr<OpenMark::Held>(new OpenMark::Held{state_.locks, byte}));
    // A process that is evicting right now may have looked for marks before this one was set: the empty
    // transaction waits until it has finished.
    MACULA_TRY_VOID(inTransaction(*state_.connection, [] { return Result<void>(); }));
    return Result<OpenMark>(std::move(mark));
}

}  // namespace macula::session
