#include "live/frame/scene_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace macula::live {

template <class T>
SceneIds::Which<T> SceneIds::take(std::shared_ptr<const T>& from) {
    Which<T> which{from, from.get()};
    from.reset();
    return which;
}

SceneIds::Scene SceneIds::sceneOf(const scene::Drawing& drawing) {
    Scene scene;
    scene.transferFunction = drawing.transferFunction;
    scene.lights = drawing.lights;
    if (drawing.clip) scene.clip = *drawing.clip;
    if (drawing.additions) scene.additions = *drawing.additions;
    scene.settings = scene::settingsOfLight(drawing);
    if (std::optional<Mask>& mask = scene.clip.mask) {
        scene.labels = take(mask->labels);
        scene.bits = take(mask->bits);
    }
    if (scene.additions.second) scene.second = take(scene.additions.second->volume);
    if (scene.additions.tints) scene.segments = take(scene.additions.tints->box);
    return scene;
}

std::string SceneIds::of(std::uint64_t study, const scene::Drawing& drawing,
                         const std::shared_ptr<const Volume>& volume) {
    if (study != study_) named_.clear();
    study_ = study;
    Scene now = sceneOf(drawing);
    now.volume = {volume, volume.get()};
    const auto found = std::ranges::find(named_, now, &Named::scene);
    if (found != named_.end()) {
        std::rotate(found, found + 1, named_.end());
    } else {
        if (named_.size() == kRemembered) named_.erase(named_.begin());
        named_.push_back({std::move(now), count_++});
    }
    return fmt::format("study {} scene {}", study, named_.back().number);
}

}  // namespace macula::live
