#include "dicom/segmentation/segment_codes.h"

#include <exception>

#include "base/exceptions.h"
#include "dicom/read/dataset.h"

namespace macula::dicom {

namespace {

constexpr Tag kSegments{0x0062, 0x0002};
constexpr Tag kNumber{0x0062, 0x0004};
constexpr Tag kCategory{0x0062, 0x0003};
constexpr Tag kType{0x0062, 0x000F};
constexpr Tag kScheme{0x0008, 0x0102};
constexpr Tag kMeaning{0x0008, 0x0104};

// The first code that is whole.
std::optional<CodedName> codeOf(const Dataset& segment, Tag sequence) {
    for (const Dataset& item : segment.items(sequence)) {
        CodedName code{item.text(tag::kCodeValue).value_or(""), item.text(kScheme).value_or(""),
                       item.text(kMeaning).value_or("")};
        if (!code.value.empty() && !code.scheme.empty() && !code.meaning.empty()) return code;
    }
    return {};
}

}  // namespace

Result<CodesOfSegments> readSegmentCodes(const std::filesystem::path& file) try {
    const HeaderFile read = readHeader(file);
    if (!read.header)
        return Error{ErrorCode::inputNotUsable, Text("The segmentation cannot be read."), file.string(),
                     Text("Copy the file again from its source.")};
    CodesOfSegments found;
    found.sopInstanceUid = read.header->text(tag::kSopInstanceUid).value_or("");
    for (const Dataset& item : read.header->items(kSegments)) {
        const auto number = item.integer(kNumber);
        if (!number || *number < 0 || *number > 65535) continue;
        found.codes.emplace(std::uint16_t(*number),
                            SegmentCodes{codeOf(item, kCategory), codeOf(item, kType)});
    }
    return found;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read a segmentation"), file.string());
}

}  // namespace macula::dicom
