// Names for all that decides what a peripheral model is of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/drawing/drawing.h"

namespace macula::app {

// The same name means the same volume, transfer function, clip, additions, lights, and settings that light
// depends on; what is shown again has the name it had, while it is among the last that were named. No patient
// data.
class SceneNames {
  public:
    static constexpr std::size_t kRemembered =
        64;  // scenes; each step of editing a transfer function is another one

    // The name of a complete drawing of the study with that number.
    std::string of(std::uint64_t study, const Drawing& drawing);

  private:
    // The same object, told without keeping it: masks, volumes and segments are large.
    template <class T>
    struct Which {
        std::weak_ptr<const T> owner;  // no other takes its place while this is known
        const T* object = nullptr;

        bool operator==(const Which& b) const {
            return object == b.object && !owner.owner_before(b.owner) && !b.owner.owner_before(owner);
        }
    };
    template <class T>
    static Which<T> take(std::shared_ptr<const T>& from);

    struct Scene {
        std::shared_ptr<const TransferFunction> transferFunction;  // kept, so that no other takes its place
        std::shared_ptr<const trace::LightRig> lights;
        Clip clip;            // without the four that follow
        Additions additions;  // likewise
        Which<LabelMap> labels;
        Which<MaskBits> bits;
        Which<Volume> second;
        Which<TintBox> segments;
        trace::Settings settings;

        bool operator==(const Scene&) const = default;
    };
    static Scene sceneOf(const Drawing& drawing);

    struct Named {
        Scene scene;
        std::uint64_t number;
    };
    std::uint64_t study_ = 0;
    std::uint64_t count_ = 0;
    std::vector<Named> named_;  // the one named last stands last
};

}  // namespace macula::app
