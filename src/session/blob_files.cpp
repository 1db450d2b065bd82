#include "session/blob_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/sha256.h"
#include "session/model_key.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kEnding = ".model";

class Descriptor {
  public:
    Descriptor(const fs::path& path, int flags)
        : number_(open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC)) {}
    ~Descriptor() {
        if (number_ >= 0) close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int operator*() const { return number_; }
    bool isOpen() const { return number_ >= 0; }

  private:
    int number_;
};

bool writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

// False at the end of the file, with errno 0, or on an error, with its errno.
bool readAll(int file, std::span<std::byte> bytes) {
    errno = 0;
    while (!bytes.empty()) {
        const ssize_t count = read(file, bytes.data(), bytes.size());
        if (count == 0 || (count < 0 && errno != EINTR)) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

bool overwrite(int file) {
    struct stat status {};
    if (fstat(file, &status) != 0) return false;
    const std::vector<std::byte> zeros(std::size_t{1} << 20);
    for (off_t left = status.st_size; left > 0;) {
        const auto count = std::min<off_t>(left, static_cast<off_t>(zeros.size()));
        if (!writeAll(file, std::span(zeros).first(static_cast<std::size_t>(count)))) return false;
        left -= count;
    }
    return fsync(file) == 0;
}

}  // namespace

std::string_view nameOf(BlobFault fault) {
    switch (fault) {
        case BlobFault::missing:
            return "missing";
        case BlobFault::wrongSize:
            return "size";
        case BlobFault::wrongChecksum:
            return "checksum";
    }
    return {};
}

Result<void> makePrivateFolder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return {};
    if (folder.has_parent_path() && folder.parent_path() != folder)
        MACULA_TRY_VOID(makePrivateFolder(folder.parent_path()));
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return errorOf(troubleOfErrno(errno), folder);
    if (!fs::is_directory(folder, error)) return errorOf(Trouble::notOurs, folder);
    return {};
}

Result<void> syncToDisk(const fs::path& path) {
    const Descriptor file(path, O_RDONLY);
    if (!file.isOpen()) return errorOf(troubleOfErrno(errno), path);
    // EINVAL: a file system that cannot synchronise files.
    if (fsync(*file) != 0 && errno != EINVAL) return errorOf(troubleOfErrno(errno), path);
    return {};
}

Result<void> eraseFile(const fs::path& file) {
    struct stat status {};
    if (lstat(file.c_str(), &status) != 0) {
        if (errno == ENOENT) return {};
        return errorOf(troubleOfErrno(errno), file);
    }
    if (S_ISREG(status.st_mode) && status.st_nlink == 1) {
        const Descriptor bytes(file, O_WRONLY);
        if (!bytes.isOpen() || !overwrite(*bytes)) return errorOf(troubleOfErrno(errno), file);
    }
    if (unlink(file.c_str()) != 0 && errno != ENOENT) return errorOf(troubleOfErrno(errno), file);
    return {};
}

Result<BlobFiles> BlobFiles::open(const fs::path& folder) {
    MACULA_TRY_VOID(makePrivateFolder(folder));
    return BlobFiles(folder);
}

fs::path BlobFiles::fileOf(std::string_view digest) const {
    MACULA_CHECK(isDigest(digest));
    return folder_ / (std::string(digest) + std::string(kEnding));
}

Result<BlobFiles::Prepared> BlobFiles::prepare(std::span<const std::byte> bytes) const {
    const std::string digest = sha256Hex(bytes);
    auto draft = Draft::beside(fileOf(digest), Draft::Kind::file);
    if (!draft) return errorOf(troubleOfErrno(errno), folder_);
    const Descriptor file(draft->path(), O_WRONLY);
    // Sets the mode before any content is written.
    if (!file.isOpen() || (fchmod(*file, 0600) != 0 && errno != EPERM) || !writeAll(*file, bytes) ||
        fsync(*file) != 0)
        return errorOf(troubleOfErrno(errno), folder_);
    return Prepared{digest, std::move(draft).value()};
}

Result<std::optional<BlobFiles::Prepared>> BlobFiles::prepareCopy(const BlobFiles& from,
                                                                  std::string_view digest,
                                                                  std::uint64_t bytes) const {
    using Copied = std::optional<Prepared>;
    const fs::path source = from.fileOf(digest);
    const Descriptor in(source, O_RDONLY);
    if (!in.isOpen() && errno == ENOENT) return Copied();
    if (!in.isOpen()) return errorOf(troubleOfErrno(errno), source);
    struct stat status {};
    if (fstat(*in, &status) != 0) return errorOf(Trouble::diskError, source);
    if (!S_ISREG(status.st_mode) || static_cast<std::uint64_t>(status.st_size) != bytes) return Copied();
    auto draft = Draft::beside(fileOf(digest), Draft::Kind::file);
    if (!draft) return errorOf(troubleOfErrno(errno), folder_);
    const Descriptor out(draft->path(), O_WRONLY);
    if (!out.isOpen() || (fchmod(*out, 0600) != 0 && errno != EPERM))
        return errorOf(troubleOfErrno(errno), folder_);
    Sha256 hash;
    std::vector<std::byte> piece(std::size_t{1} << 20);
    for (std::uint64_t left = bytes; left > 0;) {
        const auto part =
            std::span(piece).first(static_cast<std::size_t>(std::min<std::uint64_t>(left, piece.size())));
        if (!readAll(*in, part)) {
            if (errno != 0) return errorOf(Trouble::diskError, source);
            return Copied();
        }
        hash.add(part);
        if (!writeAll(*out, part)) return errorOf(troubleOfErrno(errno), folder_);
        left -= part.size();
    }
    if (fsync(*out) != 0) return errorOf(troubleOfErrno(errno), folder_);
    if (hash.hex() != digest) return Copied();
    return Copied(Prepared{std::string(digest), std::move(draft).value()});
}

Result<void> BlobFiles::putInPlace(const Prepared& prepared) const {
    errno = 0;
    if (!macula::putInPlace(prepared.draft.path(), fileOf(prepared.digest)))
        return errorOf(troubleOfErrno(errno), folder_);
    return {};
}

Result<ReadBlob> BlobFiles::read(std::string_view digest, std::uint64_t bytes) const {
    const Descriptor file(fileOf(digest), O_RDONLY);
    struct stat status {};
    if (!file.isOpen()) {
        if (errno == ENOENT) return ReadBlob{{}, BlobFault::missing};
        return errorOf(troubleOfErrno(errno), fileOf(digest));
    }
    if (fstat(*file, &status) != 0) return errorOf(Trouble::diskError, fileOf(digest));
    if (!S_ISREG(status.st_mode) || static_cast<std::uint64_t>(status.st_size) != bytes)
        return ReadBlob{{}, BlobFault::wrongSize};
    ReadBlob blob;
    try {
        blob.bytes.resize(bytes);
    } catch (const std::exception&) {
        return errorOf(Trouble::noMemory, fileOf(digest));
    }
    if (!readAll(*file, blob.bytes)) {
        if (errno != 0) return errorOf(Trouble::diskError, fileOf(digest));
        return ReadBlob{{}, BlobFault::wrongSize};
    }
    if (sha256Hex(blob.bytes) != digest) return ReadBlob{{}, BlobFault::wrongChecksum};
    return blob;
}

Result<void> BlobFiles::remove(std::string_view digest, Removal removal) const {
    const fs::path path = fileOf(digest);
    if (removal == Removal::overwritten) return eraseFile(path);
    if (unlink(path.c_str()) != 0 && errno != ENOENT) return errorOf(troubleOfErrno(errno), path);
    return {};
}

Result<std::vector<BlobFiles::Entry>> BlobFiles::list() const {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
        std::string name = entry->path().filename().string();
        if (!name.ends_with(kEnding)) continue;
        name.resize(name.size() - kEnding.size());
        std::error_code unreadable;
        if (isDigest(name)) entries.push_back({name, entry->file_size(unreadable)});
    }
    if (error) return errorOf(troubleOfErrno(error.value()), folder_);
    return entries;
}

}  // namespace macula::session
