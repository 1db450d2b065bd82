// How a volume is drawn, and what of it.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/lights/background_colour.h"

namespace macula::app {

// Complete where it has a transfer function and lights.
struct Drawing {
    std::shared_ptr<const TransferFunction> transferFunction{};
    std::shared_ptr<const trace::LightRig> lights{};
    std::shared_ptr<const Clip> clip{};            // null: all of the volume is shown
    std::shared_ptr<const Additions> additions{};  // to the volume and of it; null: there are none
    trace::Settings settings{};
    std::optional<BackgroundColour> background{};  // nothing: nearly black in a window, black in a file
    std::string remarks{};                         // what has to be said of pictures of it; no patient data

    bool operator==(const Drawing&) const = default;
};

// The light of the background where a window shows it: FrameInput::background.
inline constexpr glm::vec3 kWindowBackground{0.0025f};
glm::vec3 backgroundInWindow(const Drawing& drawing);

// Whether faces of its clip show the values themselves.
bool hasGreyFaces(const Drawing& drawing);

// The settings of a drawing with those that light does not depend on at their defaults.
trace::Settings settingsOfLight(const Drawing& drawing);

}  // namespace macula::app
