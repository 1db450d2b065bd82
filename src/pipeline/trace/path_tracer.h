// Pictures of a volume, made on the device in one of the looks of look.h. Most are volumetric path tracing:
// delta tracking through a bounded grid, lit by an environment.
//
// The estimator follows Woodcock tracking for free flights and ratio tracking for shadow rays (Novak et al.
// 2018, "Monte Carlo methods for volumetric light transport simulation"), with next-event estimation to the
// environment at every vertex. It is unbiased for paths of up to `bounces` vertices. The directions to the
// light and of scattering are points of scrambled Sobol nets, stratified over four samples of a pixel (from a
// multiple of four on) and over its neighbours (shaders/lib/net.glsl): together they are less noisy than by
// themselves. Estimates of error take them as independent, and are a little too large. The other looks march
// along each ray without chance (shaders/lib/cast.glsl); their samples differ in where in the pixel they lie.
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

// Used by one thread at a time, the one that uses the device. Setters upload; trace() accumulates. Whoever
// cancels waits for one dispatch, at most some 40 ms once it is known how fast the device is, and for the
// compiling of a kernel when it is the first of its kind: on lavapipe 0.1 s,
// and 0.3 s the first time on a machine, when Mesa has not kept it: longer than a cancel should take.
class PathTracer {
  public:
    static Result<PathTracer> create(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits = {});
    // Another tracer that looks at the same scene, which is on the device once: what one of them is told of
    // volume, function, environment and clip holds for all, whose pictures then begin anew. View, settings,
    // samples, history and filter are its own. Looks of different kinds (projections, and others) take turns
    // with one another badly: each begins the others' pictures anew.
    Result<PathTracer> ofSameScene() const;
    PathTracer(PathTracer&&) noexcept;
    PathTracer& operator=(PathTracer&&) noexcept;
    ~PathTracer();

    // What is traced: volume, transfer function, environment, clip, and what is beside the volume. Whoever
    // changes it, all pictures of it begin anew.
    DeviceScene& scene();
    const DeviceScene& scene() const;

    Result<void> setSettings(const Settings& settings);
    Result<void> setView(const View& view);
    // How long a dispatch of samples may take; 40 ms until it is set, at least 4. A graphics card gets no
    // less than keeps it busy, which takes no longer than less would.
    void setDispatchMs(double ms);
    // For tests and measurements: so many samples of each pixel are traced side by side; 0, as at first: as
    // many as the device likes (side_by_side.h). The picture begins anew.
    void setSideBySide(std::uint32_t samples);
    // The next view is denoised as if none had been traced before it.
    void forgetViews();

    // Adds `samplesPerPixel` samples to every pixel, in short dispatches; `keepGoing` (may be empty) is asked
    // between dispatches, and a picture that was interrupted is finished by the next call. Returns whether
    // all of these samples were added.
    Result<bool> trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing = {});

    // Where an eye sees anything, LPS mm; empty, low > high, when there is nothing. Whatever a clip removed
    // is not in it. usage for projections.
    Result<Box> seenMm();

    // Points around all of the matter that can be seen, LPS mm, for a view that fits (framePoints); none
    // where there is nothing. Projections show all of the volume instead. No view is needed.
    Result<std::vector<glm::dvec3>> outlineMm() const;

    // Adds samples like trace(), 1 to kPrimarySamples, and gives where each has met matter first, or a grey
    // face of a clip, and what light left there towards the eye: row by row for one sample of each pixel,
    // then for the next. `cancelled` when `keepGoing` says no; then, and after a pass that was interrupted
    // or adapted, the picture begins anew. usage for looks that trace no paths.
    Result<std::vector<shared::PrimaryVertex>> tracePrimaries(std::uint32_t samplesPerPixel,
                                                              const std::function<bool()>& keepGoing = {});
    // The same without giving them: beginReading does. What it has read by then, it may be tracing over.
    Result<void> addPrimaries(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing = {});

    // Begins to read what addPrimaries has told, which must have begun at a multiple of kPrimarySamples, and
    // what readColours gives, or one of them; the guides and the filter that this takes are submitted too.
    // Samples and views may follow at once. It waits only where device memory is host memory.
    using WantedReading = trace::WantedReading;
    Result<void> beginReading(ViewReading& reading, const WantedReading& wanted);

    // Adds samples for about `budgetMs` (may be infinite), at least one dispatch, and stops within 20 ms of
    // it on the slowest device once its kernels are compiled (the first dispatch of a kind compiles one);
    // earlier when the picture has converged, see Settings::errorThreshold, and does nothing then. After a
    // few even samples light paths go where the picture is noisiest (sampling_plan.h), so that pixels have
    // different numbers of samples; rays that are cast, which have no noise, stay even. A pass that is not
    // finished is gone on with by the next call. Returns whether none is left unfinished.
    Result<bool> traceFor(double budgetMs, const std::function<bool()>& keepGoing = {});

    // How noisy the picture is so far; what traceFor() decides by, for whoever adds samples by trace(). Of
    // rays that are cast it is an upper bound: their samples are spread more evenly than chance would.
    Result<ErrorEstimate> estimateError();  // waits

    // What display() and readback() of a denoised picture have to do first, guides and filter, in short
    // dispatches; `keepGoing` is asked after each, and the next call goes on where it said no, unless samples
    // came. Whether all is done; true at once where nothing is denoised. outOfMemory as display().
    Result<bool> develop(const std::function<bool()>& keepGoing);

    // The tone-mapped picture so far, display-encoded RGBA8, over `background`: linear light that is
    // displayed as it is, whatever exposure and tone map. Stays on the device, in layout GENERAL, size of the
    // view, valid until the next setView.
    Result<const gpu::Image*> display(const glm::vec3& background, Smoothing smoothing = Smoothing::none);

    // What display() shows, before background and tone map; valid until the next call.
    Result<TracedLight> light();
    // The same with how noisy it is. outOfMemory.
    Result<TracedLight> noisyLight();

    // The guides of the view that was set last, on the device: valid until the next call. Motion is towards
    // the last view before it that was traced. Normals need a few more voxels; where these make others
    // coarser, the picture begins anew.
    Result<const Guides*> guides();
    Result<std::vector<GuidePixel>> readGuides();  // row 0 on top; waits

    // The layers along the centre rays of the view that was set last, row 0 on top: a shared::PixelLayers for
    // each pixel, into a buffer that is there, of as many pixels; in any other case it becomes a new one.
    // What was submitted before still reads the last layers.
    Result<void> findLayersIn(std::optional<gpu::Buffer>& layers);
    Result<std::vector<shared::PixelLayers>> readLayers();  // waits

    const std::shared_ptr<gpu::Device>& device() const;

    // Surface points of all that can be seen from anywhere, lit as it is for this view; the samples traced so
    // far stay. Waits; `cancelled` when `keepGoing` (may be empty) says no between two dispatches.
    Result<SurfacePoints> surfacePoints(const SurfacePointOptions& options = {},
                                        const std::function<bool()>& keepGoing = {});
    // The same in slices: nothing when `keepGoing` says no, and then the next call goes on with the search,
    // whose options are those of the first. It begins anew when anything else was set meanwhile.
    Result<std::optional<SurfacePoints>> someSurfacePoints(const SurfacePointOptions& options,
                                                           const std::function<bool()>& keepGoing);

    Result<TracedImage> readback();                                              // waits
    Result<TracedColours> readColours();                                         // waits
    Result<std::vector<std::uint8_t>> readDisplay(const glm::vec3& background);  // RGBA8, opaque; waits
    Result<Statistics> statistics() const;                                       // waits
    // Of a pixel, traced so far; of a pass under way what of it is done. Waits for nothing.
    double meanSamples() const;
    // What a person has to know about what is shown; part of statistics().
    std::vector<Message> messages() const;

  private:
    struct Impl;
    explicit PathTracer(std::unique_ptr<Impl> impl);
    static Result<PathTracer> of(std::shared_ptr<DeviceScene> scene);
    std::unique_ptr<Impl> impl_;
};

}  // namespace macula::trace
