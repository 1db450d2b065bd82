// Clips as JSON, for any volume; presets/schema/clip.schema.json is the reference.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/volume/clip.h"

namespace macula {

// A clip in fractions of the volume's box (Volume::worldBox), along the patient's axes.
struct ClipPreset {
    std::string name;                  // key, as in `--clip left-half`
    std::string title;                 // for people
    Clip clip;                         // the volume's box is [0, 1]^3; normals are not scaled
    std::vector<glm::dvec3> planesAt;  // a point on each plane; offsets are not known yet
    bool greyFacesOfSeries = false;    // greyFaces uses the window of the series

    bool operator==(const ClipPreset&) const = default;
};

// Fails with inputNotUsable: the message names the line or the key, the hint says what was expected. `where`
// names the file in the error.
Result<ClipPreset> clipPresetFromJson(std::string_view text, const std::string& where);

// Reading this text gives the same clip, except for the last bits of numbers.
std::string toJson(const ClipPreset& preset);

// The clip for this volume, in patient LPS mm. Uses seriesWindow for the window of the series.
Clip clipFor(const ClipPreset& preset, const Volume& volume);

}  // namespace macula
