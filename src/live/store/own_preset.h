// A preset that a person made: a transfer function under a name of their own, alone or with all else that
// was seen.
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

namespace macula::app {

// Letters of any script, as they are told apart in UTF-8.
inline constexpr std::size_t kMostPresetNameLetters = 48;

// The name as it is kept: one line, without blanks at its ends and with single ones within. usage where
// nothing is left, it is longer than kMostPresetNameLetters, is no UTF-8, or has letters that cannot be seen
// or that turn the direction of what follows, as they could make one name look like another.
Result<std::string> checkedPresetName(std::string_view typed);
// The nearest to `text` that checkedPresetName takes: for names that a file brings.
std::string nearestPresetName(std::string_view text);
// Whether a person would take both for the same: in any case of A to Z.
bool isSamePresetName(std::string_view a, std::string_view b);

// Eye and target in diagonals of the volume's box from its centre, and the height of a parallel picture in
// diagonals, so that it means something for another patient too.
struct RelativeCamera {
    Camera camera;

    bool operator==(const RelativeCamera&) const = default;
};
RelativeCamera relativeTo(const Camera& camera, const Volume& volume);
Camera cameraIn(const RelativeCamera& camera, const Volume& volume);

// What was seen besides the curve: look and numbers, lights, windows, and clip.
struct SeenLook {
    StudyState state;  // nothing of a study, no preset, no camera
    std::optional<RelativeCamera> camera = {};

    bool operator==(const SeenLook&) const = default;
};
// Of a state with its camera. Measurements, panes and what beside the patient is left out are of a study.
SeenLook seenOf(const StudyState& state, const Volume& volume);

struct OwnPreset {
    std::string id;  // the same for ever: "own-" and hexadecimal digits
    // Its title is the preset's name for people, its name a key as in files. Never null.
    std::shared_ptr<const TransferFunction> function;
    std::optional<SeenLook> seen = {};

    const std::string& title() const { return function->title; }
    bool operator==(const OwnPreset& b) const;  // by value; whatever else is in the preset's document
};

// What the state becomes when the preset is used; the camera is who shows it's to set. Windows of a preset
// that does not suit the values of the volume are left as they are, and so are those of raw values.
void use(const OwnPreset& preset, const Volume& volume, StudyState& next);

// As in the store. Reading gives an equal preset. Fails with inputNotUsable: also where another version of
// the program wrote it.
std::string toJson(const OwnPreset& preset);
Result<OwnPreset> ownPresetFromJson(const std::string& id, std::string_view text);

}  // namespace macula::app
