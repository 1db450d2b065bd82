// What a person sees: traced where the eye looks, splats everywhere else. The picture for the fovea is traced
// in slices from where the eye was; every frame shows it as the eye sees it now (reprojection.h), over splats
// that are drawn for that eye.
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

// Who draws the splats, of the scene that is traced.
struct Periphery {
    // Linear, premultiplied; valid until the next call.
    std::function<Result<DrawnSplats>(const Camera& eye, const glm::ivec2& sizePx)> draw;
    float gain = 1.0f;  // of their light: LiveModel::gain
    bool isLikeness =
        true;  // they show nearly what is there; a frame weighs a noisy fovea against these only
};

// The next picture for the fovea.
struct FoveaAim {
    trace::View whole;     // what the eye sees
    glm::dvec2 gaze{0.0};  // in it, -1 to 1, right and up are positive
    double fieldDeg = trace::kFovealFieldDeg;
    int sidePx = 512;  // of a square
    std::uint32_t samplesPerPixel = 1;
    // Without it guides are found nevertheless, for their depths, but all of them in the last slice.
    trace::Denoising denoising = trace::Denoising::on;
};

// What a picture for the fovea took, by the clock, from its aim until it is there.
struct FoveaTimes {
    double traceMs = 0.0;
    double developMs = 0.0;  // guides and filter
    double captureMs = 0.0;  // of the host, which does not wait for the device there
};

// A traced picture of all pixels, of exactly what the eye sees, that takes the frame's place by and by.
struct FadingIn {
    trace::TracedLight light;  // without variances it is trusted wholly
    float share = 0.0f;        // of it, 0 to 1; the rest is of splats and fovea
};

struct FrameRequest {
    std::vector<Camera> eyes;  // at least one
    glm::ivec2 sizePx{0};      // of the picture for each
    Display display;
    std::vector<glm::ivec2> sizesPx = {};   // of each, where they differ; as many as there are eyes, or none
    std::optional<FadingIn> fadingIn = {};  // of the one eye that there is
};

struct Frame {
    std::vector<const gpu::Image*> pictures;  // for each eye, as Compositor::compose; until the next frame
    std::optional<double> foveaAgeMs;         // since its tracing began; nothing while there is none
    std::uint32_t foveaSamples = 0;           // of each of its pixels
    double foveaShare = 0.0;                  // of the first eye's pixels, at most: where it can lie
    // What the fovea weighs in each pixel, as float32, row 0 on top, and perhaps more behind that; of the
    // last eye, until the next frame. Null without a fovea.
    const gpu::Buffer* foveaWeights = nullptr;
};

// Used by one thread at a time, the one that uses the device.
class HybridFrame {
  public:
    // With a view of its own of the scene that `beside` shows. Share of the fovea's sides over which it
    // fades.
    static constexpr double kEdgeFade = 0.15;
    static Result<HybridFrame> create(const std::shared_ptr<gpu::Device>& device,
                                      const trace::PathTracer& beside);

    // The scene or its look is another one: what was traced is dropped. Of `settings`, what is seen; how
    // far a fovea is denoised, its aim says. What is shown of the scene must be on the device.
    Result<void> setScene(const trace::Settings& settings);

    // Of the settings: grey faces of a clip depend on both.
    double exposure() const { return settings_.exposure; }
    trace::ToneMap toneMap() const { return settings_.toneMap; }

    // Begins a picture, and drops the one that is under way. After setScene. usage as trace::fovealWindow.
    Result<void> aim(const FoveaAim& aim);
    bool isTracing() const { return aim_.has_value(); }
    // What `tracer` has traced of all that an eye saw at rest becomes the fovea, as far as the eye may look
    // at: many samples, with all pixels. The samples of `aim` say how many the picture has; its denoising
    // is ignored. Fails with outOfMemory, and there is no fovea then.
    Result<void> adopt(trace::PathTracer& tracer, const FoveaAim& aim);
    // Whether a picture traced from there would be better than the one that frames show: one that was adopted
    // is good for kGoodForDeg around what can be seen, where it is seen at most kMostMagnified times as large
    // and the eye looks at what it shows.
    static constexpr double kGoodForDeg = 8.0;
    static constexpr double kMostMagnified = 1.25;
    bool wantsFovea(const Camera& eye, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // Whether the picture that is under way could not be shown to that eye any more.
    bool hasLeftAim(const Camera& eye) const;
    // Whether the fovea that frames show was traced from just there, and the eye looks well within it.
    bool isFoveaOf(const Camera& eye, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // Whether a fovea that is traced from just there in `budgetMs` would show more than the one there is:
    // that is of something else, or has not its whole field and took less than half of that.
    bool wouldGrow(const Camera& eye, double budgetMs, const glm::dvec2& gaze = glm::dvec2(0.0)) const;
    // While it is tracing: goes on; `keepGoing` is asked between dispatches of some 40 ms. Whether the
    // picture is there: from then on frames show it.
    Result<bool> traceFovea(const std::function<bool()>& keepGoing);
    // The time that pictures took lately, per pixel and sample; nothing before the first.
    std::optional<double> foveaMsPerSample() const { return msPerSample_; }
    // An eye that has gone farther around what can be seen is not shown the fovea: most of what it sees was
    // hidden from where that was traced.
    static constexpr double kMostTurnDeg = 20.0;
    // Whether frames for that eye show the fovea that there is; with parallel rays they show splats alone.
    bool showsFoveaTo(const Camera& eye) const;
    // Of the last picture that traceFovea finished.
    const FoveaTimes& foveaTimes() const { return times_; }
    // Tracing time of a fovea that is begun now, at most `mostMs`, so that it is there while it can still be
    // shown, by how fast the eyes of the last frames go around.
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
    struct Extent {  // in the whole of an aim, -1 to 1: the middle, and from there to where the fovea ends
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
    std::optional<gpu::TexelBuffer> trusts_;  // in what fades in; there may be room for more
    std::vector<Compositor> compositors_;     // for each eye
    Box seenMm_;
    trace::Settings settings_;
    std::uint32_t count_ = 0;      // of pictures: each has other noise
    std::optional<FoveaAim> aim_;  // what is under way
    trace::View view_;             // of that
    Clock::time_point begun_{};
    double spentMs_ = 0.0;
    FoveaTimes timesSoFar_;  // of what is under way
    FoveaTimes times_;
    std::optional<Fovea> fovea_;
    std::optional<double> msPerSample_;
    double wallPerTracing_ = 4.0;  // time from aim to picture over that of tracing; a guess at first
    struct Turn {
        Clock::time_point at;
        double degrees = 0.0;  // since the frame before
    };
    std::deque<Turn> turns_;  // of the frames of the last kTurnsKeptMs
    std::optional<glm::dvec3> lastEyeMm_;
};

}  // namespace macula::hybrid
