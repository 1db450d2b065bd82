#include "app/frame/scene_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace macula::app {

SceneNames::Scene SceneNames::sceneOf(const Drawing& drawing) {
    return {.transferFunction = drawing.transferFunction,
            .lights = drawing.lights,
            .clip = drawing.clip ? *drawing.clip : Clip{},
            .additions = drawing.additions ? *drawing.additions : Additions{},
            .settings = settingsOfLight(drawing)};
}

std::string SceneNames::of(std::uint64_t study, const Drawing& drawing) {
    if (study != study_) named_.clear();
    study_ = study;
    Scene now = sceneOf(drawing);
    const auto found = std::ranges::find(named_, now, &Named::scene);
    if (found != named_.end()) {
        std::rotate(found, found + 1, named_.end());
    } else {
        if (named_.size() == kRemembered) named_.erase(named_.begin());
        named_.push_back({std::move(now), count_++});
    }
    return fmt::format("study {} scene {}", study, named_.back().number);
}

}  // namespace macula::app
