// What time buys in hybrid frames: their error against pictures traced for as long as it takes, over all that
// can be traded for time, and which trades nothing else beats. docs/hybrid-frame.md says what a point is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/frame_recipes.h"
#include "evaluate/frame_scores.h"
#include "evaluate/pareto_front.h"

namespace macula::evaluate {

struct FrameTradeoffOptions {
    glm::ivec2 sizePx{240, 240};
    double verticalFovDeg = 40.0;
    // Of the truth, which is not denoised. Its bounces are many, so that what fewer leave out is an error.
    std::uint32_t truthSamples = 256;  // even
    int truthBounces = 64;
    double degreesPerFrame = 0.4;     // around what can be seen: 6 degrees a second at 15 frames a second
    hybrid::FirstModelOptions model;  // the usual one, under all frames; no finer than they are
    ModelLevels models;
    FrameLevels frames;
};

// Means over viewpoints, and over the ages of the fovea.
struct FrameErrors {
    double flip = 0.0;                   // of the whole frame
    double fovealFlip = 0.0;             // of trace::kFovealFieldDeg around the gaze
    std::optional<double> maskedPsnrDb;  // as RegionScores, of the whole frame; over those that have one
};
FrameErrors meanOf(std::span<const FrameErrors> errors);

struct ModelPoint {
    ModelRecipe recipe;
    std::size_t splats = 0;
    double preparationSeconds = 0.0;  // points, views, training
    double drawMs = 0.0;              // of a frame of splats alone
    FrameErrors errors;               // of such frames
    bool onFront = false;             // of FLIP against preparation
};

struct FramePoint {
    std::optional<FrameRecipe> recipe;  // nothing: splats alone
    double drawMs = 0.0;                // of a frame: splats, reprojection, composition
    double foveaMs = 0.0;               // of a picture for the fovea: tracing, guides, denoising
    FrameErrors errors;
    bool onFront = false;        // of FLIP against ms()
    bool onFovealFront = false;  // of foveal FLIP against ms()

    // Of a frame, with its share of the fovea that it shows.
    double ms() const { return recipe ? drawMs + foveaMs / recipe->framesPerFovea : drawMs; }
};

struct FrameTradeoff {
    std::vector<ModelPoint> models;  // the usual one first
    std::vector<FramePoint> frames;  // over the usual model; splats alone first
};

std::vector<CostAndError> costsOf(std::span<const ModelPoint> models);
std::vector<CostAndError> costsOf(std::span<const FramePoint> frames, double FrameErrors::*error);
// Says of each point whether it is on its fronts.
void markFronts(FrameTradeoff& tradeoff);

// Levels have at least one value each. `cancelled`; inputNotUsable when nothing can be seen; usage when the
// samples of the truth are not even, or lights hang on the camera.
Result<FrameTradeoff> measureFrameTradeoff(const BenchStudy& study, const FrameTradeoffOptions& options,
                                           Progress& progress);

}  // namespace macula::evaluate
