// How good a first peripheral model is: made of a scene, drawn from where it was not looked at before, and
// compared with what the tracer sees there. docs/peripheral-model.md is the protocol.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "cli/view_scores.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/truth_pictures.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/surface_points.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::cli {

struct InitialEvaluationOptions {
    trace::SurfacePointOptions points;
    std::size_t views = 12;  // 0: none are traced
    std::uint32_t samplesPerPixel = 8;
    int sizePx = 512;                // of a side of a view
    std::uint64_t iterations = 700;  // 0: the model of points is judged
    std::uint64_t trial = 0;         // another draw of views
    std::size_t truthViews = 32;
    hybrid::TruthOptions truth;
    std::filesystem::path cache;  // empty: nothing is kept
};

struct EvaluatedScene {
    std::shared_ptr<const Volume> volume;  // stored16
    TransferFunction function;
    Clip clip;
    trace::Environment environment;
};

struct SceneEvaluation {
    Box seenMm;
    std::size_t splats = 0;
    // For the model: of the wall, kernels compiled on the way included. The volume is on the device already.
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;  // choosing and tracing them
    double trainSeconds = 0.0;
    double drawMs = 0.0;  // of a picture of the model, median; waited for and read
    // For the truth.
    double truthSeconds = 0.0;
    double truthNoise = 0.0;         // see TruthPicture; RMS over the views
    std::size_t truthFromCache = 0;  // views
    std::size_t viewsGivenUp = 0;    // of both sets: none of the tries showed enough
    std::vector<ViewScores> scores;  // by view of the truth
    // As displayed, by view, truth on the left and model on the right; RGBA, opaque.
    std::vector<std::vector<std::uint8_t>> pictures;
};

// inputNotUsable when nothing of the scene can be seen.
Result<SceneEvaluation> evaluateInitial(const std::shared_ptr<gpu::Device>& device,
                                        const EvaluatedScene& scene, const InitialEvaluationOptions& options,
                                        Progress& progress);

}  // namespace macula::cli
