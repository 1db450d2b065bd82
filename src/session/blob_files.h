// Blobs of models: files beside the database, named by the SHA-256 of what they hold. A file is written three
// to five times as fast as a row of the database and read as fast (docs/measurements), its
// beginning can be read alone, and a blob that was changed does not fit its name any more.
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
std::string_view nameOf(BlobFault fault);  // "missing", "size", "checksum": what the column aside holds

struct ReadBlob {
    std::vector<std::byte> bytes;
    std::optional<BlobFault> fault;  // then there are no bytes
};

class BlobFiles {
  public:
    // The folder is made (0700) where it is missing.
    static Result<BlobFiles> open(const std::filesystem::path& folder);

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path fileOf(std::string_view digest) const;

    // A blob on the disk without its name; gone unless it is put in place.
    struct Prepared {
        std::string digest;
        Draft draft;
    };
    Result<Prepared> prepare(std::span<const std::byte> bytes) const;
    // Of a blob of another folder, a piece at a time: no more of it is in memory. Nothing where it has
    // another size or digest there, or is missing. Fails when a disk does not read or write.
    Result<std::optional<Prepared>> prepareCopy(const BlobFiles& from, std::string_view digest,
                                                std::uint64_t bytes) const;
    // From here on the file has its name: on the disk, whole.
    Result<void> putInPlace(const Prepared& prepared) const;

    // What the file holds, when it has that size and that digest. Fails when the disk does not read it.
    Result<ReadBlob> read(std::string_view digest, std::uint64_t bytes) const;

    // Overwritten before it is removed, so that a file system that writes in place keeps nothing.
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

// Makes a folder (0700) with its parents; one that is there keeps its mode.
Result<void> makePrivateFolder(const std::filesystem::path& folder);

// Overwrites a file and removes it; one that is not there is no error. A file that has a second name is only
// removed: what it holds belongs to that name as well.
Result<void> eraseFile(const std::filesystem::path& file);

// Waits until a file or folder is on the disk.
Result<void> syncToDisk(const std::filesystem::path& path);

}  // namespace macula::session
