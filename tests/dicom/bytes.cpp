#include "bytes.h"

#include <zlib.h>

#include "dicom/read/dataset.h"

namespace macula::dicom::test {

const std::string kItem = bytesOf(0xE000FFFE, 4);
const std::string kItemEnd = bytesOf(0xE00DFFFE, 4) + bytesOf(0, 4);
const std::string kSequenceEnd = bytesOf(0xE0DDFFFE, 4) + bytesOf(0, 4);

std::string bytesOf(std::uint64_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

std::string shortElement(Tag tag, const std::string& vr, std::string value) {
    if (value.size() % 2) value += vr == "UI" ? '\0' : ' ';
    return bytesOf(tag.group, 2) + bytesOf(tag.element, 2) + vr + bytesOf(value.size(), 2) + value;
}

std::string longElement(Tag tag, const std::string& vr, std::uint32_t length) {
    return bytesOf(tag.group, 2) + bytesOf(tag.element, 2) + vr + std::string(2, '\0') + bytesOf(length, 4);
}

std::string sequence(Tag tag, const std::vector<std::string>& items) {
    std::string value;
    for (const std::string& item : items) value += bytesOf(0xE000FFFE, 4) + bytesOf(item.size(), 4) + item;
    return longElement(tag, "SQ", static_cast<std::uint32_t>(value.size())) + value;
}

std::string preamble(const std::string& transferSyntaxUid) {
    const std::string syntax = shortElement({0x0002, 0x0010}, "UI", transferSyntaxUid);
    return std::string(128, '\0') + "DICM" + shortElement({0x0002, 0x0000}, "UL", bytesOf(syntax.size(), 4)) +
           syntax;
}

std::string sopClass() {
    return shortElement(tag::kSopClassUid, "UI", "1.2.840.10008.5.1.4.1.1.2") +
           shortElement(tag::kSopInstanceUid, "UI", "1.2.3") + shortElement(tag::kModality, "CS", "CT");
}

std::string deflated(const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string result(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    deflate(&stream, Z_FINISH);
    result.resize(stream.total_out);
    deflateEnd(&stream);
    return result;
}

}  // namespace macula::dicom::test
