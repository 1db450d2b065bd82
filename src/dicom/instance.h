// One image file, as its header describes it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dicom/dataset.h"
#include "dicom/geometry.h"
#include "dicom/intensity.h"

namespace macula::dicom {

// An optional is empty when the file does not say, or says nonsense. Paths and UIDs may name a patient: never
// logged.
struct Instance {
    std::filesystem::path file;
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::string transferSyntaxUid;
    std::string frameOfReferenceUid;
    std::vector<std::string> imageType;
    std::string photometricInterpretation;
    std::optional<int> instanceNumber;
    int columns = 0;
    int rows = 0;
    int frames = 1;
    int samplesPerPixel = 1;
    bool perFrameGeometry = false;  // enhanced multi-frame: geometry lies in functional groups
    bool hasModalityLut = false;
    bool lossy = false;  // compressed with loss, now or before

    std::optional<glm::dvec3> positionMm;
    std::optional<ImagePlane> plane;  // needs position, orientation and pixel spacing
    bool hasPixelSpacing = false;

    std::optional<CellFormat> format;
    std::optional<double> slope;      // RescaleSlope
    std::optional<double> intercept;  // RescaleIntercept
    bool rescaleInvalid = false;      // present, and not usable: no number, or a slope of 0
    std::string rescaleType;
    bool strayBytes = false;  // see HeaderFile
    std::optional<RawRange> padding;
};

// From a header that has Rows and Columns.
Instance readInstance(const std::filesystem::path& file, const Dataset& header);

// What intensity.h needs, with 1 and 0 for a missing slope and intercept (series.h tells of that).
SliceIntensity sliceIntensity(const Instance& instance);

}  // namespace macula::dicom
