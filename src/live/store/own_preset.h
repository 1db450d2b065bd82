// A preset of the user's own: a transfer function under a name they chose, alone or with the other settings
// of the picture.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/camera.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/state/study_state.h"

namespace macula::live {

// Counts UTF-8 code points of any script.
inline constexpr std::size_t kMostPresetNameLetters = 48;

// The name as stored: one line, without blanks at its ends and with single ones within. Fails with usage if
// it is empty, longer than kMostPresetNameLetters or not UTF-8, or has invisible letters or ones that reverse
// the text direction, which could make one name look like another.
Result<std::string> checkedPresetName(std::string_view typed);
// The name nearest to `text` that checkedPresetName accepts: for names from files.
std::string nearestPresetName(std::string_view text);
// Whether both are the same name, ignoring the case of A to Z.
bool isSamePresetName(std::string_view a, std::string_view b);

// A camera that fits other patients: eye and target relative to the centre of the volume's box, and the
// height of a parallel picture, all in units of the box's diagonal.
struct RelativeCamera {
    Camera camera;

    bool operator==(const RelativeCamera&) const = default;
};
RelativeCamera relativeTo(const Camera& camera, const Volume& volume);
Camera cameraIn(const RelativeCamera& camera, const Volume& volume);

// The settings besides the curve: look and numbers, lights, windows, and clip.
struct SeenLook {
    scene::StudyState state;  // without preset, camera and what belongs to one study
    std::optional<RelativeCamera> camera = {};

    bool operator==(const SeenLook&) const = default;
};
// The look and camera of `state`, without what belongs to one study: measurements, panes, table removal.
SeenLook seenOf(const scene::StudyState& state, const Volume& volume);

struct OwnPreset {
    std::string id;  // never changes: "own-" and hexadecimal digits
    // Its title is the preset's name for people, its name a key as in files. Never null.
    std::shared_ptr<const TransferFunction> function;
    std::optional<SeenLook> seen = {};

    const std::string& title() const { return function->title; }
    bool operator==(const OwnPreset& b) const;  // by value; ignores other members of the document
};

// Applies the preset to `next`, except the camera, which the caller sets. Leaves the windows as they are if
// the preset does not suit the volume's unit, or if that is raw.
void use(const OwnPreset& preset, const Volume& volume, scene::StudyState& next);

// The JSON in the store. Reading gives an equal preset. Fails with inputNotUsable, also for a document of
// another version of the program.
std::string toJson(const OwnPreset& preset);
Result<OwnPreset> ownPresetFromJson(const std::string& id, std::string_view text);

}  // namespace macula::live
