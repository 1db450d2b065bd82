#include "study/spool/same_object.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "dicom/read/outline.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBytesAtOnce = std::size_t{256} << 10;
constexpr const char* kDeflated = "1.2.840.10008.1.2.1.99";

struct Range {
    std::uint64_t from = 0;
    std::uint64_t bytes = 0;
};

bool isLittleEndian(const std::string& transferSyntaxUid) {
    return transferSyntaxUid == "1.2.840.10008.1.2" || transferSyntaxUid == "1.2.840.10008.1.2.1";
}

Range comparedOf(const dicom::Outline& outline, std::uint64_t sizeOfFile) {
    const bool hasPlace = outline.pixels && outline.transferSyntaxUid != kDeflated;
    if (!hasPlace) return {outline.datasetOffset, sizeOfFile - std::min(sizeOfFile, outline.datasetOffset)};
    const dicom::PixelDataOutline& pixels = *outline.pixels;
    // Behind fragments nothing follows but padding.
    const std::uint64_t toTheEnd = sizeOfFile - std::min(sizeOfFile, pixels.offset);
    return {pixels.offset, pixels.encapsulated ? toTheEnd : pixels.present};
}

bool haveSameBytes(const fs::path& a, const Range& ofA, const fs::path& b, const Range& ofB) {
    if (ofA.bytes != ofB.bytes) return false;
    std::ifstream streamA(a, std::ios::binary);
    std::ifstream streamB(b, std::ios::binary);
    streamA.seekg(static_cast<std::streamoff>(ofA.from));
    streamB.seekg(static_cast<std::streamoff>(ofB.from));
    std::vector<char> partA;
    std::vector<char> partB;
    for (std::uint64_t left = ofA.bytes; left > 0; left -= partA.size()) {
        partA.resize(std::min<std::uint64_t>(left, kBytesAtOnce));
        partB.resize(partA.size());
        const auto length = static_cast<std::streamsize>(partA.size());
        if (!streamA.read(partA.data(), length) || !streamB.read(partB.data(), length)) return false;
        if (partA != partB) return false;
    }
    return streamA.good() && streamB.good();
}

}  // namespace

bool isSameObject(const fs::path& a, const fs::path& b) {
    constexpr bool hasPreamble = true;  // Macula has written both
    const dicom::Outline ofA = dicom::outlineOf(a, hasPreamble);
    const dicom::Outline ofB = dicom::outlineOf(b, hasPreamble);
    std::error_code failureA;
    std::error_code failureB;
    const std::uint64_t sizeA = fs::file_size(a, failureA);
    const std::uint64_t sizeB = fs::file_size(b, failureB);
    if (failureA || failureB || !ofA.headerWhole || !ofB.headerWhole) return false;
    if (ofA.pixels.has_value() != ofB.pixels.has_value()) return false;
    const bool isPlain = isLittleEndian(ofA.transferSyntaxUid) && isLittleEndian(ofB.transferSyntaxUid);
    if (ofA.transferSyntaxUid != ofB.transferSyntaxUid && !(isPlain && ofA.pixels)) return true;
    return haveSameBytes(a, comparedOf(ofA, sizeA), b, comparedOf(ofB, sizeB));
}

}  // namespace macula::study
