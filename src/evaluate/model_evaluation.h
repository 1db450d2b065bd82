// How good a peripheral model is: made of a scene, perhaps refined, drawn from where it was not looked at
// before, and compared with what the tracer sees there. docs/peripheral-model.md is the protocol.
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

// As the window's model learns by itself (live_model.h), but with all of the device for it.
struct LivePlan {
    double seconds = 60.0;        // at most, by the clock, once the points are found
    double snapshotEvery = 15.0;  // seconds
};

struct EvaluationOptions {
    hybrid::FirstModelOptions model{.views = 12, .samplesPerPixel = 8};  // the paper's
    std::optional<RefinementPlan> refinement;
    std::optional<LivePlan> live;  // trains like this instead of by `model`, of which only bounces count
    std::size_t truthViews = 32;
    hybrid::TruthOptions truth;   // of as many bounces as the model
    std::filesystem::path cache;  // empty: nothing is kept
    bool keepViews = false;  // also keeps views to learn from; times then say nothing of views that were kept
};

// A model on its way.
struct Snapshot {
    std::uint64_t steps = 0;
    std::size_t splats = 0;
    double trainSeconds = 0.0;       // since the first step of the first model, without what lies between
    std::vector<ViewScores> scores;  // by view of the truth
};

struct SceneEvaluation {
    Box seenMm;
    // For the model: of the wall, kernels compiled on the way included. The volume is on the device already.
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;      // choosing and tracing them
    double moreViewsSeconds = 0.0;  // the same, of those it was refined with
    double drawMs = 0.0;            // of a picture of the last model
    // For the truth.
    std::vector<Camera> truthCameras;
    double truthSeconds = 0.0;
    std::size_t truthFromCache = 0;  // views of which all was there
    std::size_t viewsFromCache = 0;  // to learn from, that took no time
    // Views of training, refinement and truth of which no draw showed enough matter: the last draw was taken.
    std::size_t viewsGivenUp = 0;
    std::vector<Snapshot> snapshots;                  // the first model; refined, each after it; never none
    std::vector<std::vector<std::uint8_t>> pictures;  // of the last model, see Comparison

    const Snapshot& last() const { return snapshots.back(); }
    double truthNoise() const;  // ViewScores::truthNoise, RMS over the views
};

// inputNotUsable when nothing of the scene can be seen.
Result<SceneEvaluation> evaluateModel(const std::shared_ptr<gpu::Device>& device,
                                      const live::StudyScene& scene, const EvaluationOptions& options,
                                      Progress& progress);

// The most that masked PSNR fell from one snapshot to the next: 0 when it never did. Of its mean over the
// views, and of its median.
struct GreatestFall {
    double meanDb = 0.0;
    double medianDb = 0.0;
};
GreatestFall greatestFall(const std::vector<Snapshot>& snapshots);

}  // namespace macula::evaluate
