// What time buys in hybrid frames: their error against a ground truth, for all recipes that trade quality for
// time, and the Pareto fronts of these. docs/hybrid-frame.md says what a point is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/frame_recipes.h"
#include "evaluate/frame_scores.h"
#include "evaluate/svg_plot.h"

namespace macula::evaluate {

struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

// The indices of the Pareto front, the points that are worth their cost: no other has at most their cost and
// at most their error, and less of one. Cost ascends along the front, and error falls. Only the first of
// equal points is on it. A point whose cost or error is not finite is never on the front.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

struct FrameTradeoffOptions {
    glm::ivec2 sizePx{240, 240};
    double verticalFovDeg = 40.0;
    // Of the ground truth, which is not denoised. It has many bounces, so that light missing with fewer
    // counts as an error.
    std::uint32_t truthSamples = 256;  // even
    int truthBounces = 64;
    double degreesPerFrame = 0.4;     // around the scene: 6 degrees per second at 15 frames per second
    hybrid::FirstModelOptions model;  // the usual one, under all frames; no finer than frames
    ModelLevels models;
    FrameLevels frames;
};

// Means over viewpoints, and over the ages of the fovea.
struct FrameErrors {
    double flip = 0.0;                   // of the whole frame
    double fovealFlip = 0.0;             // of trace::kFovealFieldDeg around the gaze
    std::optional<double> maskedPsnrDb;  // as RegionScores, of the whole frame; over frames with one
};
FrameErrors meanOf(std::span<const FrameErrors> errors);

struct ModelPoint {
    ModelRecipe recipe;
    std::size_t splats = 0;
    double preparationSeconds = 0.0;  // points, views, training
    double drawMs = 0.0;              // of a frame of splats alone
    FrameErrors errors;               // of frames of splats alone
    bool onFront = false;             // front of FLIP over preparation time
};

struct FramePoint {
    std::optional<FrameRecipe> recipe;  // nothing for splats alone
    double drawMs = 0.0;                // of a frame: splats, reprojection, composition
    double foveaMs = 0.0;               // of a picture for the fovea: tracing, guides, denoising
    FrameErrors errors;
    bool onFront = false;        // front of FLIP over ms()
    bool onFovealFront = false;  // front of foveal FLIP over ms()

    // Time of a frame, with its share of the time for its fovea.
    double ms() const { return recipe ? drawMs + foveaMs / recipe->framesPerFovea : drawMs; }
};

struct FrameTradeoff {
    std::vector<ModelPoint> models;  // the usual one first
    std::vector<FramePoint> frames;  // over the usual model; splats alone first
};

std::vector<CostAndError> costsOf(std::span<const ModelPoint> models);
std::vector<CostAndError> costsOf(std::span<const FramePoint> frames, double FrameErrors::*error);
// Sets for each point whether it lies on its fronts.
void markFronts(FrameTradeoff& tradeoff);

// Levels must have at least one value each. Fails with `cancelled`; with inputNotUsable if nothing can be
// seen; with usage if the samples of the truth are odd, or lights follow the camera.
Result<FrameTradeoff> measureFrameTradeoff(const BenchStudy& study, const FrameTradeoffOptions& options,
                                           Progress& progress);

// The results as JSON and as plots; neither contains patient data. The report begins with `describe` of its
// study. Unknown values, and the recipe of splats alone, are null.
nlohmann::ordered_json reportOf(const BenchStudy& study, const FrameTradeoffOptions& options,
                                const FrameTradeoff& result);
nlohmann::ordered_json toJson(const ModelPoint& point);
nlohmann::ordered_json toJson(const FramePoint& point);

// Three plots: FLIP of whole frames over milliseconds, FLIP around the gaze over milliseconds, and FLIP of
// models over seconds. The first two show splats alone, a Pareto front for each field of the fovea, and the
// front of all; the third shows a curve for each varied quantity, and the front.
std::vector<Plot> plotsOf(const FrameTradeoff& tradeoff);

}  // namespace macula::evaluate
