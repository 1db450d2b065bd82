// Goes through the entries of an archive, from its beginning to its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

struct archive;
struct archive_entry;

namespace macula::unpack {

struct ArchiveEntry {
    enum class Kind {
        file,
        secondName,  // of a file before it: a hard link
        folder,
        other,  // a symbolic link, a device, a pipe
    };
    Kind kind = Kind::other;
    std::string name;         // as the archive says it, mostly UTF-8; hostile; empty: unknown
    std::string nameOfFirst;  // of a secondName
    bool isEncrypted = false;
};

// Wraps libarchive with only those formats and compressions that archive_name.h names; it starts no other
// program.
class ArchiveReader {
  public:
    explicit ArchiveReader(const std::filesystem::path& file);
    ArchiveReader(const ArchiveReader&) = delete;
    ArchiveReader& operator=(const ArchiveReader&) = delete;
    ~ArchiveReader();

    enum class Step {
        entry,
        end,
        broken,  // nothing more can be read
    };
    Step next(ArchiveEntry& entry);

    // Reads on in the file of the last entry. 0 bytes: its end. Nothing: the file cannot be read, because it
    // is damaged, encrypted or packed in an unknown way; the archive may go on.
    std::optional<std::size_t> read(std::span<std::byte> into);

    // Where in the archive reading is.
    std::uint64_t positionBytes() const;

  private:
    struct Closes {
        void operator()(archive* opened) const;
    };
    std::unique_ptr<archive, Closes> archive_;
    bool isBroken_ = false;
};

}  // namespace macula::unpack
