#include "dicom/write/segmentation_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/utf8.h"
#include "dicom/read/sop_class.h"
#include "dicom/write/cie_lab.h"
#include "dicom/write/content_item.h"
#include "dicom/write/decimal_string.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/segment_frames.h"
#include "dicom/write/uid.h"
#include "toolkit/character_set.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr double kMostBytes = 4294967294.0;  // of Pixel Data, an even number below 2^32 - 1
constexpr double kPerpendicular = 1e-4;      // files often have 5 decimals, see stack/geometry.cpp

bool isInGrid(const VoxelSet& voxels, const glm::ivec3& size) {
    bool isIn = true;
    voxels.forEach([&](const glm::ivec3& v) {
        isIn = isIn && v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < size.x && v.y < size.y && v.z < size.z;
    });
    return isIn;
}

Result<void> checkGrid(const WrittenSegmentation& s) {
    constexpr int kMostRows = 65535;  // Rows and Columns, VR US
    const bool isGrid = s.size.x >= 1 && s.size.y >= 1 && s.size.z >= 1 && s.size.x <= kMostRows &&
                        s.size.y <= kMostRows && s.slices.size() == std::size_t(s.size.z) &&
                        isInvertibleAffine(s.worldFromVoxel);
    if (!isGrid)
        return refusedObject(Text("A segmentation cannot be written for a volume of that kind."),
                             Text("Choose another series."));
    const glm::dvec3 row = glm::normalize(glm::dvec3(s.worldFromVoxel[0]));
    const glm::dvec3 column = glm::normalize(glm::dvec3(s.worldFromVoxel[1]));
    if (std::abs(glm::dot(row, column)) > kPerpendicular)
        return refusedObject(
            Text("The rows and columns of this volume are not perpendicular, which DICOM cannot express."),
            Text("Choose another series."));
    if (!std::ranges::all_of(s.segments, [&](const WrittenSegment& each) {
            return each.voxels && isInGrid(*each.voxels, s.size);
        }))
        return refusedObject(Text("A segment lies outside of the volume."),
                             Text("Choose another segmentation."));
    return {};
}

Result<void> check(const WrittenSegmentation& s, const NewObject& object) {
    if (!isCodeString(s.label)) return textRefused();
    MACULA_TRY_VOID(checkGrid(s));
    constexpr std::size_t kMostSegments = 65535;  // Segment Number, VR US
    if (s.segments.size() > kMostSegments ||
        std::ranges::all_of(s.segments, [](const WrittenSegment& each) { return each.voxels->isEmpty(); }))
        return refusedObject(Text("No voxel of this volume belongs to a segment."),
                             Text("Choose another segmentation."));
    const auto isNamed = [](const SegmentedSlice& slice) {
        return !slice.of || (isUid(slice.of->sopClassUid) && isUid(slice.of->sopInstanceUid));
    };
    if (!isUid(s.series.seriesInstanceUid) || !isUid(s.series.frameOfReferenceUid) ||
        !std::ranges::all_of(s.slices, isNamed))
        return refusedObject(Text("A segmentation refers to DICOM images with identifiers and a frame of "
                                  "reference, and this series has none."),
                             Text("Choose another series."));
    return checkOwner(object, Text("Write the segmentation without patient and study."));
}

std::string decimals(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : "\\") + decimalString(value);
    return text;
}

// At most 64 characters of UTF-8, without the delimiter of values.
std::string shortText(const std::string& text) {
    const std::string valid = decodeText(text, "ISO_IR 192", Delimiters::none).utf8;
    std::string made;
    std::string_view rest = valid;
    for (std::size_t n = 0; n < kLongestText && !rest.empty(); ++n) {
        const std::size_t bytes = std::max<std::size_t>(1, firstCharacterBytes(rest));
        made += rest.substr(0, bytes);
        rest.remove_prefix(bytes);
    }
    std::ranges::replace(made, '\\', '/');
    return made;
}

void writeImage(ItemWriter to, const WrittenSegmentation& s) {
    const Now now;
    to.text(DCM_FrameOfReferenceUID, s.series.frameOfReferenceUid);
    to.text(DCM_PositionReferenceIndicator, "");
    to.text(DCM_ContentDate, now.date);
    to.text(DCM_ContentTime, now.time);
    to.text(DCM_ContentLabel, s.label);
    to.text(DCM_ContentDescription, "");
    to.text(DCM_ContentCreatorName, "");
    to.text(DCM_ImageType, "DERIVED\\PRIMARY");
    to.text(DCM_LossyImageCompression, "00");
    to.word(DCM_SamplesPerPixel, 1);
    to.text(DCM_PhotometricInterpretation, "MONOCHROME2");
    to.word(DCM_Rows, std::uint16_t(s.size.y));
    to.word(DCM_Columns, std::uint16_t(s.size.x));
    to.word(DCM_BitsAllocated, 1);
    to.word(DCM_BitsStored, 1);
    to.word(DCM_HighBit, 0);
    to.word(DCM_PixelRepresentation, 0);
    to.text(DCM_SegmentationType, "BINARY");
}

void writeSegment(ItemWriter item, const WrittenSegment& written, std::uint16_t number) {
    const Segment& segment = written.segment;
    const CodedName tissue{"85756007", "SCT", "Tissue"};
    const auto coded = [](const std::optional<CodedName>& code, const CodedName& otherwise) {
        if (!code) return otherwise;
        return CodedName{code->value, code->scheme, shortText(code->meaning)};
    };
    writeCode(item.item(DCM_SegmentedPropertyCategoryCodeSequence, 0), coded(written.codes.category, tissue));
    item.word(DCM_SegmentNumber, number);
    item.text(DCM_SegmentLabel,
              segment.label.empty() ? "Segment " + std::to_string(number) : shortText(segment.label));
    if (!segment.description.empty()) item.text(DCM_SegmentDescription, shortText(segment.description));
    const bool saysHow = segment.algorithm == "MANUAL" || segment.algorithm == "SEMIAUTOMATIC" ||
                         segment.algorithm == "AUTOMATIC";
    item.text(DCM_SegmentAlgorithmType, saysHow ? segment.algorithm : "SEMIAUTOMATIC");
    if (segment.algorithm != "MANUAL")
        item.text(DCM_SegmentAlgorithmName,
                  segment.algorithmName.empty() ? "unknown" : shortText(segment.algorithmName));
    if (segment.recommendedRgb)
        item.words(DCM_RecommendedDisplayCIELabValue, ItemWriter::WordVr::us,
                   cieLabOfRgb(*segment.recommendedRgb));
    writeCode(item.item(DCM_SegmentedPropertyTypeCodeSequence, 0), coded(written.codes.type, tissue));
}

// Orders frames by segment and slice (PS3.3 C.7.6.17).
void writeDimensions(ItemWriter to) {
    const std::string organisation = newUid();
    to.item(DCM_DimensionOrganizationSequence, 0).text(DCM_DimensionOrganizationUID, organisation);
    const std::array pointers{std::pair(DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence),
                              std::pair(DCM_ImagePositionPatient, DCM_PlanePositionSequence)};
    for (std::size_t i = 0; i < pointers.size(); ++i) {
        ItemWriter index = to.item(DCM_DimensionIndexSequence, i);
        index.text(DCM_DimensionOrganizationUID, organisation);
        index.tagName(DCM_DimensionIndexPointer, pointers[i].first);
        index.tagName(DCM_FunctionalGroupPointer, pointers[i].second);
    }
}

void writeSharedGroups(ItemWriter to, const WrittenSegmentation& s) {
    ItemWriter shared = to.item(DCM_SharedFunctionalGroupsSequence, 0);
    const glm::dvec3 i(s.worldFromVoxel[0]);
    const glm::dvec3 j(s.worldFromVoxel[1]);
    const glm::dvec3 row = glm::normalize(i);
    const glm::dvec3 column = glm::normalize(j);
    ItemWriter plane = shared.item(DCM_PlaneOrientationSequence, 0);
    plane.text(DCM_ImageOrientationPatient, decimals({row.x, row.y, row.z, column.x, column.y, column.z}));
    ItemWriter pixel = shared.item(DCM_PixelMeasuresSequence, 0);
    // From slice to slice along the normal, also where slices are sheared.
    const double distanceMm = std::abs(glm::dot(glm::dvec3(s.worldFromVoxel[2]), glm::cross(row, column)));
    pixel.text(DCM_SliceThickness, decimalString(distanceMm));
    pixel.text(DCM_SpacingBetweenSlices, decimalString(distanceMm));
    pixel.text(DCM_PixelSpacing, decimals({glm::length(j), glm::length(i)}));  // rows first
}

void writeFrame(ItemWriter frame, const WrittenSegmentation& s, const SegmentFrames::Frame& at) {
    const SegmentedSlice& slice = s.slices[std::size_t(at.slice)];
    const auto number = std::uint16_t(at.segment + 1);
    if (slice.of) {
        ItemWriter derivation = frame.item(DCM_DerivationImageSequence, 0);
        ItemWriter source = derivation.item(DCM_SourceImageSequence, 0);
        writeReference(source, *slice.of);
        source.text(DCM_SpatialLocationsPreserved, "YES");
        writeCode(source.item(DCM_PurposeOfReferenceCodeSequence, 0),
                  {"121322", "DCM", "Source image for image processing operation"});
        writeCode(derivation.item(DCM_DerivationCodeSequence, 0), {"113076", "DCM", "Segmentation"});
    }
    const std::array<std::uint32_t, 2> place{number, std::uint32_t(at.slice + 1)};
    frame.item(DCM_FrameContentSequence, 0).longs(DCM_DimensionIndexValues, place);
    const glm::dvec3& p = slice.positionMm;
    frame.item(DCM_PlanePositionSequence, 0).text(DCM_ImagePositionPatient, decimals({p.x, p.y, p.z}));
    frame.item(DCM_SegmentIdentificationSequence, 0).word(DCM_ReferencedSegmentNumber, number);
}

// PS3.3 C.12.2: the images of the slices that have frames.
void writeReferences(ItemWriter to, const WrittenSegmentation& s, const SegmentFrames& frames) {
    std::vector<bool> isDrawnOn(s.slices.size());
    for (const SegmentFrames::Frame& frame : frames.frames()) isDrawnOn[std::size_t(frame.slice)] = true;
    std::vector<std::string> known;
    for (std::size_t k = 0; k < s.slices.size(); ++k) {
        const auto& of = s.slices[k].of;
        // Slices of one file follow each other.
        if (!isDrawnOn[k] || !of || (!known.empty() && known.back() == of->sopInstanceUid)) continue;
        if (known.empty())
            to.item(DCM_ReferencedSeriesSequence, 0).text(DCM_SeriesInstanceUID, s.series.seriesInstanceUid);
        known.push_back(of->sopInstanceUid);
        writeReference(to.item(DCM_ReferencedSeriesSequence, 0).nextItem(DCM_ReferencedInstanceSequence),
                       {of->sopClassUid, of->sopInstanceUid, {}});
    }
}

bool needsUtf8(const WrittenSegmentation& s) {
    return !std::ranges::all_of(s.segments, [](const WrittenSegment& each) {
        const Segment& segment = each.segment;
        return isAscii(segment.label) && isAscii(segment.description) && isAscii(segment.algorithmName) &&
               (!each.codes.category || isAscii(each.codes.category->meaning)) &&
               (!each.codes.type || isAscii(each.codes.type->meaning));
    });
}

}  // namespace

Result<void> writeSegmentation(const fs::path& path, const WrittenSegmentation& segmentation,
                               const NewObject& object) {
    MACULA_TRY_VOID(check(segmentation, object));
    const SegmentFrames frames(segmentation);
    if (frames.bytesOfCells() > kMostBytes)
        return refusedObject(Text("These segments need more frames than one DICOM file can hold."),
                             Text("Choose fewer segments."));
    const ObjectKind kind{.modality = "SEG",
                          .sopClassUid = sop_class::kSegmentation,
                          .seriesNumber = 9300,
                          .seriesDescription = "Segmentation",
                          .needsUtf8 = needsUtf8(segmentation)};
    return writeObject(path, object, kind, [&](ItemWriter to, const InstallationKey* standIns) {
        WrittenSegmentation written = segmentation;
        if (standIns != nullptr) {
            written.series = withStandIns(std::move(written.series), *standIns);
            for (SegmentedSlice& slice : written.slices)
                if (slice.of) slice.of->sopInstanceUid = standInUid(*standIns, slice.of->sopInstanceUid);
        }
        writeImage(to, written);
        to.text(DCM_NumberOfFrames, std::to_string(frames.frames().size()));
        to.text(DCM_SegmentsOverlap, frames.doOverlap() ? "YES" : "NO");
        for (std::size_t n = 0; n < written.segments.size(); ++n)
            writeSegment(to.nextItem(DCM_SegmentSequence), written.segments[n], std::uint16_t(n + 1));
        writeDimensions(to);
        writeSharedGroups(to, written);
        for (const SegmentFrames::Frame& frame : frames.frames())
            writeFrame(to.nextItem(DCM_PerFrameFunctionalGroupsSequence), written, frame);
        writeReferences(to, written, frames);
        to.bytes(DCM_PixelData, frames.cells());
    });
}

}  // namespace macula::dicom
