#include "session/damaged_file.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fstream>
#include <set>
#include <string>

#include "base/draft.h"
#include "session/database_pages.h"
#include "session/migrations.h"
#include "session/store_state.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

Result<fs::path> newFolder(const fs::path& parent) {
    MACULA_TRY_VOID(makePrivateFolder(parent));
    const std::string stamp = fmt::format("{:%Y%m%dT%H%M%SZ}", fmt::gmtime(std::time(nullptr)));
    for (int attempt = 1;; ++attempt) {
        const fs::path folder = parent / (attempt == 1 ? stamp : fmt::format("{}-{}", stamp, attempt));
        if (mkdir(folder.c_str(), 0700) == 0) return folder;
        if (errno != EEXIST || attempt > 1000) return errorOf(troubleOfErrno(errno), parent);
    }
}

Result<std::vector<std::byte>> bytesOf(const fs::path& file) {
    constexpr std::uintmax_t kMost = std::uintmax_t{2} << 30;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) return errorOf(troubleOfErrno(error.value()), file);
    try {
        std::vector<std::byte> bytes(std::min(size, kMost));
        const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
        if (descriptor < 0) return errorOf(troubleOfErrno(errno), file);
        // Blocks that the disk cannot read stay zero.
        constexpr std::size_t kBlock = 4096;
        for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
            const std::size_t count = std::min(kBlock, bytes.size() - at);
            static_cast<void>(!pread(descriptor, bytes.data() + at, count, static_cast<off_t>(at)));
        }
        close(descriptor);
        return bytes;
    } catch (const std::bad_alloc&) {
        return errorOf(Trouble::noMemory, file);
    }
}

// Makes a fresh database with all rows that were found, parents first.
Result<SetAside> rebuild(const fs::path& fresh, const fs::path& damaged, std::chrono::milliseconds patience) {
    MACULA_TRY(const std::vector<std::byte> bytes, bytesOf(damaged));
    const std::vector<FoundRow> found = rowsInPages(bytes);
    MACULA_TRY(const auto connection, connect(fresh, {.patience = patience}));
    MACULA_TRY_VOID(migrate(*connection));
    return inTransaction(*connection, [&]() -> Result<SetAside> {
        SetAside result;
        for (const Table* table : allTables()) {
            std::set<std::vector<Value>> seen;
            for (const FoundRow& row : found)
                if (row.table == table && seen.insert(row.row.values).second)
                    mergeRow(*connection, *table, row.row);
            result.rowsRescued += static_cast<std::size_t>(
                numberOf(*connection, "SELECT count(*) FROM " + std::string(table->name)));
        }
        result.modelsRescued = static_cast<std::size_t>(numberOf(*connection, "SELECT count(*) FROM models"));
        result.documentsRescued =
            static_cast<std::size_t>(numberOf(*connection, "SELECT count(*) FROM documents"));
        return result;
    });
}

Result<void> move(const fs::path& from, const fs::path& to) {
    if (rename(from.c_str(), to.c_str()) != 0 && errno != ENOENT) return errorOf(troubleOfErrno(errno), from);
    return {};
}

// Keeps the file under a second name too (hard link), or as a copy on a file system without hard links.
Result<void> keepAs(const fs::path& file, const fs::path& name) {
    if (link(file.c_str(), name.c_str()) == 0) return {};
    std::error_code error;
    fs::copy_file(file, name, error);
    if (error) return errorOf(troubleOfErrno(error.value()), name);
    return syncToDisk(name);
}

Result<std::set<std::string>> namedBlobs(const fs::path& database, std::chrono::milliseconds patience) {
    MACULA_TRY(const auto connection, connect(database, {.patience = patience}));
    return guarded(*connection, [&]() -> Result<std::set<std::string>> {
        std::set<std::string> named;
        SQLite::Statement models = select(*connection, kModels, "");
        while (models.executeStep())
            if (const auto row = readRow(models, kModels)) named.insert(row->text(column::modelBlob));
        return named;
    });
}

Result<void> moveOrphans(const BlobFiles& blobs, const fs::path& database, const fs::path& folder,
                         std::chrono::milliseconds patience) {
    MACULA_TRY(const std::set<std::string> named, namedBlobs(database, patience));
    MACULA_TRY(const auto entries, blobs.list());
    for (const BlobFiles::Entry& entry : entries) {
        if (named.contains(entry.digest)) continue;
        MACULA_TRY_VOID(makePrivateFolder(folder));
        const fs::path file = blobs.fileOf(entry.digest);
        MACULA_TRY_VOID(move(file, folder / file.filename()));
    }
    return {};
}

}  // namespace

// Format: sqlite.org/fileformat2.html, section 1.3.
bool isOfNewerVersion(const fs::path& database) {
    std::string header(100, '\0');
    std::ifstream stream(database, std::ios::binary);
    if (!stream.read(header.data(), static_cast<std::streamsize>(header.size()))) return false;
    const auto numberAt = [&](std::size_t place) {
        std::uint32_t number = 0;
        for (std::size_t i = place; i < place + 4; ++i)
            number = number << 8 | static_cast<unsigned char>(header[i]);
        return static_cast<std::int32_t>(number);
    };
    return header.starts_with("SQLite format 3") && numberAt(68) == kApplicationId &&
           numberAt(60) > newestVersion();
}

Result<SetAside> setAsideAndRescue(const fs::path& database, const BlobFiles& blobs,
                                   std::chrono::milliseconds patience) {
    const fs::path store = database.parent_path();
    MACULA_TRY(const Draft fresh, Draft::beside(database, Draft::Kind::file));
    MACULA_TRY(SetAside result, rebuild(fresh.path(), database, patience));
    MACULA_TRY(const fs::path folder, newFolder(store / kDamagedName));
    result.folder = folder;
    std::error_code ignored;
    fs::remove(fresh.path().string() + "-journal", ignored);
    MACULA_TRY_VOID(syncToDisk(fresh.path()));
    // The journal is moved first: next to a fresh database, SQLite would roll it back into that one.
    MACULA_TRY_VOID(keepAs(database, folder / kDatabaseName));
    for (const char* part : {"-journal", "-wal", "-shm"})
        MACULA_TRY_VOID(move(database.string() + part, folder / (std::string(kDatabaseName) + part)));
    MACULA_TRY_VOID(syncToDisk(folder));
    MACULA_TRY_VOID(move(fresh.path(), database));
    MACULA_TRY_VOID(syncToDisk(store));
    MACULA_TRY_VOID(moveOrphans(blobs, database, folder / kModelsName, patience));
    return result;
}

}  // namespace macula::session
