// The guides of a view and of the view before it, and the picture that is denoised with both.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/denoiser.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/guides.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/settings.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device.
class ViewHistory {
  public:
    explicit ViewHistory(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // Matter or light have changed: no earlier view shows the same.
    void forget() { forgets_ = true; }
    // Begins the picture of `view`. What the picture before it showed is kept if it was traced at all.
    void turnPage(const View& view, std::uint32_t seed, bool wasTraced, LightFrame lights);
    // Starts the picture of the last view over.
    void restart();

    // The guides of that view; their normals are right only if the scene keeps voxels for gradients. Motion
    // is towards the last view before it that was traced. `scene` must look at that view. Valid until the
    // next call.
    Result<const Guides*> guides(const SceneView& scene, TraceKernels& kernels);
    // vec4 for each pixel, see Denoiser::result(), of a film of that view; `how` is not off. Filters again
    // when the film's `edition` or `how` has changed. Valid until the next call.
    Result<const gpu::Buffer*> denoised(const Film& film, std::uint64_t edition, Denoising how,
                                        const SceneView& scene, TraceKernels& kernels);
    // How noisy the denoised picture is (Denoiser::variances); only right after denoised().
    Result<const gpu::Buffer*> variances() { return denoiser_->variances(*guides_); }
    // Does the work of denoised() in short dispatches, and waits for each. Calls `keepGoing` after each; when
    // it returns false, the next call continues there. Returns whether all is done.
    Result<bool> denoiseSome(const Film& film, std::uint64_t edition, Denoising how, const SceneView& scene,
                             TraceKernels& kernels, const std::function<bool()>& keepGoing);

  private:
    void limitLag(const View& view, LightFrame lights);
    Result<void> makeGuides(const SceneView& scene, TraceKernels& kernels,
                            const std::function<bool()>& keepGoing);

    std::shared_ptr<gpu::Device> device_;
    std::optional<Guides> guides_, guidesBefore_;
    bool haveNormals_ = false;  // of guides_: all voxels that gradients reach were there
    std::optional<Denoiser> denoiser_;
    std::optional<View> view_;  // nothing before the first page
    std::uint32_t seed_ = 0;
    // The mean angle between this view and those in the history; only used for lights fixed to the camera.
    double lagDeg_ = 0.0;
    float historySamples_ = Denoiser::kHistorySamples;  // samples that the history may count for, at most
    View viewBefore_;
    bool forgets_ = true;
    std::optional<std::uint64_t> denoisedEdition_;  // of the film, when the denoiser ran
    Denoising denoisedAs_ = Denoising::off;         // the `how` of that run
    std::uint64_t begunEdition_ = 0;                // edition of the last run, which may be unfinished
    Denoising begunAs_ = Denoising::off;
};

}  // namespace macula::trace
