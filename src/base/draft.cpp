#include "base/draft.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "base/utf8.h"

namespace macula {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigits = 16;
constexpr std::string_view kPart = ".part";

Error notWritable(const fs::path& path, int reason) {
    return {ErrorCode::outputNotWritable, Text("The file could not be written: {}.", std::strerror(reason)),
            path.string(), Text("Check free space and permissions.")};
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Result<std::string> randomDigits() {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number)
        return Error{
            ErrorCode::outputNotWritable, Text("The system has no random numbers."), {}, Text("Try again.")};
    return fmt::format("{:016x}", number);
}

constexpr std::size_t kMostOfName = 180;  // bytes; file systems allow 255 for the whole name

std::string nameOfDraft(const fs::path& target, const std::string& digits, Draft::Kind kind) {
    return fmt::format(".{}.{}{}{}", startOf(target.stem().native(), kMostOfName), digits, kPart,
                       kind == Draft::Kind::file ? target.extension().string() : "");
}

bool isNameOfDraft(std::string_view name) {
    const std::size_t part = name.rfind(kPart);
    if (!name.starts_with('.') || part == std::string_view::npos || part < kDigits + 2) return false;
    const std::string_view rest = name.substr(part + kPart.size());
    const std::string_view digits = name.substr(part - kDigits, kDigits);
    return (rest.empty() || rest.starts_with('.')) && name[part - kDigits - 1] == '.' &&
           digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

// Creates the draft, open and locked. Returns -1 with errno if it cannot: EEXIST if the name is taken.
int make(const fs::path& path, Draft::Kind kind) {
    if (kind == Draft::Kind::folder && mkdir(path.c_str(), 0777) != 0) return -1;
    const int flags = kind == Draft::Kind::folder ? O_RDONLY | O_DIRECTORY : O_WRONLY | O_CREAT | O_EXCL;
    const int descriptor = open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) return -1;
    // A failed lock is not an error: on a file system without locks, removeAbandonedDrafts cannot lock
    // either.
    flock(descriptor, LOCK_EX | LOCK_NB);
    struct stat mine {};
    struct stat there {};
    if (fstat(descriptor, &mine) == 0 && lstat(path.c_str(), &there) == 0 && mine.st_ino == there.st_ino)
        return descriptor;
    close(descriptor);
    errno = EEXIST;  // removeAbandonedDrafts removed it before it was locked; another name is tried
    return -1;
}

}  // namespace

Result<Draft> Draft::beside(const fs::path& target, Kind kind) {
    const fs::path folder = folderOf(target);
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
        return Error{ErrorCode::outputNotWritable, Text("The folder to write into does not exist."),
                     folder.string(), Text("Create it, or choose another place.")};
    }
    for (int attempt = 0;; ++attempt) {
        MACULA_TRY(const std::string digits, randomDigits());
        const std::string name = nameOfDraft(target, digits, kind);
        const int descriptor = make(folder / name, kind);
        if (descriptor >= 0) return Draft(folder / name, descriptor);
        if (errno != EEXIST || attempt >= 8) return notWritable(target, errno);
    }
}

Result<Draft> Draft::of(const fs::path& folder) {
    MACULA_TRY(const std::string digits, randomDigits());
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return notWritable(folder, errno);
    flock(descriptor, LOCK_EX | LOCK_NB);
    const fs::path hidden = folderOf(folder) / nameOfDraft(folder, digits, Kind::folder);
    if (rename(folder.c_str(), hidden.c_str()) != 0) {
        const int reason = errno;
        close(descriptor);
        return notWritable(folder, reason);
    }
    return Draft(hidden, descriptor);
}

Draft::Draft(Draft&& other) noexcept
    : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}

Draft::~Draft() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (descriptor_ >= 0) close(descriptor_);
}

Result<void> putInPlace(const fs::path& written, const fs::path& target) {
    struct stat there {};
    const bool replaces = stat(target.c_str(), &there) == 0;
    if (replaces && !S_ISREG(there.st_mode)) {
        return Error{ErrorCode::outputNotWritable, Text("What stands there is no file."), target.string(),
                     Text("Choose another name.")};
    }
    const int descriptor = open(written.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return notWritable(target, errno);
    if (replaces) static_cast<void>(fchmod(descriptor, there.st_mode & 0777u));
    const int synced = fsync(descriptor) == 0 ? 0 : errno;
    close(descriptor);
    // EINVAL: a file system that cannot synchronise files.
    if (synced != 0 && synced != EINVAL) return notWritable(target, synced);
    if (rename(written.c_str(), target.c_str()) != 0) return notWritable(target, errno);
    if (const int folder = open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
        static_cast<void>(fsync(folder));  // best effort: the new name is in place even if this fails
        close(folder);
    }
    return {};
}

void removeAbandonedDrafts(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (!isNameOfDraft(path.filename().string())) continue;
        const int descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) continue;
        struct stat status {};
        const bool isOurs = fstat(descriptor, &status) == 0 && status.st_uid == geteuid() &&
                            (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
        std::error_code ignored;
        if (isOurs && flock(descriptor, LOCK_EX | LOCK_NB) == 0) fs::remove_all(path, ignored);
        close(descriptor);
    }
}

}  // namespace macula
