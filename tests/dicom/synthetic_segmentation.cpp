#include "synthetic_segmentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dicom/read/sop_class.h"

namespace macula::dicom::test {

namespace {

constexpr int kLevels = 200;

struct MadeFrame {
    int segment = 0;
    glm::dvec3 positionMm{0.0};
};

struct Made {
    std::vector<MadeFrame> frames;
    std::vector<Uint8> cells;  // one each
};

Made framesOf(const SyntheticSegmentation& s) {
    Made made;
    for (const auto& part : s.parts) {
        for (int k = 0; k < s.size.z; ++k) {
            std::vector<Uint8> slice;
            bool isEmpty = true;
            for (int j = 0; j < s.size.y; ++j) {
                for (int i = 0; i < s.size.x; ++i) {
                    const double share = part.share(transformPoint(s.worldFromVoxel, {i, j, k}));
                    const bool isBinary = s.type == "BINARY";
                    slice.push_back(Uint8(isBinary ? (share >= 0.5 ? 1 : 0) : std::lround(share * kLevels)));
                    isEmpty = isEmpty && slice.back() == 0;
                }
            }
            if (isEmpty) continue;
            made.frames.push_back({part.number, transformPoint(s.worldFromVoxel, {0, 0, k})});
            made.cells.insert(made.cells.end(), slice.begin(), slice.end());
        }
    }
    return made;
}

// One bit after the other, least significant first, over the borders of frames.
std::vector<Uint8> packed(const std::vector<Uint8>& cells) {
    std::vector<Uint8> bytes((cells.size() + 15) / 16 * 2);
    for (std::size_t n = 0; n < cells.size(); ++n) bytes[n / 8] = Uint8(bytes[n / 8] | cells[n] << (n % 8));
    return bytes;
}

void putHeader(DcmItem& item, const SyntheticSegmentation& s, const Made& made) {
    const bool isBinary = s.type == "BINARY";
    if (s.frameOfReferenceUid.empty()) {
        erase(item, DCM_FrameOfReferenceUID);
    } else {
        put(item, DCM_FrameOfReferenceUID, s.frameOfReferenceUid);
    }
    put(item, DCM_PatientID, s.patientId);
    put(item, DCM_ContentLabel, s.contentLabel);
    put(nested(item, DCM_ReferencedSeriesSequence), DCM_SeriesInstanceUID, s.referencedSeriesUid);
    putWord(item, DCM_SamplesPerPixel, 1);
    put(item, DCM_PhotometricInterpretation, "MONOCHROME2");
    put(item, DCM_NumberOfFrames, std::to_string(made.frames.size()));
    putWord(item, DCM_Rows, s.size.y);
    putWord(item, DCM_Columns, s.size.x);
    putWord(item, DCM_BitsAllocated, isBinary ? 1 : 8);
    putWord(item, DCM_BitsStored, isBinary ? 1 : 8);
    putWord(item, DCM_HighBit, isBinary ? 0 : 7);
    putWord(item, DCM_PixelRepresentation, 0);
    put(item, DCM_SegmentationType, s.type);
    if (!isBinary) putWord(item, DCM_MaximumFractionalValue, kLevels);
    for (const auto& part : s.parts) {
        DcmItem& segment = appended(item, DCM_SegmentSequence);
        putWord(segment, DCM_SegmentNumber, part.number);
        put(segment, DCM_SegmentLabel, part.label);
        put(segment, DCM_SegmentAlgorithmType, "MANUAL");
        if (!part.cieLab) continue;
        const std::array lab{Uint16(part.cieLab->at(0)), Uint16(part.cieLab->at(1)),
                             Uint16(part.cieLab->at(2))};
        ASSERT_TRUE(segment.putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, lab.data(), lab.size())
                        .good());
    }
}

}  // namespace

void writeSegmentation(const std::filesystem::path& file, const SyntheticSegmentation& s) {
    const Made made = framesOf(s);
    ASSERT_FALSE(made.frames.empty());
    const glm::dvec3 row(s.worldFromVoxel[0]);
    const glm::dvec3 column(s.worldFromVoxel[1]);
    Shell shell{.sopClassUid = std::string(sop_class::kSegmentation),
                .modality = "SEG",
                .sopInstanceUid = s.sopInstanceUid,
                .seriesUid = s.seriesUid,
                .edits = {}};
    shell.edits.push_back([&](DcmItem& item) {
        putHeader(item, s, made);
        DcmItem& shared = nested(item, DCM_SharedFunctionalGroupsSequence);
        const glm::dvec3 u = glm::normalize(row);
        const glm::dvec3 v = glm::normalize(column);
        put(nested(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
            decimals({u.x, u.y, u.z, v.x, v.y, v.z}));
        DcmItem& measures = nested(shared, DCM_PixelMeasuresSequence);
        put(measures, DCM_PixelSpacing, decimals({glm::length(column), glm::length(row)}));
        put(measures, DCM_SpacingBetweenSlices,
            decimal(std::abs(glm::dot(glm::dvec3(s.worldFromVoxel[2]), glm::cross(u, v)))));
        for (const MadeFrame& frame : made.frames) {
            DcmItem& groups = appended(item, DCM_PerFrameFunctionalGroupsSequence);
            const glm::dvec3& mm = frame.positionMm;
            put(nested(groups, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
                decimals({mm.x, mm.y, mm.z}));
            putWord(nested(groups, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber,
                    frame.segment);
        }
        std::vector<Uint8> bytes = s.type == "BINARY" ? packed(made.cells) : made.cells;
        if (bytes.size() % 2 != 0) bytes.push_back(0);
        ASSERT_TRUE(item.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()).good());
    });
    writeShell(file, shell);
}

}  // namespace macula::dicom::test
