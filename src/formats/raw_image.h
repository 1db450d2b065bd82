// An image as a NIfTI, NRRD or MetaImage file holds it, and its conversion to and from a Volume.
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
#include "formats/volume_axis.h"

namespace macula::formats {

enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t bytesOf(ScalarType type);
std::string_view nameOf(ScalarType type);  // "int16"

// The header of the image.
struct RawImageLayout {
    glm::ivec3 size{0};              // of one volume
    std::size_t volumes = 1;         // in the file
    VolumeAxis axis = {};            // of these
    glm::dmat4 worldFromVoxel{1.0};  // patient LPS mm
    ScalarType type = ScalarType::int16;
    double slope = 1.0;  // value = slope * raw + intercept; the slope may be negative, not 0
    double intercept = 0.0;
    // From the valueNote() of a file that Macula wrote: other programs name no unit, and Macula does not
    // guess.
    Unit unit = Unit::raw;
    std::string modality;
    bool isCalibrated = true;       // as in Provenance
    std::vector<Text> assumptions;  // sentences, as in Provenance

    std::uint64_t bytes() const;  // of one volume
};

// Adds an assumption that states which of several volumes, from 1, is read. usage if the file lacks it.
Result<void> chooseVolume(RawImageLayout& layout, std::size_t volume);

// The note in files that Macula writes: "Macula|int16|HU|CT", followed by "|uncalibrated" if the image is not
// calibrated; at most 79 characters. Empty for a calibrated image without a unit.
std::string valueNote(const RawImageLayout& layout);
inline constexpr std::string_view kValueNoteField = "MaculaValues";  // its field in NRRD and MetaImage
// Sets unit and modality, and whether lengths are estimates. Ignores the unit if type or scaling differ from
// the note, because another program has then changed the values.
void readValueNote(std::string_view note, RawImageLayout& layout);

struct RawImage : RawImageLayout {
    std::vector<std::byte> data;  // i fastest, in the byte order of this machine
};

// The error of a file that could not be written.
Error notWritten();

// inputNotUsable when the image is not a volume (a side below 2), has a side above 65536, or needs more than
// `bytesInFile` can hold (deflate packs at most 1 : 1032); outOfMemory when it does not fit.
Result<void> checkLayout(const RawImageLayout& layout, std::uint64_t bytesInFile, bool compressed);

// Values in units: int16 when that holds all of them exactly, otherwise uint16 when that does, otherwise
// float32. Padding keeps its value.
Result<RawImage> rawImageOf(const Volume& volume, Progress& progress);
Result<RawImage> rawImageOf(const LabelMap& map, Progress& progress);

// 16 bits when raw values are whole numbers that span at most 65535, otherwise float32. Values that are not
// finite become padding; assumptions state how many, and that whole numbers beyond 2^53 were rounded.
Result<std::shared_ptr<const Volume>> volumeOf(RawImage image, Progress& progress);

}  // namespace macula::formats
