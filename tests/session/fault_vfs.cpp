#include "session/fault_vfs.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "session/support.h"

namespace macula::session::test {

namespace {

namespace fs = std::filesystem;

struct State {
    Fault fault = Fault::none;
    int at = 0;
    int count = 0;
    bool hasFailed = false;
    std::uint32_t seed = 0;
    std::map<std::string, std::string> synced;  // what of each file is on the disk for certain
};

State& state() {
    static State all;
    return all;
}

struct File {
    sqlite3_file base;
    std::string* name;
    sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

File* fileOf(sqlite3_file* file) {
    return reinterpret_cast<File*>(file);
}
sqlite3_vfs* realVfs() {
    return sqlite3_vfs_find(nullptr);
}

bool isDead() {
    return state().hasFailed && state().fault == Fault::powerCut;
}

// True for the operation that fails now; all after a power cut do.
bool failsNow() {
    State& s = state();
    if (isDead()) return true;
    if (s.fault == Fault::none || ++s.count < s.at) return false;
    const bool isLasting = s.fault == Fault::diskFull || s.fault == Fault::tornWrite;
    const bool isNow = s.count == s.at || isLasting;
    s.hasFailed = s.hasFailed || isNow;
    return isNow;
}

// A truncation or a sync: those of a full disk go well.
bool failsHere() {
    return state().fault != Fault::readError && failsNow() && state().fault != Fault::diskFull;
}

int closeFile(sqlite3_file* file) {
    const int result = fileOf(file)->real()->pMethods->xClose(fileOf(file)->real());
    delete fileOf(file)->name;
    return result;
}

int readFile(sqlite3_file* file, void* to, int count, sqlite3_int64 at) {
    if (isDead()) return SQLITE_IOERR_READ;
    if (state().fault == Fault::readError && failsNow()) return SQLITE_IOERR_READ;
    return fileOf(file)->real()->pMethods->xRead(fileOf(file)->real(), to, count, at);
}

int writeFile(sqlite3_file* file, const void* from, int count, sqlite3_int64 at) {
    const auto write = [&](int bytes) {
        return fileOf(file)->real()->pMethods->xWrite(fileOf(file)->real(), from, bytes, at);
    };
    if (isDead()) return SQLITE_IOERR_WRITE;
    const bool wasTorn = state().hasFailed;
    if (state().fault == Fault::readError || !failsNow()) return write(count);
    switch (state().fault) {
        case Fault::shortWrite:
            write(count / 2);
            return SQLITE_FULL;
        case Fault::diskFull:
            return SQLITE_FULL;
        case Fault::tornWrite:
        case Fault::powerCut:
            if (!wasTorn) write(count / 2);
            return SQLITE_IOERR_WRITE;
        default:
            return SQLITE_IOERR_WRITE;
    }
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size) {
    if (failsHere()) return SQLITE_IOERR_TRUNCATE;
    return fileOf(file)->real()->pMethods->xTruncate(fileOf(file)->real(), size);
}

int syncFile(sqlite3_file* file, int flags) {
    if (failsHere()) return SQLITE_IOERR_FSYNC;
    const int result = fileOf(file)->real()->pMethods->xSync(fileOf(file)->real(), flags);
    if (state().fault == Fault::powerCut) state().synced[*fileOf(file)->name] = textOf(*fileOf(file)->name);
    return result;
}

int sizeOfFile(sqlite3_file* file, sqlite3_int64* size) {
    return fileOf(file)->real()->pMethods->xFileSize(fileOf(file)->real(), size);
}
int lockFile(sqlite3_file* file, int lock) {
    if (isDead()) return SQLITE_IOERR_LOCK;
    return fileOf(file)->real()->pMethods->xLock(fileOf(file)->real(), lock);
}
int unlockFile(sqlite3_file* file, int lock) {
    return fileOf(file)->real()->pMethods->xUnlock(fileOf(file)->real(), lock);
}
int checkLock(sqlite3_file* file, int* result) {
    return fileOf(file)->real()->pMethods->xCheckReservedLock(fileOf(file)->real(), result);
}
int controlFile(sqlite3_file* file, int operation, void* argument) {
    return fileOf(file)->real()->pMethods->xFileControl(fileOf(file)->real(), operation, argument);
}
int sectorSize(sqlite3_file* file) {
    return fileOf(file)->real()->pMethods->xSectorSize(fileOf(file)->real());
}
int characteristics(sqlite3_file* file) {
    return fileOf(file)->real()->pMethods->xDeviceCharacteristics(fileOf(file)->real());
}

// Version 1: without shared memory, which a rollback journal does not need.
constexpr sqlite3_io_methods kMethods{
    .iVersion = 1,
    .xClose = closeFile,
    .xRead = readFile,
    .xWrite = writeFile,
    .xTruncate = truncateFile,
    .xSync = syncFile,
    .xFileSize = sizeOfFile,
    .xLock = lockFile,
    .xUnlock = unlockFile,
    .xCheckReservedLock = checkLock,
    .xFileControl = controlFile,
    .xSectorSize = sectorSize,
    .xDeviceCharacteristics = characteristics,
};

int openFile(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* outFlags) {
    File* const mine = fileOf(file);
    mine->base.pMethods = nullptr;
    if (isDead()) return SQLITE_CANTOPEN;
    const std::string path = name == nullptr ? "" : name;
    const bool wasThere = fs::exists(path);
    const int result = realVfs()->xOpen(realVfs(), name, mine->real(), flags, outFlags);
    if (result != SQLITE_OK) return result;
    if (state().fault == Fault::powerCut && !path.empty() && !state().synced.contains(path))
        state().synced[path] = wasThere ? textOf(path) : "";
    mine->name = new std::string(path);
    mine->base.pMethods = &kMethods;
    return SQLITE_OK;
}

int removeFile(sqlite3_vfs*, const char* name, int sync) {
    if (isDead()) return SQLITE_IOERR_DELETE;
    state().synced.erase(name);
    return realVfs()->xDelete(realVfs(), name, sync);
}

// Registered before the first test.
const bool kIsRegistered = [] {
    static sqlite3_vfs vfs = *realVfs();
    vfs.szOsFile += static_cast<int>(sizeof(File));
    vfs.zName = kFaultVfs;
    vfs.pNext = nullptr;
    vfs.xOpen = openFile;
    vfs.xDelete = removeFile;
    return sqlite3_vfs_register(&vfs, 0) == SQLITE_OK;
}();

}  // namespace

void setFault(Fault fault, int at, std::uint32_t seed) {
    state() = {.fault = fault, .at = at, .seed = seed};
}

int operationCount() {
    return state().count;
}

bool hasFailed() {
    return state().hasFailed;
}

void loseUnsynced() {
    constexpr std::size_t kSector = 512;
    std::mt19937 random(state().seed);
    const auto below = [&](std::size_t n) { return random() % n; };
    for (const auto& [path, synced] : state().synced) {
        if (!fs::exists(path)) continue;
        const std::string written = textOf(path);
        if (written == synced) continue;
        std::string left(below(2) == 0 ? written.size() : synced.size(), '\0');
        for (std::size_t at = 0; at < left.size(); at += kSector) {
            const std::size_t size = std::min(kSector, left.size() - at);
            const std::size_t split = below(3) == 0 ? below(size + 1) : size * below(2);
            for (std::size_t i = at; i < at + size; ++i) {
                // A file that was cut short was so or was not: it holds what it held, and no garbage. Where
                // it grew, anything may be.
                const bool isNew = i < at + split && i < written.size();
                const std::string& from = isNew ? written : synced;
                left[i] = i < from.size() ? from[i] : static_cast<char>(random());
            }
        }
        putText(path, left);
    }
    state() = {};
}

}  // namespace macula::session::test
