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

namespace macula::live {

// Used by one thread at a time: the one that uses the device. Only one picture exists at a time: beginning a
// small one loses the full one, and vice versa.
class TracedPictures {
  public:
    static Result<TracedPictures> create(const std::shared_ptr<gpu::Device>& device);

    // The tracer. After changing its scene, call sceneChanged(), which drops the full picture.
    trace::PathTracer& tracer() { return tracer_; }
    void sceneChanged();
    // The memory in use on the device has changed, so denoising may fit again.
    void roomChanged() { pixelsRefused_ = kNoneRefused; }

    // Begins a small picture, denoised if the device has the memory.
    Result<void> beginPreview(const FrameInput& input);
    // Adds samples to the small picture. Returns false if `keepGoing` stopped it; the next call continues.
    Result<bool> tracePreview(const FrameInput& input, const std::function<bool()>& keepGoing);
    std::uint64_t previewSamples() const { return previewSamples_; }
    // Reports the times of the small picture, which set the size of the next one: developing (denoiser and
    // tone map), which grows with its pixels, and the rest.
    void previewWasShown(double developMs, double otherMs);

    // Expected time until a full-size picture is worth showing, from the times of small ones.
    double expectedFullMs(const FrameInput& input);
    // Whether the full picture shows exactly `input`, and has become worth showing.
    bool hasFull(const FrameInput& input) const;
    // Begins the full picture; does nothing if it already shows `input`, worth showing or not.
    Result<void> beginFull(const FrameInput& input);
    struct Progress {
        bool isNews = false;  // the full picture is worth showing, or showing again
        bool isLast = false;  // and it is final
    };
    // Traces the full picture for a time slice. `keepGoing` is called between dispatches of about 40 ms.
    Result<Progress> traceFull(const FrameInput& input, const std::function<bool()>& keepGoing);

    // The current picture, small or full, ready for display. It is on the device, see PathTracer::display.
    Result<const gpu::Image*> display(const glm::vec3& background);
    // Whether the picture may still be noisier than splats, and so should be mixed with them; light() is the
    // light to mix. It is on the device, see PathTracer::noisyLight.
    bool isNoisy() const { return !isLast_ && course_.isNoisy(); }
    Result<trace::TracedLight> light() { return isNoisy() ? tracer_.noisyLight() : tracer_.light(); }

    int width() const { return view_.width; }
    int height() const { return view_.height; }
    int scale() const { return scale_; }  // window pixels along each side of a picture pixel
    // Statistics of the current picture.
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
    // Pictures of this many pixels or more do not fit the device's memory when denoised.
    std::int64_t pixelsRefused_ = kNoneRefused;

    MotionScales motionScales_;
    trace::Look previewLook_{};
    std::uint64_t previewSamples_ = 0;
    double previewMs_ = 0.0;
    bool isFirstPreview_ = false;  // the small picture is the first of its view
    int warmWidth_ = 0;            // width of the previous small picture
    std::optional<trace::Look> warmLook_;
    std::uint32_t previewNumber_ = 0;

    std::optional<FrameInput> full_;  // the input of the full picture
    bool isDeveloping_ = false;       // the full picture is being developed for display
    bool isLast_ = false;
    FilterCourse course_;
    double samples_ = 0.0;
    double developMs_ = 0.0;  // time that the development under way has taken so far
};

// Whether both inputs give the same picture, pixel for pixel; the noise target does not count.
bool isSamePicture(const FrameInput& a, const FrameInput& b);

}  // namespace macula::live
