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
    Clip clip;                         // frame: the box is [0, 1]^3, and normals are not scaled with it
    std::vector<glm::dvec3> planesAt;  // a point of each plane, whose offsets are still unknown
    bool greyFacesOfSeries = false;    // the window is that of the series

    bool operator==(const ClipPreset&) const = default;
};

// Fails with inputNotUsable; the message tells the line or the key, the hint what was expected. `where` is
// the file, for the error.
Result<ClipPreset> clipPresetFromJson(std::string_view text, const std::string& where);

// Reading it back gives the same clip, to the last bits of its numbers.
std::string toJson(const ClipPreset& preset);

// The clip for this volume, in patient LPS mm. The window of the series is seriesWindow.
Clip clipFor(const ClipPreset& preset, const Volume& volume);

}  // namespace macula
