// The samples of one picture: adds them in short dispatches, and measures how noisy they are.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/noise_map.h"
#include "pipeline/trace/pace.h"
#include "pipeline/trace/sampling_plan.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/side_by_side.h"
#include "pipeline/trace/trace_kernels.h"
#include "shared/primary_vertex.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device. After begin or step has failed, call begin
// next.
class Accumulation {
  public:
    explicit Accumulation(std::shared_ptr<gpu::Device> device)
        : device_(std::move(device)),
          pace_(device_->isCpu() ? Pace::Guess{} : Pace::graphicsCard()),
          sideBySide_(device_->info().threadsAtOnce) {}

    // Begins a picture, without samples yet; keeps what it has learnt about the device's pace. outOfMemory.
    Result<void> begin(int width, int height);

    // The caller begins passes here, and so decides how many samples they have; step() traces them.
    SamplingPlan& plan() { return plan_; }
    const SamplingPlan& plan() const { return plan_; }
    SideBySide& sideBySide() { return sideBySide_; }
    // Whether this picture's samples of a pixel are traced side by side; a path tracing variant must then say
    // so.
    bool isSideBySide() const { return sideBySide_.isFor(plan_.blockCount()); }
    // The most samples of a pixel in one pass, of which a thread takes at most `perThread`.
    std::uint32_t mostSamples(const TraceVariant& variant, std::uint32_t perThread) const;
    // How long a pass of one sample for each pixel will take, by the pace measured so far.
    double passMs(const TraceVariant& variant, int bounces) const;

    // Runs one dispatch of the pass under way, sized to take about `ms`; waits. `scene` must look at the
    // picture's view. After a failure the content of the film is undefined.
    Result<void> step(const SceneView& scene, TraceKernels& kernels, const TraceVariant& variant, int bounces,
                      double ms);
    // From now on steps whose variant has tellsPrimaries also keep the primary vertex of each sample, where
    // its path first meets matter: for up to kPrimarySamples successive samples of a pixel. Clears earlier
    // ones. outOfMemory.
    Result<void> clearPrimaries();
    Result<std::vector<shared::PrimaryVertex>> readPrimaries() const;  // waits; after clearPrimaries
    const gpu::Buffer& primaries() const { return *primaries_; }       // likewise

    // Whether the device's limit on rounds cut off paths that smaller portions than those of the last pass
    // would keep. The longest paths lead through dense matter: a picture without them would be too dark.
    Result<bool> hasLostPaths() const;

    const Film& film() const { return *film_; }
    // The edition of the film grows whenever something is added to it, or it is cleared.
    std::uint64_t edition() const { return edition_; }
    double deviceMs() const { return deviceMs_; }  // spent since it began
    std::uint32_t dispatches() const { return dispatches_; }

    // One dispatch towards an error estimate of the samples traced so far; waits.
    Result<void> measureSome(const Settings& settings);
    bool isMeasured() const { return estimate_ && measuredEdition_ == edition_; }
    // The last estimate since begin(), made perhaps when there were fewer samples.
    const std::optional<ErrorEstimate>& estimate() const { return estimate_; }
    // The noise of each block behind that estimate.
    const std::vector<shared::BlockNoise>& noises() const { return noises_; }

  private:
    Result<void> makeRoomForTraced(std::uint64_t blockSamples);
    Result<void> record(gpu::Recorder& recorder, const SceneView& scene, TraceKernels& kernels,
                        const gpu::Kernel& samples, const TraceVariant& variant, std::uint32_t blocks,
                        std::uint32_t mostSamples);

    std::shared_ptr<gpu::Device> device_;
    Pace pace_;
    SideBySide sideBySide_;
    std::optional<Film> film_;
    std::optional<gpu::Buffer> planned_;    // PlannedBlock: what the dispatch under way does
    std::optional<gpu::Buffer> traced_;     // vec4: the light of samples that are traced side by side
    std::optional<gpu::Buffer> taken_;      // uint: how many of those samples threads have taken
    std::optional<gpu::Buffer> primaries_;  // PrimaryVertex: kPrimarySamples for each pixel
    SamplingPlan plan_;
    std::uint64_t edition_ = 0;
    double deviceMs_ = 0.0;
    std::uint32_t dispatches_ = 0;

    std::optional<NoiseMap> noiseMap_;
    std::uint64_t measuredEdition_ = 0;  // the film's edition that the noise map measures or has measured
    std::vector<shared::BlockNoise> noises_;
    std::optional<ErrorEstimate> estimate_;
};

}  // namespace macula::trace
