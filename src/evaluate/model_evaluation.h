// Measures the quality of a peripheral model: makes one of a scene, perhaps refines it, draws it from
// held-out poses, and compares that with the ground truth. docs/peripheral-model.md is the protocol.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "evaluate/view_scores.h"
#include "live/device/scene_on_device.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/refinement.h"
#include "pipeline/hybrid/views/truth_pictures.h"

namespace macula::evaluate {

struct RefinementPlan {
    std::size_t views = 64;
    std::uint32_t samplesPerPixel = 4;
    std::uint64_t iterations = 2000;
    std::uint64_t snapshotEvery = 250;  // steps
    std::uint32_t capacity = 50000;     // splats
};

// Learns as in the window (live_model.h), but with the whole device for itself.
struct LivePlan {
    double seconds = 60.0;        // most wall time, after the points are found
    double snapshotEvery = 15.0;  // seconds
};

struct EvaluationOptions {
    hybrid::FirstModelOptions model{.views = 12, .samplesPerPixel = 8};  // as in the paper
    std::optional<RefinementPlan> refinement;
    std::optional<LivePlan> live;  // replaces `model`, of which only `bounces` counts
    std::size_t truthViews = 32;
    hybrid::TruthOptions truth;   // with as many bounces as the model
    std::filesystem::path cache;  // empty: nothing is kept
    bool keepViews = false;       // also keeps training views; times then do not count kept ones
};

// A model during its training.
struct Snapshot {
    std::uint64_t steps = 0;
    std::size_t splats = 0;
    double trainSeconds = 0.0;       // since the first model's first step, only training
    std::vector<ViewScores> scores;  // by view of the truth
};

struct SceneEvaluation {
    Box seenMm;
    // Of the model: wall time, with the compiling of kernels. The volume is on the device already.
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;      // choosing and tracing them
    double moreViewsSeconds = 0.0;  // the same, for refinement
    double drawMs = 0.0;            // for a picture of the last model
    // Of the ground truth.
    std::vector<Camera> truthCameras;
    double truthSeconds = 0.0;
    std::size_t truthFromCache = 0;  // views found completely in the cache
    std::size_t viewsFromCache = 0;  // training views, which took no time
    // Views of training, refinement and truth for which no try showed enough: the last one was used.
    std::size_t viewsGivenUp = 0;
    std::vector<Snapshot> snapshots;                  // of the first model, then of refinement; never empty
    std::vector<std::vector<std::uint8_t>> pictures;  // of the last model (Comparison::pictures)

    const Snapshot& last() const { return snapshots.back(); }
    double truthNoise() const;  // RMS of ViewScores::truthNoise over the views
};

// Fails with inputNotUsable if nothing of the scene can be seen.
Result<SceneEvaluation> evaluateModel(const std::shared_ptr<gpu::Device>& device,
                                      const live::StudyScene& scene, const EvaluationOptions& options,
                                      Progress& progress);

// The largest fall of masked PSNR from one snapshot to the next, 0 if it never fell: of its mean and of its
// median over the views.
struct GreatestFall {
    double meanDb = 0.0;
    double medianDb = 0.0;
};
GreatestFall greatestFall(const std::vector<Snapshot>& snapshots);

}  // namespace macula::evaluate
