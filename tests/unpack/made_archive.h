// Archives for tests, good and bad ones, written by libarchive.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace macula::unpack::test {

struct Member {
    enum class Kind { file, symbolicLink, hardLink, device, pipe };
    std::string name;
    std::string content = {};
    Kind kind = Kind::file;
    std::string target = {};     // of a link
    std::int64_t holeBytes = 0;  // before the content, in a tar file (sparse)
};

enum class Format { zip, encryptedZip, tar, gzippedTar, xzTar, iso };

// What one calls such a file: ".tar.gz".
std::string endingOf(Format format);

void writeArchive(const std::filesystem::path& file, Format format, const std::vector<Member>& members);
// The same with the files of a folder.
void writeArchive(const std::filesystem::path& file, Format format, const std::filesystem::path& folder);

// Says in both headers of a member of a ZIP file that it is encrypted (APPNOTE 4.4.4, bit 0).
void markEncrypted(const std::filesystem::path& zip, const std::string& member);

std::string bytesOf(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace macula::unpack::test
