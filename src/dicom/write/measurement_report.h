// Writes what was measured as a report for the archive: a Comprehensive 3D SR (PS3.3 A.35.13) by the template
// Measurement Report (PS3.16 TID 1500), which other viewers show over the images.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/coded_name.h"
#include "base/result.h"
#include "dicom/write/new_object.h"
#include "dicom/write/referenced_series.h"

namespace macula::dicom {

struct ReportedNumber {
    CodedName name;  // what it is
    CodedName unit;  // by UCUM where that has one
    double value = 0.0;
    bool isOfSecond = false;  // comes from ReportedMeasurement::second; otherwise from its points
};

// In pixels of one image, (column, row), as in PS3.3 C.18.6.1.2: (0, 0) is the outer corner of the first
// pixel, whose centre is (0.5, 0.5).
struct PointsOnImage {
    std::size_t image = 0;  // among those of the report
    int frame = 0;          // of its frames, from 1; 0: it has only one
    std::vector<glm::dvec2> pointsPx;
};

// Patient LPS, in the frame of reference of the report.
struct PointsInSpace {
    std::vector<glm::dvec3> pointsMm;
};

using ReportedPoints = std::variant<PointsOnImage, PointsInSpace>;

enum class ReportedShape {
    polyline,  // through its points; the numbers come from it (TID 1501)
    ellipse,   // both ends of the longer axis, then of the shorter one; a region (TID 1410)
    outline,   // through its points, and back to the first, which is not repeated; a region
};

struct ReportedMeasurement {
    std::string label;        // UTF-8, not empty; may name a patient
    std::string trackingUid;  // the same for the same measurement in several reports
    std::string comment;      // a sentence for whoever reads the numbers, in English; may be empty
    ReportedShape shape = ReportedShape::polyline;
    ReportedPoints points;
    std::optional<ReportedPoints> second = {};  // another polyline, such as the short axis of a lesion
    std::vector<ReportedNumber> numbers;        // at least one
};

struct MeasurementReport {
    // The series that was measured on, and those of its images that the measurements lie on or between.
    PresentedSeries series;
    std::string modality;  // of the series
    std::vector<ReportedMeasurement> measurements;
};

// Explicit VR little endian; complete, and not verified by anybody. The observer is the program: it does not
// know the person. Texts and names are in the character set of the image, or in UTF-8 if a label needs it. If
// deidentified, the caller leaves out labels that a person typed. Each call makes a new series and instance.
// The file is written whole or not at all, in place of one that is there. Fails with usage for no
// measurements, numbers that are not finite or beyond float32, points in space without a frame of reference,
// images without UIDs, and a missing image unless deidentified; with inputNotUsable when the image cannot be
// read or is another one; with outputNotWritable.
Result<void> writeMeasurementReport(const std::filesystem::path& path, const MeasurementReport& report,
                                    const NewObject& object);

}  // namespace macula::dicom
