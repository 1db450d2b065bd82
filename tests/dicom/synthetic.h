// Makes DICOM files of which everything is known: what a voxel holds is a function of where it lies in the
// patient, so that the truth of a loaded volume is its own affine, whatever its order, tilt, orientation or
// resampling. A series becomes a list of slices; a test changes the list (drops, repeats, renames, edits) and
// writes it, as one file per slice or as one multi-frame file.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/volume.h"
#include "dicom/stack/intensity.h"

class DcmItem;
class DcmTagKey;

namespace macula::dicom::test {

// Linear, so that linear interpolation keeps it, with a slope of its own along every axis, so that no flip
// and no swap does.
struct Ramp {
    double value = 2000.0;  // at throughMm
    glm::dvec3 throughMm{0.0};
    glm::dvec3 perMm{11.0, 23.0, 47.0};

    double operator()(const glm::dvec3& worldMm) const {
        return value + glm::dot(perMm, worldMm - throughMm);
    }
    Ramp plus(double added) const { return {value + added, throughMm, perMm}; }
};

using Edit = std::function<void(DcmItem&)>;

// One image, wherever it is written to.
struct Slice {
    glm::dvec3 positionMm{0.0};
    glm::dvec3 rowDirection{1, 0, 0};
    glm::dvec3 columnDirection{0, 1, 0};
    double columnSpacingMm = 1.0;
    double rowSpacingMm = 1.0;
    double slope = 1.0;
    double intercept = 0.0;
    CellFormat format;
    int phase = 0;  // its values are Series.phaseStep higher for each
    int place = 0;  // along the grid, from 0
    int instanceNumber = 1;
    std::string stackId = "1";
    std::string sopInstanceUid;
    std::string fileName;
    std::vector<Edit> edits;  // the last word: on the file's dataset, or on the frame's functional groups

    glm::dvec3 normal() const { return glm::cross(rowDirection, columnDirection); }
};

struct SyntheticSeries {
    std::string modality = "CT";
    std::string sopClassUid;  // empty: the single-frame (or enhanced) one of the modality
    std::string studyUid = "2.25.1000";
    std::string seriesUid = "2.25.1001";
    std::string frameOfReferenceUid = "2.25.1002";
    std::string patientName = "SYNTHETIC^ONE";
    std::string patientId = "SYN1";
    std::string imageType = "ORIGINAL\\PRIMARY\\AXIAL";
    std::string patientPosition = "HFS";
    int number = 1;
    glm::ivec3 size{8, 7, 12};
    glm::dmat4 worldFromVoxel;             // the constructor makes it oblique, with three different spacings
    std::vector<double> places;            // of the slices, in steps of the grid; empty: 0, 1, 2 …
    std::optional<Ramp> ramp;              // empty: about 2000 in the middle of the grid
    CellFormat format{16, 16, 15, false};  // a test that sets bits outside the stored ones: cellNoise
    std::uint16_t cellNoise = 0;           // or-ed into the bits that are not stored
    double slope = 1.0;
    double intercept = -1024.0;
    bool writeRescale = true;
    int phases = 1;
    double phaseStep = 3000.0;
    bool shuffleNumbers = true;  // instance numbers say nothing; file names never do
    std::string transferSyntaxUid = "1.2.840.10008.1.2.1";
    // A raw value instead of the ramp's.
    std::function<std::optional<int>(const Slice&, int i, int j)> rawInstead;
    std::vector<Edit> edits;  // of every file, before those of the slice

    SyntheticSeries();
    Ramp rampOf(int phase = 0) const;
    // The affine a reader must come to: slices ascend along row x column.
    glm::dmat4 expectedAffine() const;
};

// In the order phase by phase, place by place.
std::vector<Slice> slicesOf(const SyntheticSeries& series);
// The raw value the ramp makes of this pixel; fails the test when the cells cannot hold it.
int rawAt(const SyntheticSeries& series, const Slice& slice, int i, int j);

// One file per slice into `folder`; their paths in the order of the slices.
std::vector<std::filesystem::path> writeFiles(const std::filesystem::path& folder,
                                              const SyntheticSeries& series,
                                              const std::vector<Slice>& slices);
inline std::vector<std::filesystem::path> writeFiles(const std::filesystem::path& folder,
                                                     const SyntheticSeries& series) {
    return writeFiles(folder, series, slicesOf(series));
}

// Where a multi-frame file keeps what. Frames are in the order of the slices.
struct MultiFrame {
    std::string sopInstanceUid = "2.25.2000";
    bool sharedMeasures = true;        // Pixel Measures, else per frame
    bool sharedOrientation = true;     // Plane Orientation
    bool sharedTransformation = true;  // Pixel Value Transformation; needs equal slopes
    bool functionalGroups = true;
    bool dimensions = true;  // Multi-frame Dimension: organisation, index, values of each frame
    int firstDimensionIndex = 1;
    std::vector<Edit> edits;  // of the dataset, last
};
void writeMultiFrame(const std::filesystem::path& file, const SyntheticSeries& series,
                     const std::vector<Slice>& slices, const MultiFrame& options = {});

// A file without an image: a report, a presentation state, a structure set.
struct Shell {
    std::string sopClassUid;
    std::string modality;
    std::string sopInstanceUid = "2.25.3000";
    std::string seriesUid = "2.25.3001";
    std::vector<Edit> edits;
};
void writeShell(const std::filesystem::path& file, const Shell& shell);

// An image that a DICOMDIR lists.
struct DirectoryEntry {
    std::string fileId;  // as it stands in it: components separated by backslashes
    std::string sopInstanceUid = "2.25.5001";
    std::string seriesUid = {};  // of the series that it stands under; empty: under none
    int instanceNumber = 1;
};
// A DICOMDIR that refers to these files, whose offsets are all 0.
void writeDirectoryOf(const std::filesystem::path& file, const std::vector<DirectoryEntry>& entries);
void writeDirectory(const std::filesystem::path& file, const std::vector<std::string>& fileIds);

// Editing. A test fails when DCMTK refuses.
void put(DcmItem& item, const DcmTagKey& tag, const std::string& value);
void putNumber(DcmItem& item, const DcmTagKey& tag, double value);
void putWord(DcmItem& item, const DcmTagKey& tag, int value);  // US or SS of 16 bits, as US
void erase(DcmItem& item, const DcmTagKey& tag);
// The first item of a sequence, made when missing.
DcmItem& nested(DcmItem& item, const DcmTagKey& sequence);
DcmItem& appended(DcmItem& item, const DcmTagKey& sequence);
// A Decimal String of at most 16 characters.
std::string decimal(double value);
std::string decimals(const std::vector<double>& values);
// Changes a file that is already there.
void editFile(const std::filesystem::path& file, const Edit& edit);

// Every voxel holds what the ramp says about its place.
void expectRamp(const Volume& volume, const Ramp& ramp, double tolerance = 0.5);
void expectGrid(const Volume& volume, const glm::ivec3& size, const glm::dmat4& worldFromVoxel,
                double toleranceMm = 1e-4);
// Both, with what the series says.
void expectVolumeOf(const Volume& volume, const SyntheticSeries& series, int phase = 0);

}  // namespace macula::dicom::test
