// How a volume is drawn, and which part of it.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/text.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/lights/background_colour.h"

namespace macula::scene {

// Complete once it has a transfer function and lights.
struct Drawing {
    std::shared_ptr<const TransferFunction> transferFunction{};
    std::shared_ptr<const trace::LightRig> lights{};
    std::shared_ptr<const Clip> clip{};            // null: all of the volume is shown
    std::shared_ptr<const Additions> additions{};  // second volume, segment colours; null: none
    trace::Settings settings{};
    std::optional<BackgroundColour> background{};  // nothing: nearly black in a window, black in a file
    Text remarks{};                                // text shown with its pictures; no patient data

    bool operator==(const Drawing&) const = default;
};

// The linear light of a window's background (FrameInput::background) when the drawing has none.
inline constexpr glm::vec3 kWindowBackground{0.0025f};
glm::vec3 backgroundInWindow(const Drawing& drawing);

// Whether the faces of its clip show the values through a window (Clip::greyFaces).
bool hasGreyFaces(const Drawing& drawing);

// The settings of a drawing, with those that do not affect the light at their defaults.
trace::Settings settingsOfLight(const Drawing& drawing);

}  // namespace macula::scene
