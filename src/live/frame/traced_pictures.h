// The pictures that a window's tracer makes: small ones while a hand moves, and the one with all pixels.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/result.h"
#include "live/frame/filter_course.h"
#include "live/frame/frame_input.h"
#include "live/frame/motion_scale.h"
#include "pipeline/gpu/device.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::app {

// Used by one thread at a time, the one that uses the device. There is one at a time of both: who begins one
// loses the other.
class TracedPictures {
  public:
    static Result<TracedPictures> create(const std::shared_ptr<gpu::Device>& device);

    // The tracer, to change its scene. Whoever does calls sceneChanged(): then no picture is of what is shown
    // any more.
    trace::PathTracer& tracer() { return tracer_; }
    void sceneChanged();
    // Something else is on the device now, or was taken off: nobody knows for what there is room.
    void roomChanged() { pixelsRefused_ = kNoneRefused; }

    // A small picture, denoised where there is room for that.
    Result<void> beginPreview(const FrameInput& input);
    // Adds samples to the small picture; false when `keepGoing` said no, and the next call finishes that.
    Result<bool> tracePreview(const FrameInput& input, const std::function<bool()>& keepGoing);
    std::uint64_t previewSamples() const { return previewSamples_; }
    // How long it took decides how small the next one is: filter and tone map, which grow with its pixels,
    // and all the rest.
    void previewWasShown(double developMs, double otherMs);

    // How long one of all pixels is expected to take until it is worth showing, by what small ones took.
    double expectedFullMs(const FrameInput& input);
    // Whether the traced picture with all pixels is of exactly `input`, and has been worth showing.
    bool hasFull(const FrameInput& input) const;
    // Does nothing when the traced picture is of `input` already, worth showing or not.
    Result<void> beginFull(const FrameInput& input);
    struct Progress {
        bool isNews = false;  // the full picture has become worth showing, or worth showing again
        bool isLast = false;  // and will not change any more
    };
    // A slice of tracing the full picture. `keepGoing` is asked between dispatches of some 40 ms.
    Result<Progress> traceFull(const FrameInput& input, const std::function<bool()>& keepGoing);

    // The picture that there is, small or full, as it is to be seen. It is on the device, see
    // PathTracer::display.
    Result<const gpu::Image*> display(const glm::vec3& background);
    // Whether it is weighed against what splats show, until it is as good as it gets; and what to weigh. It
    // is on the device, see PathTracer::noisyLight.
    bool isNoisy() const { return !isLast_ && course_.isNoisy(); }
    Result<trace::TracedLight> light() { return isNoisy() ? tracer_.noisyLight() : tracer_.light(); }

    int width() const { return view_.width; }
    int height() const { return view_.height; }
    int scale() const { return scale_; }  // window pixels along each side of a picture's pixel
    // Statistics of the picture that there is.
    Result<trace::Statistics> statistics() const { return tracer_.statistics(); }

    static std::uint64_t sampleLimit(const FrameInput& input);
    static std::uint64_t previewLimit(const FrameInput& input);

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::int64_t kNoneRefused = std::numeric_limits<std::int64_t>::max();

    TracedPictures(trace::PathTracer tracer, MotionScales motionScales)
        : tracer_(std::move(tracer)), motionScales_(std::move(motionScales)) {}
    Result<void> applySettings(const trace::Settings& settings);
    bool mayDenoise(const FrameInput& input) const;
    Result<void> doWithoutDenoising();

    trace::PathTracer tracer_;
    std::optional<trace::Settings> settings_;
    trace::View view_;
    int scale_ = 1;
    // A picture of so many pixels was too large to denoise in the device's memory.
    std::int64_t pixelsRefused_ = kNoneRefused;

    MotionScales motionScales_;
    trace::Look previewLook_{};
    std::uint64_t previewSamples_ = 0;
    double previewMs_ = 0.0;
    bool isFirstPreview_ = false;  // the small picture is the first of its view
    int warmWidth_ = 0;            // of the small picture before
    std::optional<trace::Look> warmLook_;
    std::uint32_t previewNumber_ = 0;

    std::optional<FrameInput> full_;  // what the full picture is of
    bool isDeveloping_ = false;       // its samples are to be shown; the filter is under way
    bool isLast_ = false;
    FilterCourse course_;
    double samples_ = 0.0;
    double developMs_ = 0.0;  // so far, of what is under way
};

// Whether both are the same view of the same thing, pixel for pixel.
bool isSamePicture(const FrameInput& a, const FrameInput& b);

}  // namespace macula::app
