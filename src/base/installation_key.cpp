#include "base/installation_key.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/draft.h"
#include "base/sha256.h"

namespace macula {

namespace fs = std::filesystem;

namespace {

constexpr const char* kName = "installation.key";

Error notKept(const fs::path& file) {
    return {ErrorCode::outputNotWritable,
            Text("The key that makes identifiers unreadable for others could not be kept."), file.string(),
            Text("Check free space and permissions of that folder.")};
}

Result<void> makePrivate(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return {};
    fs::create_directories(folder.parent_path(), error);
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return notKept(folder);
    return {};
}

}  // namespace

Result<std::optional<InstallationKey>> InstallationKey::read(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0 && errno == ENOENT) return std::optional<InstallationKey>();
    struct stat status {};
    Bytes bytes{};
    const bool isRead = descriptor >= 0 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                        status.st_size == static_cast<off_t>(bytes.size()) &&
                        ::read(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    if (isRead && (status.st_mode & 077u) != 0) static_cast<void>(fchmod(descriptor, 0600));
    if (descriptor >= 0) close(descriptor);
    if (!isRead)
        return Error{
            ErrorCode::inputNotUsable,
            Text("The file with the key that makes identifiers unreadable for others cannot be read, or "
                 "holds none."),
            file.string(), Text("Bring it back from a backup, or remove it: then a new one is made.")};
    return std::optional(InstallationKey(bytes));
}

std::optional<InstallationKey> InstallationKey::find(const fs::path& folder) {
    auto key = read(folder / kName);
    return key ? *std::move(key) : std::nullopt;
}

Result<InstallationKey> InstallationKey::ofUser(const fs::path& folder) {
    const fs::path file = folder / kName;
    MACULA_TRY(auto before, read(file));
    if (before) return *before;
    MACULA_TRY_VOID(makePrivate(folder));
    Bytes bytes{};
    if (getentropy(bytes.data(), bytes.size()) != 0) return notKept(file);
    auto draft = Draft::beside(file, Draft::Kind::file);
    if (!draft) return notKept(file);
    const int descriptor = open(draft->path().c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
    const bool isWritten =
        descriptor >= 0 && (fchmod(descriptor, 0600) == 0 || errno == EPERM) &&
        write(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()) &&
        fsync(descriptor) == 0;
    if (descriptor >= 0) close(descriptor);
    if (!isWritten) return notKept(file);
    // Never replaces a key that another program has made meanwhile, and may be using already.
    if (link(draft->path().c_str(), file.c_str()) != 0 && errno != EEXIST) {
        std::error_code error;
        if (fs::exists(file, error) || rename(draft->path().c_str(), file.c_str()) != 0)
            return notKept(file);  // rename serves file systems without hard links
    }
    MACULA_TRY(auto made, read(file));
    if (!made) return notKept(file);
    return *made;
}

std::string InstallationKey::digestOf(std::string_view text) const {
    return hmacSha256Hex(bytes_, text);
}

}  // namespace macula
