// The samples of one picture: added in short dispatches, and looked at for how noisy they are.
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

// Used by one thread at a time, the one that uses the device. After begin or step has failed, begin is next.
class Accumulation {
  public:
    explicit Accumulation(std::shared_ptr<gpu::Device> device)
        : device_(std::move(device)),
          pace_(device_->isCpu() ? Pace::Guess{} : Pace::graphicsCard()),
          sideBySide_(device_->info().threadsAtOnce) {}

    // A picture without samples. What is known of the device's pace stays. outOfMemory.
    Result<void> begin(int width, int height);

    // Whoever begins passes decides how many samples they have; step() does them.
    SamplingPlan& plan() { return plan_; }
    const SamplingPlan& plan() const { return plan_; }
    SideBySide& sideBySide() { return sideBySide_; }
    // Whether the samples of a pixel of this picture are traced side by side, in a variant that says so.
    bool isSideBySide() const { return sideBySide_.isFor(plan_.blockCount()); }
    // The most samples of a pixel in one pass, of which a thread takes at most `perThread`.
    std::uint32_t mostSamples(const TraceVariant& variant, std::uint32_t perThread) const;
    // How long a pass of one sample for each pixel takes, as far as is known.
    double passMs(const TraceVariant& variant, int bounces) const;

    // One dispatch of the pass under way, which takes about `ms`; waits. `scene`
    // looks at the picture's view. Where it fails, nobody knows what the film holds.
    Result<void> step(const SceneView& scene, TraceKernels& kernels, const TraceVariant& variant, int bounces,
                      double ms);
    // Begins to keep the primary vertex of samples too: where each first meets matter, for kPrimarySamples
    // samples of each pixel in a row, in steps whose variant tells it. Clears what was kept before.
    // outOfMemory.
    Result<void> clearPrimaries();
    Result<std::vector<shared::PrimaryVertex>> readPrimaries() const;  // waits; after clearPrimaries
    const gpu::Buffer& primaries() const { return *primaries_; }       // likewise

    // Whether paths were lost to the device's limit that smaller portions than those of the last pass would
    // keep. To leave out long paths only, which are those through dense matter, would darken the picture.
    Result<bool> hasLostPaths() const;

    const Film& film() const { return *film_; }
    // The edition of the film grows whenever something is added to it, or it is cleared.
    std::uint64_t edition() const { return edition_; }
    double deviceMs() const { return deviceMs_; }  // spent since it began
    std::uint32_t dispatches() const { return dispatches_; }

    // One dispatch towards an error estimate of the samples traced so far; waits.
    Result<void> measureSome(const Settings& settings);
    bool isMeasured() const { return estimate_ && measuredEdition_ == edition_; }
    // The last estimate since begin(), which may be of fewer samples than there are.
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
    std::optional<gpu::Buffer> traced_;     // vec4: what samples that go side by side bring
    std::optional<gpu::Buffer> taken_;      // uint: how many of these threads have taken
    std::optional<gpu::Buffer> primaries_;  // PrimaryVertex: kPrimarySamples for each pixel
    SamplingPlan plan_;
    std::uint64_t edition_ = 0;
    double deviceMs_ = 0.0;
    std::uint32_t dispatches_ = 0;

    std::optional<NoiseMap> noiseMap_;
    std::uint64_t measuredEdition_ = 0;  // edition of the film that the noise map measures, or has measured
    std::vector<shared::BlockNoise> noises_;
    std::optional<ErrorEstimate> estimate_;
};

}  // namespace macula::trace
