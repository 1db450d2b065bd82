#include "dicom/segmentation/segmentation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/exceptions.h"
#include "base/srgb.h"
#include "dicom/read/dataset.h"
#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr Tag kSegmentationType{0x0062, 0x0001};
constexpr Tag kSegmentSequence{0x0062, 0x0002};
constexpr Tag kSegmentNumber{0x0062, 0x0004};
constexpr Tag kSegmentLabel{0x0062, 0x0005};
constexpr Tag kSegmentDescription{0x0062, 0x0006};
constexpr Tag kSegmentAlgorithmType{0x0062, 0x0008};
constexpr Tag kSegmentAlgorithmName{0x0062, 0x0009};
constexpr Tag kReferencedSegmentNumber{0x0062, 0x000B};
constexpr Tag kRecommendedCieLab{0x0062, 0x000D};
constexpr Tag kMaximumFractionalValue{0x0062, 0x000E};
constexpr Tag kSegmentedPropertyType{0x0062, 0x000F};
constexpr Tag kCodeValue{0x0008, 0x0100};
constexpr Tag kCodingScheme{0x0008, 0x0102};
constexpr Tag kContentLabel{0x0070, 0x0080};

Error notUsable(const fs::path& file, Text message, Text hint = Text("Choose another segmentation.")) {
    return {ErrorCode::inputNotUsable, std::move(message), file.string(), std::move(hint)};
}

std::optional<SegmentationType> typeOf(const Dataset& header) {
    const std::string type = header.text(kSegmentationType).value_or("");
    if (type == "BINARY") return SegmentationType::binary;
    if (type == "FRACTIONAL") return SegmentationType::fractional;
    if (type == "LABELMAP") return SegmentationType::labelMap;
    return {};
}

// A valid segment number: from 1, in a label map from 0 (PS3.3 C.8.20.4).
std::optional<std::uint16_t> segmentNumber(std::optional<int> number, SegmentationType type) {
    const int least = type == SegmentationType::labelMap ? 0 : 1;
    if (!number || *number < least || *number > 65535) return {};
    return static_cast<std::uint16_t>(*number);
}

// Whether the code of the segment is Background. A label that only says so counts for padding and 0 alone
// (isCalledBackground).
bool isCodedBackground(const Dataset& segment) {
    return std::ranges::any_of(segment.items(kSegmentedPropertyType), [](const Dataset& code) {
        return code.text(kCodeValue) == "125040" && code.text(kCodingScheme) == "DCM";
    });
}

bool isCalledBackground(const Segment& segment) {
    std::string label;
    for (const char c : segment.label) label += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return label == "background";
}

// The values of cells of the padding, one or a range (PS3.3 C.7.5.1.1.2).
std::optional<CellRange> paddingOf(const Dataset& header, const CellFormat& format) {
    const auto value = header.integer(tag::kPixelPaddingValue);
    if (!value) return {};
    const auto cell = [&](int number) {  // some writers give the highest value as -1
        return number < 0 ? number & ((1 << format.bitsStored) - 1) : number;
    };
    const int one = cell(*value);
    const int other = cell(header.integer(tag::kPixelPaddingRangeLimit).value_or(*value));
    return CellRange{std::min(one, other), std::max(one, other)};
}

// Finds the numbers that mean background in a label map, and removes these from its segments.
void findBackground(const Dataset& header, Segmentation& segmentation) {
    std::set<int> coded;
    for (const Dataset& item : header.items(kSegmentSequence)) {
        if (const auto number = item.integer(kSegmentNumber); number && isCodedBackground(item))
            coded.insert(*number);
    }
    const std::optional<CellRange> padding = paddingOf(header, segmentation.format);
    const auto isPadding = [&](const Segment& segment) {
        return padding && padding->contains(segment.number);
    };
    std::erase_if(segmentation.segments, [&](const Segment& segment) {
        return coded.contains(segment.number) ||
               ((isPadding(segment) || segment.number == 0) && isCalledBackground(segment));
    });
    const bool isZeroDescribed = !segmentation.segments.empty() && segmentation.segments.front().number == 0;
    if (!isZeroDescribed) coded.insert(0);
    if (padding) segmentation.background.push_back(*padding);
    for (const int number : coded) segmentation.background.push_back({number, number});
    for (const Segment& segment : segmentation.segments)
        if (isPadding(segment)) segmentation.paddedSegments.push_back(segment.number);
}

std::vector<Segment> readSegments(const Dataset& header, SegmentationType type) {
    std::map<std::uint16_t, Segment> segments;
    for (const Dataset& item : header.items(kSegmentSequence)) {
        const auto number = segmentNumber(item.integer(kSegmentNumber), type);
        if (!number) continue;
        Segment segment{.number = *number,
                        .label = item.text(kSegmentLabel).value_or(""),
                        .description = item.text(kSegmentDescription).value_or(""),
                        .algorithm = item.text(kSegmentAlgorithmType).value_or(""),
                        .algorithmName = item.text(kSegmentAlgorithmName).value_or("")};
        if (const auto lab = item.words(kRecommendedCieLab); lab.size() == 3)
            segment.recommendedRgb = rgbOfCieLab({lab[0], lab[1], lab[2]});
        segments.emplace(*number, std::move(segment));
    }
    std::vector<Segment> byNumber;
    for (auto& [number, segment] : segments) byNumber.push_back(std::move(segment));
    return byNumber;
}

std::optional<ImagePlane> planeOf(const Dataset& frame) {
    const auto position = frame.numbers(tag::kImagePositionPatient, 3);
    const auto orientation = frame.numbers(tag::kImageOrientationPatient, 6);
    const auto spacing = frame.numbers(tag::kPixelSpacing, 2);
    if (!position || !orientation || !spacing) return {};
    const std::vector<double>& o = *orientation;
    const ImagePlane plane{.positionMm = {(*position)[0], (*position)[1], (*position)[2]},
                           .rowDirection = {o[0], o[1], o[2]},
                           .columnDirection = {o[3], o[4], o[5]},
                           .columnSpacingMm = (*spacing)[1],
                           .rowSpacingMm = (*spacing)[0]};
    if (!isUsable(plane)) return {};
    return plane;
}

bool isFormatOf(SegmentationType type, const CellFormat& format) {
    if (!isUsable(format) || !isNarrow(format)) return false;
    return type != SegmentationType::labelMap || format.bitsAllocated >= 8;
}

}  // namespace

Result<Segmentation> readSegmentation(const fs::path& file) try {
    const HeaderFile read = readHeader(file);
    if (!read.header)
        return notUsable(file, Text("The segmentation cannot be read."),
                         Text("Copy the file again from its source."));
    const Dataset& header = *read.header;
    const auto type = typeOf(header);
    if (!isSegmentation(header.text(tag::kSopClassUid).value_or("")) || !type)
        return notUsable(file, Text("The file is no segmentation that this version knows."));

    Segmentation segmentation{.file = file,
                              .seriesInstanceUid = header.text(tag::kSeriesInstanceUid).value_or(""),
                              .frameOfReferenceUid = header.text(tag::kFrameOfReferenceUid).value_or(""),
                              .type = *type,
                              .transferSyntaxUid = header.transferSyntaxUid(),
                              .columns = header.integer(tag::kColumns).value_or(0),
                              .rows = header.integer(tag::kRows).value_or(0),
                              .segments = readSegments(header, *type)};
    for (const Dataset& series : header.items(tag::kReferencedSeries)) {
        if (auto uid = series.text(tag::kSeriesInstanceUid))
            segmentation.referencedSeriesUids.push_back(std::move(*uid));
    }
    segmentation.sopInstanceUid = header.text(tag::kSopInstanceUid).value_or("");
    segmentation.contentLabel = header.text(kContentLabel).value_or("");
    segmentation.format = {.bitsAllocated = header.integer(tag::kBitsAllocated).value_or(0),
                           .bitsStored = header.integer(tag::kBitsStored).value_or(0),
                           .highBit = header.integer(tag::kHighBit).value_or(0),
                           .isSigned = false};
    const bool hasSize = segmentation.columns >= 1 && segmentation.columns <= kMostRows &&
                         segmentation.rows >= 1 && segmentation.rows <= kMostRows;
    if (!hasSize || !isFormatOf(*type, segmentation.format) ||
        header.integer(tag::kSamplesPerPixel).value_or(1) != 1)
        return notUsable(file,
                         Text("The frames of the segmentation are of no kind that this version knows."));
    if (*type == SegmentationType::labelMap) findBackground(header, segmentation);
    if (*type == SegmentationType::fractional) {
        segmentation.fractionalMaximum =
            header.integer(kMaximumFractionalValue).value_or(segmentation.fractionalMaximum);
        if (segmentation.fractionalMaximum < 1)
            return notUsable(file, Text("The segmentation does not say what its values mean."));
    }

    // Every frame needs a position of its own, so that a header cannot claim more of them than it holds.
    const std::size_t described =
        std::max<std::size_t>(1, header.items(tag::kPerFrameFunctionalGroups).size());
    const auto count = static_cast<std::size_t>(header.frameCount());
    if (count > described)
        return notUsable(file, Text("The segmentation does not say where all of its frames lie."));
    segmentation.frames.reserve(count);
    for (int i = 0; i < header.frameCount(); ++i) {
        const Dataset frame = header.frame(i);
        const auto plane = planeOf(frame);
        if (!plane) return notUsable(file, Text("The segmentation does not say where its frames lie."));
        auto number = segmentNumber(frame.integer(kReferencedSegmentNumber), *type);
        if (!number && segmentation.segments.size() == 1) number = segmentation.segments.front().number;
        if (*type == SegmentationType::labelMap) {
            number = std::uint16_t{0};
        } else if (!number) {
            return notUsable(file, Text("The segmentation does not say what its frames show."));
        }
        segmentation.frames.push_back({*plane, *number});
    }
    const Dataset first = header.frame(0);
    for (const Tag tag : {tag::kSpacingBetweenSlices, tag::kSliceThickness}) {
        if (const auto spacing = first.number(tag); spacing && *spacing > 0 && segmentation.spacingMm == 0.0)
            segmentation.spacingMm = *spacing;
    }
    return segmentation;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read a segmentation"), file.string());
}

std::array<std::uint8_t, 3> rgbOfCieLab(const std::array<std::uint16_t, 3>& words) {
    const double lightness = words[0] * 100.0 / 65535.0;
    const double a = words[1] * 255.0 / 65535.0 - 128.0;
    const double b = words[2] * 255.0 / 65535.0 - 128.0;
    const double y = (lightness + 16.0) / 116.0;
    const auto linear = [](double t) {
        return t > 6.0 / 29.0 ? t * t * t : (t - 16.0 / 116.0) * 108.0 / 841.0;
    };
    // XYZ of CIE 1931, with the white of D65.
    const double x65 = 0.950456 * linear(y + a / 500.0);
    const double y65 = linear(y);
    const double z65 = 1.088754 * linear(y - b / 200.0);
    const std::array<double, 3> rgb{3.2404542 * x65 - 1.5371385 * y65 - 0.4985314 * z65,
                                    -0.9692660 * x65 + 1.8760108 * y65 + 0.0415560 * z65,
                                    0.0556434 * x65 - 0.2040259 * y65 + 1.0572252 * z65};
    std::array<std::uint8_t, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = static_cast<std::uint8_t>(std::lround(255.0 * encodedSrgb(std::clamp(rgb[i], 0.0, 1.0))));
    }
    return result;
}

}  // namespace macula::dicom
