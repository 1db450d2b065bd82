// An image as a NIfTI, NRRD or MetaImage file holds it, and its way to and from a Volume.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::formats {

enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t bytesOf(ScalarType type);
std::string_view nameOf(ScalarType type);  // "int16"

// What a header says of the image.
struct RawImageLayout {
    glm::ivec3 size{0};              // of one volume
    std::size_t volumes = 1;         // in the file, one behind the other
    glm::dmat4 worldFromVoxel{1.0};  // patient LPS mm
    ScalarType type = ScalarType::int16;
    double slope = 1.0;  // value = slope * raw + intercept; the slope may be negative, not 0
    double intercept = 0.0;
    // What valueNote() told of a file that Macula wrote: other programs name no unit, and none is guessed.
    Unit unit = Unit::raw;
    std::string modality;
    bool isCalibrated = true;              // as in Provenance
    std::vector<std::string> assumptions;  // sentences, as in Provenance

    std::uint64_t bytes() const;  // of one volume
};

// Says which of several volumes it is, counted from 1, among the assumptions. Fails with usage where the file
// has no such one.
Result<void> chooseVolume(RawImageLayout& layout, std::size_t volume);

// What Macula writes into a file beside the values: "Macula|int16|HU|CT", and "|uncalibrated" behind it where
// that is so, at most 79 characters; empty for calibrated ones without a unit.
std::string valueNote(const RawImageLayout& layout);
inline constexpr std::string_view kValueNoteField = "MaculaValues";  // where NRRD and MetaImage keep it
// Fills in unit and modality, and that lengths are estimates. Takes no unit from a note whose type is not
// that of the file: then another program has changed the values since.
void readValueNote(std::string_view note, RawImageLayout& layout);

struct RawImage : RawImageLayout {
    std::vector<std::byte> data;  // i fastest, in the byte order of this machine
};

// Fails with inputNotUsable when the image is no volume (a side below 2), or its header claims more than
// `bytesInFile` can hold (deflate packs at most 1 : 1032), and with outOfMemory when it does not fit.
Result<void> checkLayout(const RawImageLayout& layout, std::uint64_t bytesInFile, bool compressed);

// Values in units: int16 when each is a whole number in its range, else uint16 when so, else float32. Padding
// keeps its value.
Result<RawImage> rawImageOf(const Volume& volume, Progress& progress);
Result<RawImage> rawImageOf(const LabelMap& map, Progress& progress);

// 16 bits when that is exact, else float32. Values that are no finite number are padding, and counted; whole
// numbers beyond 2^53 are rounded, and that is among the assumptions.
Result<std::shared_ptr<const Volume>> volumeOf(RawImage image, Progress& progress);

}  // namespace macula::formats
