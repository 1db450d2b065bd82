// Names for all that decides what a peripheral model is of.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viewer/frame_input.h"

namespace macula::viewer {

// The same name means the same volume, transfer function, clip, lights, and settings that light depends on;
// what is shown again has the name it had. No patient data.
class SceneNames {
  public:
    // Of a drawing that is complete, of the study of that number.
    std::string of(std::uint64_t study, const Drawing& drawing);

  private:
    struct Named {
        std::shared_ptr<const TransferFunction> transferFunction;  // kept, so that no other takes its place
        std::shared_ptr<const trace::LightRig> lights;
        Clip clip;
        trace::Settings settings;

        bool operator==(const Named&) const = default;
    };
    std::uint64_t study_ = 0;
    std::vector<Named> named_;
};

}  // namespace macula::viewer
