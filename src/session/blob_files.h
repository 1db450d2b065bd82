// Blobs of models: files next to the database, named by the SHA-256 of their content. A file is written three
// to five times as fast as a database row and read as fast (docs/measurements), its beginning can be read
// alone, and the content of a damaged file no longer matches its name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/draft.h"
#include "base/result.h"

namespace macula::session {

enum class BlobFault { missing, wrongSize, wrongChecksum };
std::string_view nameOf(BlobFault fault);  // "missing", "size", "checksum": as the column `aside` stores it

struct ReadBlob {
    std::vector<std::byte> bytes;
    std::optional<BlobFault> fault;  // if set, `bytes` is empty
};

class BlobFiles {
  public:
    // Creates the folder (0700) if it is missing.
    static Result<BlobFiles> open(const std::filesystem::path& folder);

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path fileOf(std::string_view digest) const;

    // A blob on the disk under a temporary name; deleted unless it is put in place.
    struct Prepared {
        std::string digest;
        Draft draft;
    };
    Result<Prepared> prepare(std::span<const std::byte> bytes) const;
    // Prepares a copy of another folder's blob, in pieces to save memory. Nothing if that blob is missing or
    // has another size or digest. Fails if a disk cannot read or write.
    Result<std::optional<Prepared>> prepareCopy(const BlobFiles& from, std::string_view digest,
                                                std::uint64_t bytes) const;
    // Gives the complete file its final name.
    Result<void> putInPlace(const Prepared& prepared) const;

    // The content of the file, if its size and digest are right. Fails if the disk cannot read it.
    Result<ReadBlob> read(std::string_view digest, std::uint64_t bytes) const;

    // `overwritten`: overwrites before removing; a file system that writes in place then keeps nothing.
    enum class Removal { plain, overwritten };
    Result<void> remove(std::string_view digest, Removal removal) const;

    struct Entry {
        std::string digest;
        std::uint64_t bytes = 0;
    };
    Result<std::vector<Entry>> list() const;

  private:
    explicit BlobFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;
};

// Creates a folder (0700) with its parents; an existing one keeps its mode.
Result<void> makePrivateFolder(const std::filesystem::path& folder);

// Overwrites a file and removes it; a missing file is no error. A file with a second name (hard link) is only
// removed: its content belongs to that name as well.
Result<void> eraseFile(const std::filesystem::path& file);

// Waits until a file or folder has been written to the disk.
Result<void> syncToDisk(const std::filesystem::path& path);

}  // namespace macula::session
