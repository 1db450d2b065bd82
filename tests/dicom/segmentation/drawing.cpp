#include "segmentation/drawing.h"

#include <fmt/format.h>

#include "dicom/read/dataset.h"
#include "dicom/read/tags.h"

namespace macula::dicom::test {

std::string word(int value) {
    return bytesOf(static_cast<std::uint64_t>(value), 2);
}

std::string bytesOfDrawing(const Drawing& d) {
    const auto us = [](Tag tag, int value) { return shortElement(tag, "US", word(value)); };
    std::vector<std::string> segments, frames;
    for (const int number : d.segments) {
        segments.push_back(
            us({0x0062, 0x0004}, number) +
            shortElement({0x0062, 0x0005}, "LO",
                         d.labels.contains(number) ? d.labels.at(number) : fmt::format("label {}", number)) +
            shortElement({0x0062, 0x0008}, "CS", "MANUAL"));
        if (d.codedBackground.contains(number))
            segments.back() += sequence({0x0062, 0x000F}, {shortElement({0x0008, 0x0100}, "SH", "125040") +
                                                           shortElement({0x0008, 0x0102}, "SH", "DCM")});
    }
    for (const Drawing::Frame& f : d.frames) {
        const std::string position =
            fmt::format("{}\\{}\\{}", f.positionMm.x, f.positionMm.y, f.positionMm.z);
        std::string frame =
            sequence({0x0020, 0x9113}, {shortElement(tag::kImagePositionPatient, "DS", position)});
        if (f.segment != 0) frame += sequence({0x0062, 0x000A}, {us({0x0062, 0x000B}, f.segment)});
        frames.push_back(frame);
    }
    const std::string shared =
        sequence({0x0020, 0x9116}, {shortElement(tag::kImageOrientationPatient, "DS", d.orientation)}) +
        sequence({0x0028, 0x9110}, {shortElement({0x0018, 0x0088}, "DS", d.sliceSpacing) +
                                    shortElement(tag::kPixelSpacing, "DS", d.pixelSpacing)});
    const std::string count = d.claimedFrames.empty() ? std::to_string(d.frames.size()) : d.claimedFrames;
    const std::string dataset =
        shortElement(tag::kSopClassUid, "UI", d.sopClass) + shortElement(tag::kModality, "CS", "SEG") +
        sequence({0x0008, 0x1115}, {shortElement(tag::kSeriesInstanceUid, "UI", "1.2.3.4")}) +
        shortElement(tag::kSeriesInstanceUid, "UI", "1.2.9") + us(tag::kSamplesPerPixel, 1) +
        shortElement(tag::kNumberOfFrames, "IS", count) + us(tag::kRows, d.rows) +
        us(tag::kColumns, d.columns) + us(tag::kBitsAllocated, d.bits) + us(tag::kBitsStored, d.bits) +
        us(tag::kHighBit, d.bits - 1) + us(tag::kPixelRepresentation, 0) + d.padding +
        shortElement({0x0062, 0x0001}, "CS", d.type) + sequence({0x0062, 0x0002}, segments) + d.more +
        sequence(tag::kSharedFunctionalGroups, {shared}) + sequence(tag::kPerFrameFunctionalGroups, frames) +
        longElement(tag::kPixelData, d.bits > 8 ? "OW" : "OB", static_cast<std::uint32_t>(d.pixels.size())) +
        d.pixels;
    return preamble(d.transferSyntax) + (d.transferSyntax == kDeflated ? deflated(dataset) : dataset);
}

}  // namespace macula::dicom::test
