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

// Brings the scene of an input to the device, part by part; comparing both shows which parts are missing.
//
// Used by the render thread alone.
class AppliedScene {
  public:
    explicit AppliedScene(RenderReports& reports) : reports_(reports) {}

    // Whether apply() would change what a peripheral model is of, but for the light.
    bool hasOtherMatter(const FrameInput& input) const;
    // False: `interrupted` stopped it between two parts, each of which may take long. What is done stays
    // done, so that a hand that never rests does not keep the scene from being applied. Reports what takes
    // long, and the outline.
    Result<bool> apply(const FrameInput& input, TracedPictures& traced,
                       const std::function<bool()>& interrupted);

    // A new device has nothing.
    void forget() { parts_ = {}; }
    // After a failure nobody knows how far the tracer got.
    void distrust();

  private:
    struct Parts {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const TransferFunction> transferFunction;
        std::shared_ptr<const trace::LightRig> lights;
        std::optional<std::shared_ptr<const Clip>> clip;                      // none: unknown
        std::optional<std::shared_ptr<const Additions>> additions = nullptr;  // none: unknown
    };

    // Each leaves the part unknown when it fails: the tracer has neither the old one nor the new one then.
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
