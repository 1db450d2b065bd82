#include "dicom/stack/frame_parts.h"

#include <algorithm>
#include <cmath>

#include "dicom/read/number_list.h"

namespace macula::dicom {

namespace {

// Pixel spacing between rows and between columns, and the attribute it was taken from.
struct Spacing {
    std::vector<double> mm;
    PixelSpacingSource source = PixelSpacingSource::none;
};

// Reads a list of numbers, and notes in the frame how it is written.
std::optional<std::vector<double>> readList(const Dataset& dataset, Tag tag, std::string_view keyword,
                                            std::size_t count, Frame& frame) {
    NumberList list = numberList(dataset, tag, count);
    frame.numbersRepaired = frame.numbersRepaired || list.isRepaired;
    if (list.isMalformed && frame.malformedNumber.empty()) frame.malformedNumber = keyword;
    return std::move(list.values);
}

Spacing readSpacing(const Dataset& frame, Frame& noted) {
    if (const auto mm = readList(frame, tag::kPixelSpacing, "PixelSpacing", 2, noted))
        return {*mm, PixelSpacingSource::pixelSpacing};
    // Using another attribute in its place would be a guess.
    if (!noted.malformedNumber.empty()) return {};
    if (auto mm = readList(frame, tag::kImagerPixelSpacing, "ImagerPixelSpacing", 2, noted)) {
        // Spacing at the detector; at the patient it is smaller by the magnification (PS3.3 C.8.7.10).
        if (const auto magnification = frame.number(tag::kEstimatedMagnification);
            magnification && *magnification > 0.0) {
            for (double& value : *mm) value /= *magnification;
        }
        return {*mm, PixelSpacingSource::imagerPixelSpacing};
    }
    if (const auto mm = frame.numbers(tag::kNominalScannedPixelSpacing, 2)) {
        return {*mm, PixelSpacingSource::nominalScannedPixelSpacing};
    }
    return {};
}

// Whether a letter of PatientOrientation (PS3.3 C.7.6.1.1.1) names the side that the direction points away
// from.
bool isOpposite(std::string_view letters, const glm::dvec3& direction) {
    constexpr double kClearly = 0.5;
    const auto against = [&](double component) { return component < -kClearly; };
    switch (letters.empty() ? ' ' : letters.front()) {
        case 'L':
            return against(direction.x);
        case 'R':
            return against(-direction.x);
        case 'P':
            return against(direction.y);
        case 'A':
            return against(-direction.y);
        case 'H':
            return against(direction.z);
        case 'F':
            return against(-direction.z);
        default:
            return false;
    }
}

// Whether PatientOrientation contradicts the directions: a program that flips images may update only one of
// both. Animals have other letters, such as RT and PR, even where the header does not say that they are
// animals.
bool contradicts(const Dataset& dataset, const glm::dvec3& row, const glm::dvec3& column) {
    const auto letters = dataset.shortTexts(tag::kPatientOrientation);
    const auto isOfPerson = [](std::string_view side) {
        return side.find_first_not_of("LRAPHF") == std::string_view::npos;
    };
    if (letters.size() != 2 || !std::ranges::all_of(letters, isOfPerson) ||
        dataset.shortText(tag::kAnatomicalOrientationType) == "QUADRUPED")
        return false;
    return isOpposite(letters[0], row) || isOpposite(letters[1], column);
}

// Offsets for files with one position, one distance and no functional groups, as some cone-beam scanners
// write volumes. Frames that follow each other in time have an element that says so.
FrameOffsets framesInARow(const Dataset& header, double stepMm) {
    const bool isInTime =
        header.has(tag::kFrameTime) || header.has(tag::kFrameTimeVector) || header.has(tag::kCineRate);
    if (isInTime || stepMm <= 0.0 || header.has(tag::kPerFrameFunctionalGroups) ||
        !header.has(tag::kImagePositionPatient) || header.frameCount() < 2)
        return {};
    constexpr int kMostFrames = 100'000;
    FrameOffsets offsets{.isByOrder = true};
    for (int i = 0; i < std::min(header.frameCount(), kMostFrames); ++i) offsets.mm.push_back(i * stepMm);
    return offsets;
}

}  // namespace

FrameOffsets frameOffsets(const Dataset& header) {
    // RT Dose: distances from the first plane along the normal (PS3.3 C.8.8.3.2).
    std::vector<double> offsets = header.allNumbers(tag::kGridFrameOffsetVector);
    if (!offsets.empty()) {
        // The offsets are either distances from the first, or z coordinates of axial planes, whose normal may
        // point to -z.
        const auto position = header.numbers(tag::kImagePositionPatient, 3);
        const auto orientation = header.numbers(tag::kImageOrientationPatient, 6);
        const double first = offsets[0];
        const bool areZ = first != 0.0 && position && std::abs((*position)[2] - first) < 1e-3;
        const double normalZ =
            orientation ? (*orientation)[0] * (*orientation)[4] - (*orientation)[1] * (*orientation)[3] : 1.0;
        const double sign = areZ && normalZ < 0.0 ? -1.0 : 1.0;
        for (double& offset : offsets) offset = sign * (offset - first);
        return {std::move(offsets)};
    }
    // Nuclear medicine: the frame's slice number from 1, and a signed distance (PS3.3 C.8.4.15).
    offsets = header.allNumbers(tag::kSliceVector);
    const auto step = header.number(tag::kSpacingBetweenSlices);
    if (!step) return {};
    if (offsets.empty()) return framesInARow(header, *step);
    for (double& offset : offsets) offset = (offset - 1.0) * *step;
    return {std::move(offsets)};
}

void readPlane(const Dataset& header, const Dataset& dataset, double offsetMm, Frame& frame) {
    const Spacing spacing = readSpacing(dataset, frame);
    auto position = readList(dataset, tag::kImagePositionPatient, "ImagePositionPatient", 3, frame);
    auto orientation = readList(dataset, tag::kImageOrientationPatient, "ImageOrientationPatient", 6, frame);
    if (!position && !orientation) {
        // Nuclear medicine keeps them with the detector (PS3.3 C.8.4.11).
        if (const auto detectors = header.items(tag::kDetectorInformation); !detectors.empty()) {
            position = detectors.front().numbers(tag::kImagePositionPatient, 3);
            orientation = detectors.front().numbers(tag::kImageOrientationPatient, 6);
        }
    }
    if (!position && !orientation) {
        // Ultrasound: in the frame of the volume (PS3.3 C.8.24.3), which need not be known in the patient.
        position = readList(dataset, tag::kImagePositionVolume, "ImagePositionVolume", 3, frame);
        orientation = readList(dataset, tag::kImageOrientationVolume, "ImageOrientationVolume", 6, frame);
        frame.isInVolumeFrame = position.has_value() && orientation.has_value();
        if (frame.isInVolumeFrame)
            frame.frameOfReferenceUid = dataset.shortText(tag::kVolumeFrameOfReferenceUid);
    }
    frame.hasOrientation = orientation.has_value();
    frame.sliceLocation = dataset.number(tag::kSliceLocation);
    if (const auto thickness = dataset.number(tag::kSliceThickness); thickness && *thickness > 0.0)
        frame.sliceThicknessMm = thickness;
    frame.spacingSource = spacing.source;
    if (!position) return;
    frame.positionMm = glm::dvec3((*position)[0], (*position)[1], (*position)[2]);
    if (!orientation) return;
    const std::vector<double>& o = *orientation;
    const glm::dvec3 row{o[0], o[1], o[2]};
    const glm::dvec3 column{o[3], o[4], o[5]};
    frame.orientationContradicted = contradicts(dataset, row, column);
    *frame.positionMm += offsetMm * glm::cross(row, column);
    if (spacing.source == PixelSpacingSource::none) return;
    frame.plane = ImagePlane{.positionMm = *frame.positionMm,
                             .rowDirection = row,
                             .columnDirection = column,
                             .columnSpacingMm = spacing.mm[1],  // the first is between rows: PS3.3 10.7.1.3
                             .rowSpacingMm = spacing.mm[0]};
}

}  // namespace macula::dicom
