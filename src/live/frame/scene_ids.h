// Scene names: short names for everything that a peripheral model depends on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scene/drawing/drawing.h"

namespace macula::live {

// The same name means the same volume, transfer function, clip, additions, lights, and settings that light
// depends on. A scene shown again keeps its name while it is among the last kRemembered. No patient data.
class SceneIds {
  public:
    static constexpr std::size_t kRemembered =
        256;  // scenes; each step of editing a transfer function is another scene, and so is each phase

    // The name of a complete drawing of the study with that number. `volume`: of which phase of the study; a
    // caller whose studies have one volume each may leave it out.
    std::string of(std::uint64_t study, const scene::Drawing& drawing,
                   const std::shared_ptr<const Volume>& volume = nullptr);

  private:
    // Identity of an object, without keeping it alive: masks, volumes and segments are large.
    template <class T>
    struct Which {
        std::weak_ptr<const T> owner;  // tells it from a later object at the same address
        const T* object = nullptr;

        bool operator==(const Which& b) const {
            return object == b.object && !owner.owner_before(b.owner) && !b.owner.owner_before(owner);
        }
    };
    template <class T>
    static Which<T> take(std::shared_ptr<const T>& from);

    struct Scene {
        std::shared_ptr<const TransferFunction> transferFunction;  // kept alive: the address is not reused
        std::shared_ptr<const trace::LightRig> lights;
        Clip clip;            // without labels and bits of its mask, which follow
        Additions additions;  // without volume and box, which follow
        Which<Volume> volume;
        Which<LabelMap> labels;
        Which<MaskBits> bits;
        Which<Volume> second;
        Which<TintBox> segments;
        trace::Settings settings;

        bool operator==(const Scene&) const = default;
    };
    static Scene sceneOf(const scene::Drawing& drawing);

    struct Named {
        Scene scene;
        std::uint64_t number;
    };
    std::uint64_t study_ = 0;
    std::uint64_t count_ = 0;
    std::vector<Named> named_;  // the latest named last
};

}  // namespace macula::live
