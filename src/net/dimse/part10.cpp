#include "net/dimse/part10.h"

#include <fstream>
#include <span>
#include <vector>

#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"

namespace macula::net {

namespace {

constexpr std::size_t kPreamble = 128;
constexpr std::size_t kBeforeGroup = kPreamble + 4 + 12;  // DICM, and the element with the group's length
constexpr std::uint32_t kMostBytesOfMeta = 1u << 20;
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

Error notPart10(const std::filesystem::path& file) {
    return {ErrorCode::inputNotUsable, Text("This is no DICOM file that can be sent."), file.string(),
            Text("Only files of DICOM part 10 can be sent to an archive.")};
}

}  // namespace

std::string metaBytes(const FileMeta& meta) {
    std::string group;
    appendMeta(group, 0x0001, "OB", std::string("\x00\x01", 2));
    appendMeta(group, 0x0002, "UI", meta.sopClassUid);
    appendMeta(group, 0x0003, "UI", meta.sopInstanceUid);
    appendMeta(group, 0x0010, "UI", meta.transferSyntaxUid);
    appendMeta(group, 0x0012, "UI", std::string(kImplementation));
    appendMeta(group, 0x0013, "SH", std::string(kImplementationVersion));
    std::string bytes(kPreamble, '\0');
    bytes += "DICM";
    std::string length;
    appendNumber(length, group.size(), 4);
    appendMeta(bytes, 0x0000, "UL", length);
    return bytes + group;
}

Result<FileMeta> readMeta(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::vector<unsigned char> head(kBeforeGroup);
    stream.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
    const std::span<const unsigned char> known(head);
    constexpr unsigned char kGroupLength[] = {'D', 'I', 'C', 'M', 2, 0, 0, 0, 'U', 'L', 4, 0};
    if (!stream || !std::equal(std::begin(kGroupLength), std::end(kGroupLength), head.begin() + kPreamble))
        return notPart10(file);
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length |= std::uint32_t{known[kBeforeGroup - 4 + i]} << (8 * i);
    if (length > kMostBytesOfMeta) return notPart10(file);
    std::vector<unsigned char> group(length);
    stream.read(reinterpret_cast<char*>(group.data()), static_cast<std::streamsize>(group.size()));
    FileMeta meta;
    meta.datasetOffset = kBeforeGroup + length;
    const bool isWhole =
        stream && forEachElement(group, Encoding::explicitLittle, [&](const Element& element) {
            if (element.tag == 0x00020002) meta.sopClassUid = textOf(element);
            if (element.tag == 0x00020003) meta.sopInstanceUid = textOf(element);
            if (element.tag == 0x00020010) meta.transferSyntaxUid = textOf(element);
            return true;
        });
    if (!isWhole || !isUid(meta.sopClassUid) || !isUid(meta.sopInstanceUid) || !isUid(meta.transferSyntaxUid))
        return notPart10(file);
    return meta;
}

}  // namespace macula::net
