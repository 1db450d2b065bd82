#include "net/archive/file_meta.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "base/parsing.h"

namespace macula::net {

namespace {

constexpr std::size_t kPreambleBytes = 128;
constexpr std::string_view kMagic = "DICM";

std::uint32_t littleEndianAt(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return value;
}

bool isCapital(std::byte b) {
    return b >= std::byte{'A'} && b <= std::byte{'Z'};
}

// The VRs of group 2 whose length has 32 bits (PS3.5 7.1.2).
bool hasLongLength(char first, char second) {
    return (first == 'O' && (second == 'B' || second == 'W')) || (first == 'U' && second == 'N') ||
           (first == 'S' && second == 'Q') || (first == 'U' && second == 'T');
}

struct MetaElement {
    std::uint32_t element = 0;
    std::size_t valueAt = 0;
    std::size_t length = 0;
};

// The element of group 2 at `at`, whose value lies within `bytes`. Some writers leave the VR out, against the
// standard.
std::optional<MetaElement> metaElementAt(std::span<const std::byte> bytes, std::size_t at) {
    constexpr std::size_t kShortHeader = 8;
    constexpr std::size_t kLongHeader = 12;
    if (bytes.size() - at < kShortHeader) return {};
    MetaElement found;
    found.element = littleEndianAt(bytes, at + 2, 2);
    const bool isExplicit = isCapital(bytes[at + 4]) && isCapital(bytes[at + 5]);
    if (!isExplicit) {
        found.length = littleEndianAt(bytes, at + 4, 4);
        found.valueAt = at + kShortHeader;
    } else if (hasLongLength(static_cast<char>(bytes[at + 4]), static_cast<char>(bytes[at + 5]))) {
        if (bytes.size() - at < kLongHeader) return {};
        found.length = littleEndianAt(bytes, at + 8, 4);
        found.valueAt = at + kLongHeader;
    } else {
        found.length = littleEndianAt(bytes, at + 6, 2);
        found.valueAt = at + kShortHeader;
    }
    if (found.length > bytes.size() - found.valueAt) return {};
    return found;
}

std::string uidOf(std::span<const std::byte> value) {
    const std::string_view text =
        trimmed(std::string_view(reinterpret_cast<const char*>(value.data()), value.size()));
    return isUid(text) ? std::string(text) : std::string();
}

// Closes the file when it goes.
class MetaSource {
  public:
    // Opens without waiting: a pipe would block.
    explicit MetaSource(const std::filesystem::path& file)
        : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {}
    ~MetaSource() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    MetaSource(const MetaSource&) = delete;
    MetaSource& operator=(const MetaSource&) = delete;

    std::optional<std::vector<std::byte>> beginning() const {
        struct stat status {};
        if (descriptor_ < 0 || fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return {};
        std::vector<std::byte> bytes(
            static_cast<std::size_t>(std::min<std::uintmax_t>(kMostMetaBytes, status.st_size)));
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t got = read(descriptor_, bytes.data() + at, bytes.size() - at);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return {};
            if (got == 0) bytes.resize(at);
            at += static_cast<std::size_t>(got);
        }
        return bytes;
    }

  private:
    int descriptor_;
};

// Of Macula, made once from a random UUID.
constexpr std::string_view kImplementation = "2.25.286042193577302957205894186322590127461";
constexpr std::string_view kImplementationVersion = "MACULA";

void appendNumber(std::string& bytes, std::size_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffu);
}

void appendMeta(std::string& bytes, unsigned element, std::string_view representation, std::string value) {
    if (value.size() % 2 != 0) value += representation == "UI" ? '\0' : ' ';
    appendNumber(bytes, 0x0002, 2);
    appendNumber(bytes, element, 2);
    bytes += representation;
    if (representation == "OB") appendNumber(bytes, 0, 2);
    appendNumber(bytes, value.size(), representation == "OB" ? 4 : 2);
    bytes += value;
}

}  // namespace

bool isUid(std::string_view text) {
    constexpr std::size_t kLongest = 64;
    const auto isOfUid = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
    return !text.empty() && text.size() <= kLongest && std::all_of(text.begin(), text.end(), isOfUid);
}

std::optional<FileMeta> fileMetaOf(std::span<const std::byte> beginning) {
    const std::span<const std::byte> bytes = beginning.first(std::min(beginning.size(), kMostMetaBytes));
    std::size_t at = kPreambleBytes + kMagic.size();
    if (bytes.size() < at || std::memcmp(bytes.data() + kPreambleBytes, kMagic.data(), kMagic.size()) != 0)
        return {};
    FileMeta meta;
    constexpr std::uint32_t kGroup = 2;
    const std::size_t begin = at;
    while (bytes.size() - at >= 2 && littleEndianAt(bytes, at, 2) == kGroup) {
        const auto found = metaElementAt(bytes, at);
        if (!found) return {};
        const auto value = bytes.subspan(found->valueAt, found->length);
        if (found->element == 0x0002) meta.sopClassUid = uidOf(value);
        if (found->element == 0x0003) meta.sopInstanceUid = uidOf(value);
        if (found->element == 0x0010) meta.transferSyntaxUid = uidOf(value);
        at = found->valueAt + found->length;
    }
    if (at == begin || (bytes.size() - at < 2 && bytes.size() == kMostMetaBytes)) return {};
    meta.datasetOffset = at;
    return meta;
}

Result<FileMeta> readFileMeta(const std::filesystem::path& file) {
    const auto bytes = MetaSource(file).beginning();
    if (!bytes) {
        return Error{ErrorCode::inputNotUsable, Text("The file cannot be read."), file.string(),
                     Text("Check that it exists, and that you may read it.")};
    }
    if (auto meta = fileMetaOf(*bytes)) return *std::move(meta);
    return Error{ErrorCode::inputNotUsable, Text("The file does not begin as a DICOM file does."),
                 file.string(), Text("Choose files of DICOM with file meta information.")};
}

std::string fileMetaBytes(const FileMeta& meta) {
    std::string group;
    appendMeta(group, 0x0001, "OB", std::string("\x00\x01", 2));
    appendMeta(group, 0x0002, "UI", meta.sopClassUid);
    appendMeta(group, 0x0003, "UI", meta.sopInstanceUid);
    appendMeta(group, 0x0010, "UI", meta.transferSyntaxUid);
    appendMeta(group, 0x0012, "UI", std::string(kImplementation));
    appendMeta(group, 0x0013, "SH", std::string(kImplementationVersion));
    std::string bytes(kPreambleBytes, '\0');
    bytes += "DICM";
    std::string length;
    appendNumber(length, group.size(), 4);
    appendMeta(bytes, 0x0000, "UL", length);
    return bytes + group;
}

}  // namespace macula::net
