// The picture of one view of a scene, to which samples are added: decides for PathTracer what to trace, and
// when the picture starts over.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/trace/accumulation.h"
#include "pipeline/trace/guides.h"
#include "pipeline/trace/indirect_cache.h"
#include "pipeline/trace/sampling_plan.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/settings.h"
#include "pipeline/trace/surface_points.h"
#include "pipeline/trace/trace_kernels.h"
#include "pipeline/trace/traced_picture.h"
#include "pipeline/trace/variance_map.h"
#include "pipeline/trace/view_history.h"
#include "shared/primary_vertex.h"

namespace macula::trace {

// The error when a part of the scene was never set, or could not be: then its setter returned the reason.
Error nothingToTrace();

// Used by one thread at a time, the one that uses the device. Methods named like those of PathTracer do what
// is documented there.
class SampledPicture {
  public:
    explicit SampledPicture(SceneView scene)
        : scene_(std::move(scene)),
          device_(scene_.scene().device()),
          kernels_(device_),
          accumulation_(device_),
          history_(device_),
          variances_(device_) {}

    Result<void> setSettings(const Settings& settings);
    void setView(const View& view);
    void setDispatchMs(double ms);
    void setSideBySide(std::uint32_t samples);
    void forgetViews() { history_.forget(); }

    const std::shared_ptr<gpu::Device>& device() const { return device_; }
    SceneView& scene() { return scene_; }
    const SceneView& scene() const { return scene_; }
    TraceKernels& kernels() { return kernels_; }
    const Settings& settings() const { return settings_; }
    const View& view() const { return view_; }

    // Whether anything has changed since the samples were traced.
    bool isStale() const { return stale_ || !scene_.isCurrent(); }
    // Brings the device up to what was set, and starts a new accumulation when anything changed.
    Result<void> prepare();

    Result<bool> trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing);
    Result<bool> traceFor(double budgetMs, const std::function<bool()>& keepGoing);
    Result<void> addPrimaries(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing);
    Result<std::vector<shared::PrimaryVertex>> tracePrimaries(std::uint32_t samplesPerPixel,
                                                              const std::function<bool()>& keepGoing);
    // The samples of a pixel whose vertices addPrimaries left; 0 unless it began at a multiple of
    // kPrimarySamples.
    std::uint32_t primarySamples() const { return firstPrimary_ == 0 ? primarySamples_ : 0; }
    Result<ErrorEstimate> estimateError();
    bool converged() const;

    // When prepared: the samples, the guides, and, where the settings denoise, the filtered picture.
    const Accumulation& accumulation() const { return accumulation_; }
    Result<const Guides*> guides() { return history_.guides(scene_, kernels_); }
    Result<const gpu::Buffer*> denoised();
    Result<bool> develop(const std::function<bool()>& keepGoing);
    Result<TracedLight> light();
    Result<TracedLight> noisyLight();

    // The search for surface points under way; nothing once the scene, the view or the settings have changed.
    std::optional<SurfacePointSearch>& search() { return search_; }

  private:
    void looksOther();
    TraceVariant variant() const;
    bool usesIndirect() const;
    LightOfScene lightOfScene() const;
    std::uint32_t mostPerDispatch() const;  // samples of a pixel
    void beginEvenPass(double samples);
    void beginPass(double leftMs);
    Result<void> step(double ms);
    bool needsEstimate() const;
    Result<void> stepFor(double leftMs);

    SceneView scene_;
    std::shared_ptr<gpu::Device> device_;
    Settings settings_;
    View view_;
    TraceKernels kernels_;
    double dispatchMs_ = 40.0;          // a cancel is quick, and no watchdog fires
    bool stale_ = true;                 // view or settings have changed: accumulation starts again
    bool restarting_ = false;           // the picture starts over only because portions were too large
    bool tellsPrimaries_ = false;       // the samples under way also keep their primary vertices
    std::uint32_t firstPrimary_ = 0;    // index of the first sample of the last ones, modulo kPrimarySamples
    std::uint32_t primarySamples_ = 0;  // their number
    std::uint32_t mostSamples_ = UINT32_MAX;  // for one dispatch; lowered when paths turn out too long
    Accumulation accumulation_;
    ViewHistory history_;
    VarianceMap variances_;
    std::optional<SurfacePointSearch> search_;
};

}  // namespace macula::trace
