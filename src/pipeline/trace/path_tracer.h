// Pictures of a volume, made on the device in one of the looks of look.h. Most are volumetric path tracing:
// delta tracking through a bounded grid, lit by an environment.
//
// The estimator follows Woodcock tracking for free flights and ratio tracking for shadow rays (Novak et al.
// 2018, "Monte Carlo methods for volumetric light transport simulation"), with next-event estimation to the
// environment at every vertex. It is unbiased for paths of up to `bounces` vertices. The directions to the
// light and of scattering are points of scrambled Sobol nets, stratified over four successive samples of a
// pixel (the first has a multiple of four as its index) and over its neighbours (shaders/lib/net.glsl): their
// mean is less noisy than that of independent samples. Estimates of error assume independent samples, and are
// a little too large. The other looks march along each ray deterministically (shaders/lib/cast.glsl); their
// samples differ only in their position within the pixel.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/guides.h"
#include "pipeline/trace/sampling_plan.h"
#include "pipeline/trace/settings.h"
#include "pipeline/trace/surface_points.h"
#include "pipeline/trace/traced_picture.h"
#include "pipeline/trace/view_reading.h"
#include "pipeline/trace/voxel_memory.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"
#include "shared/pixel_layers.h"
#include "shared/primary_vertex.h"

namespace macula::trace {

class DeviceScene;

// Used by one thread at a time, the one that uses the device. Setters upload; trace() accumulates. A cancel
// waits for the dispatch under way: at most some 40 ms once the device's pace is known. The first dispatch of
// a kernel also compiles it, which is too long for a cancel: on lavapipe 0.1 s, and 0.3 s the first time on a
// machine, until Mesa's cache has it.
class PathTracer {
  public:
    static Result<PathTracer> create(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits = {});
    // Another tracer of the same scene, which is on the device only once: a volume, function, environment or
    // clip set through one of them holds for all, and all their pictures start over. View, settings, samples,
    // history and filter are its own. Do not alternate between projections and other looks: each switch makes
    // the pictures of the other kind start over.
    Result<PathTracer> ofSameScene() const;
    PathTracer(PathTracer&&) noexcept;
    PathTracer& operator=(PathTracer&&) noexcept;
    ~PathTracer();

    // The traced scene: volume, transfer function, environment, clip, and additions. After any change all
    // pictures of it start over.
    DeviceScene& scene();
    const DeviceScene& scene() const;

    Result<void> setSettings(const Settings& settings);
    Result<void> setView(const View& view);
    // How long a dispatch of samples may take; 40 ms until it is set, at least 4. A graphics card always gets
    // enough work to keep it busy: a smaller dispatch would take it as long.
    void setDispatchMs(double ms);
    // For tests and measurements: how many samples of each pixel are traced side by side; 0, the default: as
    // many as suit the device (side_by_side.h). The picture starts over.
    void setSideBySide(std::uint32_t samples);
    // The next view is denoised as if none had been traced before it.
    void forgetViews();

    // Adds `samplesPerPixel` samples to every pixel, in short dispatches. Calls `keepGoing` (may be empty)
    // between dispatches, and stops when it returns false: the next call then finishes these samples first.
    // Returns whether all of these samples were added.
    Result<bool> trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing = {});

    // The box of all that an eye can see, LPS mm, without what a clip removed; empty, low > high, when there
    // is nothing. usage for projections.
    Result<Box> seenMm();

    // Points around all visible matter, LPS mm, for a view that fits it (framePoints); none if nothing is
    // visible. The same for projections, which show all of the volume. No view is needed.
    Result<std::vector<glm::dvec3>> outlineMm() const;

    // Adds samples like trace(), 1 to kPrimarySamples, and returns for each where it first met matter or a
    // grey clip face, and the light that left there towards the eye: row by row for the first sample of each
    // pixel, then for the second. `cancelled` when `keepGoing` returns false; the picture then starts over,
    // as it does on a call after an interrupted or an adaptive pass. usage for looks that trace no paths.
    Result<std::vector<shared::PrimaryVertex>> tracePrimaries(std::uint32_t samplesPerPixel,
                                                              const std::function<bool()>& keepGoing = {});
    // The same, but leaves the vertices on the device for beginReading, which must be called before the next
    // addPrimaries overwrites them.
    Result<void> addPrimaries(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing = {});

    // Begins to read the vertices of addPrimaries, which must have begun at a multiple of kPrimarySamples, or
    // the picture as readColours gives it, or both; it also submits the guides and the filter that this
    // needs. More samples and another view may follow at once. It waits only where device memory is host
    // memory.
    using WantedReading = trace::WantedReading;
    Result<void> beginReading(ViewReading& reading, const WantedReading& wanted);

    // Adds samples for about `budgetMs` (may be infinite), at least one dispatch, and stops within 20 ms of
    // it on the slowest device once its kernels are compiled (the first dispatch of a kind compiles one);
    // earlier when the picture has converged (Settings::errorThreshold), and then adds nothing. After a few
    // even samples light paths go where the picture is noisiest (sampling_plan.h), so that pixels have
    // different numbers of samples; cast rays, which have no noise, stay even. The next call continues an
    // unfinished pass. Returns whether no pass is unfinished.
    Result<bool> traceFor(double budgetMs, const std::function<bool()>& keepGoing = {});

    // How noisy the picture is so far: the criterion of traceFor(), for callers that add samples by trace().
    // For cast rays it is an upper bound: their samples are more evenly spread than random ones.
    Result<ErrorEstimate> estimateError();  // waits

    // Does the work that display() and readback() of a denoised picture need first, guides and filter, in
    // short dispatches. Calls `keepGoing` after each; when it returns false, the next call continues there,
    // unless samples were added. Returns whether all is done; true at once where nothing is denoised.
    // outOfMemory as display().
    Result<bool> develop(const std::function<bool()>& keepGoing);

    // The tone-mapped picture so far, display-encoded RGBA8, over `background`: linear light, neither exposed
    // nor tone-mapped. Stays on the device, in layout GENERAL and the size of the view, valid until the next
    // setView.
    Result<const gpu::Image*> display(const glm::vec3& background, Smoothing smoothing = Smoothing::none);

    // The light that display() shows, before background and tone map; valid until the next call.
    Result<TracedLight> light();
    // The same with its variances. outOfMemory.
    Result<TracedLight> noisyLight();

    // The guides of the view that was set last, on the device: valid until the next call. Motion is towards
    // the last view before it that was traced. Normals need a few more voxels on the device; if these make
    // others coarser, the picture starts over.
    Result<const Guides*> guides();
    Result<std::vector<GuidePixel>> readGuides();  // row 0 on top; waits

    // The layers along the centre rays of the view that was set last, row 0 on top: a shared::PixelLayers for
    // each pixel. Reuses a buffer for as many pixels, and replaces any other by a new one. Work submitted
    // before still reads the earlier layers.
    Result<void> findLayersIn(std::optional<gpu::Buffer>& layers);
    Result<std::vector<shared::PixelLayers>> readLayers();  // waits

    const std::shared_ptr<gpu::Device>& device() const;

    // Surface points of all matter that can be seen from anywhere, lit as in this view; the samples traced so
    // far stay. Waits; `cancelled` when `keepGoing` (may be empty) returns false between two dispatches.
    Result<SurfacePoints> surfacePoints(const SurfacePointOptions& options = {},
                                        const std::function<bool()>& keepGoing = {});
    // The same in time slices: returns nothing when `keepGoing` returns false, and the next call continues
    // the search, with the options of the first call. If anything was set in between, the search starts over.
    Result<std::optional<SurfacePoints>> someSurfacePoints(const SurfacePointOptions& options,
                                                           const std::function<bool()>& keepGoing);

    Result<TracedImage> readback();                                              // waits
    Result<TracedColours> readColours();                                         // waits
    Result<std::vector<std::uint8_t>> readDisplay(const glm::vec3& background);  // RGBA8, opaque; waits
    Result<Statistics> statistics() const;                                       // waits
    // The mean number of samples of a pixel so far, with the finished part of a pass under way. Waits for
    // nothing.
    double meanSamples() const;
    // What a person has to know about the picture, such as that voxels are coarse; part of statistics().
    std::vector<Message> messages() const;

  private:
    struct Impl;
    explicit PathTracer(std::unique_ptr<Impl> impl);
    static Result<PathTracer> of(std::shared_ptr<DeviceScene> scene);
    std::unique_ptr<Impl> impl_;
};

}  // namespace macula::trace
