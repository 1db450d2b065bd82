#include "unpack/archive_reader.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <new>

namespace macula::unpack {

namespace {

constexpr std::size_t kBlockBytes = 256 * 1024;
constexpr int kMostTries = 1000;  // one after another

std::string nameOf(const char* inUtf8, const char* asItIs) {
    return inUtf8 != nullptr ? inUtf8 : asItIs != nullptr ? asItIs : "";
}

ArchiveEntry::Kind kindOf(archive_entry* entry) {
    if (archive_entry_hardlink(entry) != nullptr || archive_entry_hardlink_utf8(entry) != nullptr)
        return ArchiveEntry::Kind::secondName;
    if (archive_entry_symlink(entry) != nullptr) return ArchiveEntry::Kind::other;
    switch (archive_entry_filetype(entry)) {
        case AE_IFREG:
            return ArchiveEntry::Kind::file;
        case AE_IFDIR:
            return ArchiveEntry::Kind::folder;
        default:
            return ArchiveEntry::Kind::other;
    }
}

}  // namespace

void ArchiveReader::Closes::operator()(archive* opened) const {
    archive_read_free(opened);
}

ArchiveReader::ArchiveReader(const std::filesystem::path& file) : archive_(archive_read_new()) {
    if (!archive_) throw std::bad_alloc();
    archive* const reader = archive_.get();
    archive_read_support_format_zip(reader);
    archive_read_support_format_tar(reader);
    archive_read_support_format_iso9660(reader);
    archive_read_support_filter_gzip(reader);
    archive_read_support_filter_xz(reader);
    archive_read_support_filter_bzip2(reader);
    archive_read_support_filter_zstd(reader);
    isBroken_ = archive_read_open_filename(reader, file.c_str(), kBlockBytes) != ARCHIVE_OK;
}

ArchiveReader::~ArchiveReader() = default;

ArchiveReader::Step ArchiveReader::next(ArchiveEntry& entry) {
    archive_entry* read = nullptr;
    int outcome = ARCHIVE_RETRY;
    // A bad header costs its entry.
    for (int tries = 0; !isBroken_ && tries < kMostTries; ++tries) {
        outcome = archive_read_next_header(archive_.get(), &read);
        if (outcome != ARCHIVE_RETRY && outcome != ARCHIVE_FAILED) break;
    }
    if (!isBroken_ && outcome == ARCHIVE_EOF) return Step::end;
    if (isBroken_ || (outcome != ARCHIVE_OK && outcome != ARCHIVE_WARN)) {
        isBroken_ = true;
        return Step::broken;
    }
    entry.kind = kindOf(read);
    entry.name = nameOf(archive_entry_pathname_utf8(read), archive_entry_pathname(read));
    entry.nameOfFirst = nameOf(archive_entry_hardlink_utf8(read), archive_entry_hardlink(read));
    entry.isEncrypted = archive_entry_is_encrypted(read) != 0;
    return Step::entry;
}

std::optional<std::size_t> ArchiveReader::read(std::span<std::byte> into) {
    if (isBroken_) return std::nullopt;
    const la_ssize_t bytes = archive_read_data(archive_.get(), into.data(), into.size());
    if (bytes >= 0) return static_cast<std::size_t>(bytes);
    isBroken_ = bytes == ARCHIVE_FATAL;
    return std::nullopt;
}

std::uint64_t ArchiveReader::positionBytes() const {
    return static_cast<std::uint64_t>(std::max<la_int64_t>(0, archive_filter_bytes(archive_.get(), -1)));
}

}  // namespace macula::unpack
