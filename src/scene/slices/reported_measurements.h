// Measurements of a study as a report in DICOM, for the archive and other programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/stack/series.h"
#include "dicom/write/measurement_report.h"
#include "slices/measurement.h"
#include "study/open/found_volumes.h"

namespace macula::scene {

struct SaidMeasurements {
    dicom::MeasurementReport report;
    dicom::SecondaryCapture::Source image;  // one of those that the report refers to
    std::vector<Text> leftOut;              // sentences: what the report does not hold
};

// The volume that was measured on, with the values of the file (OpenedStudy::measured), and the images that
// it was made of.
struct MeasuredImages {
    const Volume& volume;
    const dicom::Series& series;
    const dicom::Stack& stack;
};

// A measurement in the plane of an image is said in the pixels of that image; any other one, in a turned
// plane or between two images, in space, and the report names the images that it lies between. A distance or
// a line has "Length", an angle "Angle", a Cobb angle "Cobb angle", and a lesion with two axes "Long Axis"
// and "Short Axis", each from a line of its own; an ellipse or an outline has "Area", and the mean, standard
// deviation, minimum and maximum of the values in it, in the unit of the volume. One without a label is
// called by its kind and number. Left out are arrows, those whose value is not defined, and those in space
// where the images share no frame of reference. `isDeidentified` also leaves out what a person typed. Error:
// usage if nothing is left, or if an image has no UID.
Result<SaidMeasurements> saidMeasurements(std::span<const slices::Measurement> measurements,
                                          const MeasuredImages& of, bool isDeidentified = false);

// All that a report is made of, for another thread.
struct ReportRequest {
    std::vector<slices::Measurement> measurements;
    std::shared_ptr<const Volume> volume;              // as MeasuredImages::volume
    std::shared_ptr<const study::FoundVolumes> found;  // not null
    std::size_t volumeIndex = 0;                       // of the volume among them
    bool isDeidentified = false;
};

// Returns SaidMeasurements::leftOut. Errors: those of saidMeasurements and dicom::writeMeasurementReport;
// nothing is written then.
Result<std::vector<Text>> writeMeasurementReport(const std::filesystem::path& path,
                                                 const ReportRequest& request);

}  // namespace macula::scene
