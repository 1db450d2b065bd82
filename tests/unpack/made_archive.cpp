#include "unpack/made_archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>

namespace macula::unpack::test {

namespace fs = std::filesystem;

namespace {

struct Frees {
    void operator()(archive* writer) const { archive_write_free(writer); }
    void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};
using Writer = std::unique_ptr<archive, Frees>;

// A warning is one about names that the locale of the tests cannot express.
void succeed(archive* writer, int outcome) {
    if (outcome != ARCHIVE_OK && outcome != ARCHIVE_WARN)
        ADD_FAILURE() << "libarchive: "
                      << (archive_error_string(writer) ? archive_error_string(writer) : "?");
}

Writer writerOf(Format format) {
    Writer writer(archive_write_new());
    archive* const made = writer.get();
    if (format == Format::zip || format == Format::encryptedZip) {
        succeed(made, archive_write_set_format_zip(made));
    } else if (format == Format::iso) {
        succeed(made, archive_write_set_format_iso9660(made));
    } else {
        succeed(made, archive_write_set_format_pax_restricted(made));
    }
    if (format == Format::gzippedTar) succeed(made, archive_write_add_filter_gzip(made));
    if (format == Format::xzTar) succeed(made, archive_write_add_filter_xz(made));
    if (format == Format::encryptedZip) {
        succeed(made, archive_write_set_options(made, "zip:encryption=zipcrypt"));
        succeed(made, archive_write_set_passphrase(made, "secret"));
    }
    return writer;
}

void add(archive* writer, const Member& member) {
    const std::unique_ptr<archive_entry, Frees> entry(archive_entry_new());
    archive_entry* const made = entry.get();
    archive_entry_set_pathname(made, member.name.c_str());
    archive_entry_set_perm(made, 0644);
    archive_entry_set_filetype(made, AE_IFREG);
    archive_entry_set_size(made, 0);
    switch (member.kind) {
        case Member::Kind::file:
            archive_entry_set_size(made, member.holeBytes + std::int64_t(member.content.size()));
            if (member.holeBytes > 0)
                archive_entry_sparse_add_entry(made, member.holeBytes, std::int64_t(member.content.size()));
            break;
        case Member::Kind::symbolicLink:
            archive_entry_set_filetype(made, AE_IFLNK);
            archive_entry_set_symlink(made, member.target.c_str());
            break;
        case Member::Kind::hardLink:
            archive_entry_set_hardlink(made, member.target.c_str());
            break;
        case Member::Kind::device:
            archive_entry_set_filetype(made, AE_IFCHR);
            archive_entry_set_rdev(made, 259);
            break;
        case Member::Kind::pipe:
            archive_entry_set_filetype(made, AE_IFIFO);
            break;
    }
    succeed(writer, archive_write_header(writer, made));
    if (member.content.empty() && member.holeBytes == 0) return;
    if (member.holeBytes > 0) {
        // The writer leaves the hole out itself.
        const std::string zeros(1u << 20, '\0');
        for (std::int64_t left = member.holeBytes; left > 0; left -= std::int64_t(zeros.size()))
            archive_write_data(writer, zeros.data(),
                               std::size_t(std::min<std::int64_t>(left, std::int64_t(zeros.size()))));
    }
    EXPECT_EQ(archive_write_data(writer, member.content.data(), member.content.size()),
              la_ssize_t(member.content.size()));
}

}  // namespace

std::string endingOf(Format format) {
    switch (format) {
        case Format::zip:
        case Format::encryptedZip:
            return ".zip";
        case Format::tar:
            return ".tar";
        case Format::gzippedTar:
            return ".tar.gz";
        case Format::xzTar:
            return ".tar.xz";
        case Format::iso:
            return ".iso";
    }
    return {};
}

void writeArchive(const fs::path& file, Format format, const std::vector<Member>& members) {
    const Writer writer = writerOf(format);
    succeed(writer.get(), archive_write_open_filename(writer.get(), file.c_str()));
    for (const Member& member : members) add(writer.get(), member);
    succeed(writer.get(), archive_write_close(writer.get()));
}

void writeArchive(const fs::path& file, Format format, const fs::path& folder) {
    std::vector<Member> members;
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder)) {
        if (each.is_regular_file())
            members.push_back(
                {.name = each.path().lexically_relative(folder).string(), .content = bytesOf(each.path())});
    }
    std::ranges::sort(members, {}, &Member::name);
    writeArchive(file, format, members);
}

void markEncrypted(const fs::path& zip, const std::string& member) {
    std::string bytes = bytesOf(zip);
    struct Header {
        std::string magic;
        std::size_t flagsAt, nameAt;
    };
    for (const Header& header : {Header{"PK\x03\x04", 6, 30}, Header{"PK\x01\x02", 8, 46}}) {
        std::size_t at = bytes.find(header.magic);
        while (at != std::string::npos && bytes.compare(at + header.nameAt, member.size(), member) != 0)
            at = bytes.find(header.magic, at + 1);
        ASSERT_NE(at, std::string::npos) << member;
        bytes[at + header.flagsAt] = static_cast<char>(bytes[at + header.flagsAt] | 1);
    }
    writeBytes(zip, bytes);
}

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void writeBytes(const fs::path& file, const std::string& bytes) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace macula::unpack::test
