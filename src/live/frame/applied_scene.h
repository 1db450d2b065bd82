// The scene that the tracer has on the device.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "base/volume.h"
#include "live/frame/frame_input.h"
#include "live/frame/render_reports.h"
#include "live/frame/traced_pictures.h"

namespace macula::live {

// Brings the scene of an input to the device: part by part, and only parts that differ from those applied.
//
// Used by the render thread alone.
class AppliedScene {
  public:
    explicit AppliedScene(RenderReports& reports) : reports_(reports) {}

    // Whether apply() would change anything that a peripheral model depends on, other than the lights.
    bool hasOtherMatter(const FrameInput& input) const;
    // Returns false if `interrupted` stopped it between two parts; one part may take long. Parts that are
    // applied stay so: even if inputs never pause, the scene is complete some time. Reports parts that take
    // long, and the outline.
    Result<bool> apply(const FrameInput& input, TracedPictures& traced,
                       const std::function<bool()>& interrupted);

    // For a new device, which has no parts yet.
    void forget() { parts_ = {}; }
    // For a failure, after which nobody knows which parts the tracer has.
    void distrust();

  private:
    struct Parts {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const TransferFunction> transferFunction;
        std::shared_ptr<const trace::LightRig> lights;
        std::optional<std::shared_ptr<const Clip>> clip;                      // none: unknown
        std::optional<std::shared_ptr<const Additions>> additions = nullptr;  // none: unknown
    };

    // If one fails, its part stays unknown: the tracer then has neither the old one nor the new one.
    Result<void> setVolume(const FrameInput& input, TracedPictures& traced);
    Result<void> setClip(const FrameInput& input, TracedPictures& traced);
    Result<void> setAdditions(const FrameInput& input, TracedPictures& traced);
    Result<void> setTransferFunction(const FrameInput& input, TracedPictures& traced);
    Result<void> setLights(const FrameInput& input, TracedPictures& traced);
    Result<void> reportOutline(const FrameInput& input, TracedPictures& traced);
    void reportPreparing() const;

    RenderReports& reports_;
    Parts parts_;
    std::optional<std::uint64_t> outlineOf_;  // the study whose outline was reported for these parts
};

}  // namespace macula::live
