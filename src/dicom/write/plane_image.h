// Writes a plane through a volume as an image that keeps its place in the patient: Secondary Capture (PS3.3
// A.8.1) with one value in each pixel, and the attributes of an image plane (C.7.6.2) and of values (C.11.1).
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/write/new_object.h"
#include "dicom/write/referenced_series.h"

namespace macula::dicom {

// What all images of a series share.
struct PlaneSeries {
    std::string seriesInstanceUid;    // a new one
    std::string frameOfReferenceUid;  // of the volume
    std::string modality = "OT";      // of the volume
    std::string seriesDescription;    // at most 64 characters, ASCII, without a backslash
    std::string derivation;           // how the planes were made, in words; at most 1024 such characters
    int columns = 0;                  // 1 to 65535 each
    int rows = 0;
    double spacingMm = 1.0;               // of pixels, along rows and columns
    double thicknessMm = 0.0;             // of the slab; 0: of the plane alone, which is not written
    std::optional<double> stepMm;         // from plane to plane; nothing: they are not parallel
    UnitsFromStored unitsFromStored;      // of pixels
    bool isHounsfield = false;            // else values are "unspecified" (C.11.1.1.2)
    std::optional<DisplayWindow> window;  // in units
    bool isFromLossyImages = false;       // then the file does not claim that nothing was lost
    std::string bodyPart;                 // Body Part Examined; may be empty
    std::optional<double> heightMm;       // along the body, if known: whether a face may be seen
};

struct PlaneImage {
    glm::dvec3 positionMm{0.0};                 // of the centre of the first pixel, patient LPS
    glm::dvec3 rowDirection{1.0, 0.0, 0.0};     // along a row, to the next column
    glm::dvec3 columnDirection{0.0, 1.0, 0.0};  // down a column, to the next row
    std::span<const std::uint16_t> pixels;      // row by row; 0 is padding: no value there
    int number = 1;                             // from 1, in the series
    std::vector<ReferencedImage> sources;       // the images that the plane was made of
};

// 16 bits, explicit VR little endian. Each call makes a new instance. Deidentified, the frame of reference
// and the sources have other UIDs (standInUid). The file is written whole or not at all. Fails with usage for
// sizes, texts and directions that do not fit; as writeObject otherwise.
Result<void> writePlaneImage(const std::filesystem::path& path, const PlaneSeries& series,
                             const PlaneImage& image, const NewObject& object);

}  // namespace macula::dicom
