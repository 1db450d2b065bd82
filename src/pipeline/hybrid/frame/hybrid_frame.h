// Draws the frames that a person sees in motion: traced where the eye looks, splats everywhere else. The
// picture for the fovea is traced in slices, from where the eye was at its begin; each frame reprojects it to
// the present eye (reprojection.h), over splats drawn for that eye.
//
//     frame.setScene(settings);     // whenever the tracer's scene or look was changed
//     if (!frame.isTracing()) frame.aim({.whole = view, .gaze = gaze, .sidePx = 300});
//     frame.traceFovea(keepGoing);  // a slice
//     frame.draw({.eyes = {left, right}, .sizePx = sizePx}, periphery);
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/compositor.h"
#include "pipeline/hybrid/frame/reprojection.h"
#include "pipeline/hybrid/frame/trust.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// Draws the splats of the traced scene.
struct Periphery {
    // Linear, premultiplied; valid until the next call.
    std::function<Result<DrawnSplats>(const Camera& eye, const glm::ivec2& sizePx)> draw;
    float gain = 1.0f;       // of their light: LiveModel::gain
    bool isLikeness = true;  // nearly like the scene: only then a noisy fovea is weighed against it
};

// The next picture for the fovea.
struct FoveaAim {
    trace::View whole;     // the whole view of the eye
    glm::dvec2 gaze{0.0};  // in that view, -1 to 1; right and up are positive
    double fieldDeg = trace::kFovealFieldDeg;
    int sidePx = 512;  // the picture is square
    std::uint32_t samplesPerPixel = 1;
    // Without denoising, guides are still traced for their depths, but all of them in the last slice.
    trace::Denoising denoising = trace::Denoising::on;
};

// The wall time that traceFovea() spent on one picture.
struct FoveaTimes {
    double traceMs = 0.0;
    double developMs = 0.0;  // guides and filter
    double captureMs = 0.0;  // of the host, which does not wait for the device here
};

// A traced picture of exactly what the eye sees, with all pixels, that gradually replaces the frame.
struct FadingIn {
    trace::TracedLight light;  // without variances it has full trust
    float share = 0.0f;        // of this picture, 0 to 1; the rest is splats and fovea
};

struct FrameRequest {
    std::vector<Camera> eyes;  // at least one
    glm::ivec2 sizePx{0};      // of the picture for each eye
    Display display;
    std::vector<glm::ivec2> sizesPx = {};   // by eye, if sizes differ; otherwise empty
    std::optional<FadingIn> fadingIn = {};  // only with a single eye
};

struct Frame {
    std::vector<const gpu::Image*> pictures;  // by eye, from Compositor::compose; until the next frame
    std::optional<double> foveaAgeMs;         // since its tracing began; nothing without a fovea
    std::uint32_t foveaSamples = 0;           // per pixel of the fovea
    double foveaShare = 0.0;                  // upper bound of its share of the first eye's pixels
    // The weight of the fovea in each pixel of the last eye: float32, row 0 on top; the buffer may be longer.
    // Valid until the next frame. Null without a fovea.
    const gpu::Buffer* foveaWeights = nullptr;
};

// Used by one thread at a time, the one that uses the device.
class HybridFrame {
  public:
    // The share of the fovea's sides over which it fades into the splats.
    static constexpr double kEdgeFade = 0.15;
    // Traces the scene of `beside`, with a view of its own.
    static Result<HybridFrame> create(const std::shared_ptr<gpu::Device>& device,
                                      const trace::PathTracer& beside);

    // Call when the scene or its look has changed: drops all traced pictures. `settings` say what is seen,
    // except denoising, which is that of an aim. The shown part of the scene must be on the device.
    Result<void> setScene(const trace::Settings& settings);

    // From the settings: the grey faces of a clip depend on both.
    double exposure() const { return settings_.exposure; }
    trace::ToneMap toneMap() const { return settings_.toneMap; }

    // Begins a picture, and drops the unfinished one. Call after setScene. Fails with usage as
    // trace::fovealWindow does.
    Result<void> aim(const FoveaAim& aim);
    bool isTracing() const { return aim_.has_value(); }
    // Makes a fovea of what `tracer` has traced for an eye at rest, with all pixels and many samples; it
    // reaches as far as the eye may look. `aim` says how many samples it has; its denoising is ignored. Fails
    // with outOfMemory, and there is no fovea then.
    Result<void> adopt(trace::PathTracer& tracer, const FoveaAim& aim);
    // Whether a picture traced for this eye would be better than the fovea that frames show. An adopted one
    // is good enough while the eye has turned by at most kGoodForDeg around the scene, sees it at most
    // kMostMagnified times as large, and looks within the fovea.
    static constexpr double kGoodForDeg = 8.0;
    static constexpr double kMostMagnified = 1.25;
    bool wantsFovea(const Camera& eye, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // Whether the eye has turned too far for the unfinished picture to be shown to it.
    bool hasLeftAim(const Camera& eye) const;
    // Whether the fovea that frames show was traced for exactly this eye, which looks well within it.
    bool isFoveaOf(const Camera& eye, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // Whether a fovea traced for this eye in `budgetMs` would show more than the present one. It would if
    // that was traced for another eye or gaze, or lacks part of its field and took less than half of that
    // time.
    bool wouldGrow(const Camera& eye, double budgetMs, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // Continues the picture, only while isTracing(). Asks `keepGoing` between dispatches of some 12 ms.
    // Returns whether the picture is finished: from then on frames show it.
    Result<bool> traceFovea(const std::function<bool()>& keepGoing);
    // The tracing time of the last finished picture, per pixel and sample; nothing before the first.
    std::optional<double> foveaMsPerSample() const { return msPerSample_; }
    // An eye that has turned farther around the scene is not shown the fovea: it would see too much that was
    // hidden where the fovea was traced.
    static constexpr double kMostTurnDeg = 20.0;
    // Whether frames for this eye show the present fovea; those of parallel cameras show only splats.
    bool showsFoveaTo(const Camera& eye) const;
    // Of the last picture that traceFovea finished.
    const FoveaTimes& foveaTimes() const { return times_; }
    // The tracing time for a fovea begun now, at most `mostMs`: short enough that an eye which turns as fast
    // as in the last frames can still be shown it.
    double foveaBudgetMs(double mostMs) const;
    bool hasFovea() const { return fovea_.has_value(); }
    // Frames show no traced picture until the next is there.
    void forgetFovea() { fovea_.reset(); }

    // Waits for nothing but what `periphery` waits for.
    Result<Frame> draw(const FrameRequest& request, const Periphery& periphery);

  private:
    using Clock = std::chrono::steady_clock;

    struct Fovea {
        CapturedPicture picture;
        FoveaAim aim;
        Clock::time_point begun{};
        bool isAdopted = false;
        double tracingMs = 0.0;
        bool isWeighed = false;  // against the splats
    };
    struct Extent {  // of a fovea within the whole view of its aim, -1 to 1
        glm::dvec2 middle{0.0};
        glm::dvec2 half{1.0};
    };
    static Extent extentOf(const FoveaAim& aim, bool isAdopted);

    Result<void> weighFovea(const Periphery& periphery);
    Result<void> trustFovea();
    Result<void> addFadingIn(Layers& layers, const FadingIn& fadingIn);
    double degreesAround(const glm::dvec3& aMm, const glm::dvec3& bMm) const;
    double magnificationFor(const Camera& eye) const;
    bool isWithinFovea(const glm::dvec2& gaze) const;
    void noteTurn(const glm::dvec3& eyeMm);

    HybridFrame(std::shared_ptr<gpu::Device> device, trace::PathTracer tracer, Reprojection reprojection,
                Trust trust)
        : device_(std::move(device)),
          tracer_(std::move(tracer)),
          reprojection_(std::move(reprojection)),
          trust_(std::move(trust)) {}

    std::shared_ptr<gpu::Device> device_;
    trace::PathTracer tracer_;
    Reprojection reprojection_;
    Trust trust_;
    std::optional<gpu::TexelBuffer> trusts_;  // in the picture that fades in; may have room for more
    std::vector<Compositor> compositors_;     // for each eye
    Box seenMm_;
    trace::Settings settings_;
    std::uint32_t count_ = 0;      // of pictures begun: each has its own seed
    std::optional<FoveaAim> aim_;  // of the unfinished picture
    trace::View view_;             // of the unfinished picture
    Clock::time_point begun_{};
    double spentMs_ = 0.0;
    FoveaTimes timesSoFar_;  // of the unfinished picture
    FoveaTimes times_;
    std::optional<Fovea> fovea_;
    std::optional<double> msPerSample_;
    double wallPerTracing_ = 4.0;  // time from aim to picture over tracing time; a guess at first
    struct Turn {
        Clock::time_point at;
        double degrees = 0.0;  // since the frame before
    };
    std::deque<Turn> turns_;  // of the frames of the last kTurnsKeptMs
    std::optional<glm::dvec3> lastEyeMm_;
};

}  // namespace macula::hybrid
