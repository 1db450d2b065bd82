#include "viewer/scene_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace macula::viewer {

std::string SceneNames::of(std::uint64_t study, const Drawing& drawing) {
    if (study != study_) named_.clear();
    study_ = study;
    Named now{.transferFunction = drawing.transferFunction,
              .lights = drawing.lights,
              .clip = drawing.clip ? *drawing.clip : Clip{},
              .settings = drawing.settings};
    // What light does not depend on.
    const trace::Settings usual;
    now.settings.seed = usual.seed;
    now.settings.exposure = usual.exposure;
    now.settings.denoising = usual.denoising;
    now.settings.errorThreshold = usual.errorThreshold;
    now.settings.window = usual.window;
    const auto found = std::find(named_.begin(), named_.end(), now);
    const auto number = found - named_.begin();
    if (found == named_.end()) named_.push_back(std::move(now));
    return fmt::format("study {} scene {}", study, number);
}

}  // namespace macula::viewer
