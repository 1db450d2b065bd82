// Measurements on images that are no volume. Points are (column, row) in pixels of one frame, from the outer
// corner of its first pixel, so they do not depend on how the image is shown. What a length means is said by
// what holds where it was drawn: a region of ultrasound, or the size of the pixels (PS3.3 10.7, C.8.5.5).
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "dicom/planar/planar_frame.h"
#include "dicom/planar/planar_header.h"

namespace macula::study {

struct ImageMeasurement {
    enum class Kind {
        distance,  // both ends
        angle,     // leg, vertex, leg
        ellipse,   // two opposite corners of its box, along rows and columns
        cobb,      // the ends of one line, then those of the other
    };
    Kind kind = Kind::distance;
    std::string label = {};  // a person's words; may be empty, and may name a patient
    std::string image = {};  // imageKey of the file
    int frame = 0;           // of the file, from 0: no other frame shows it
    std::vector<glm::dvec2> points;

    bool operator==(const ImageMeasurement&) const = default;
};

inline constexpr std::size_t kMostImageMeasurements = 1000;

// Stands for an image where it is kept: a digest of its UID, which may name a patient.
std::string imageKey(std::string_view sopInstanceUid);

// The name in files: "distance", "angle", "ellipse", "cobb angle".
std::string_view kindOf(const ImageMeasurement& measurement);
std::size_t pointsOf(ImageMeasurement::Kind kind);  // how many it has

// What holds at places of an image.
struct ImageScale {
    enum class Of {
        region,    // of ultrasound, with units of its own
        pixels,    // PlanarHeader::pixelSize
        unknown,   // the file gives none
        outside,   // beside all regions of ultrasound
        different  // in regions whose scales differ
    };
    using Unit = dicom::UltrasoundRegion::Unit;
    Of of = Of::unknown;
    // Of a region; millimetres of pixels; otherwise none, and 1 for a column.
    Unit unitX = Unit::none;
    Unit unitY = Unit::none;
    double perColumn = 1.0;
    double perRow = 1.0;
    std::optional<dicom::PixelSize> size = {};  // of pixels

    // Whether lengths have one unit in all directions.
    bool isEven() const { return unitX == unitY; }
};
ImageScale scaleOver(const dicom::PlanarHeader& header, std::span<const glm::dvec2> points);

struct PixelValues {
    std::size_t pixels = 0;
    double mean = 0.0;
    double deviation = 0.0;  // of a sample (n - 1); NaN for one pixel
    double low = 0.0;
    double high = 0.0;
};

struct Quantity {
    double value = 0.0;  // NaN: not defined
    std::string unit;    // "mm", "mm²", "px", "px²", "s", "cm/s", "°"

    bool operator==(const Quantity&) const = default;
};

struct MeasuredImage {
    // One, or two in a region whose units differ: across and down.
    std::vector<Quantity> quantities;
    std::optional<PixelValues> values;  // of an ellipse on grey
    Text basis;  // what lengths rest on; empty: they are the object's, or there are none
};

// `pixels` is null until the frame is read: an ellipse then has no values. Padding does not count. An ellipse
// without the middle of a pixel has the value of the pixel around its own middle.
MeasuredImage measured(const ImageMeasurement& measurement, const dicom::PlanarHeader& header,
                       const dicom::PlanarFrame* pixels);
// "12.3 mm, at the detector"; "0.35 s, 42.1 cm/s"; "120 ± 14, min 35, max 160, 310 mm²".
Text textOf(const MeasuredImage& measured);

// One row of a table for other programs.
struct ListedImageMeasurement {
    ImageMeasurement measurement;
    int imageNumber = 0;  // of the series, as it is shown, from 1
    MeasuredImage measured;
};
// RFC 4180, in UTF-8, as scene::measurementsCsv: a line of names, then one for each measurement.
std::string csvOf(std::span<const ListedImageMeasurement> measurements);

}  // namespace macula::study
