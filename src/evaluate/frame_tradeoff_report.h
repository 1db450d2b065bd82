// What can be traded in hybrid frames, as JSON and as curves. Neither holds patient data.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "evaluate/bench_study.h"
#include "evaluate/frame_tradeoff.h"
#include "evaluate/svg_plot.h"

namespace macula::evaluate {

// Begins as `describe` of its study. What is not known, and the recipe of splats alone, is null.
nlohmann::ordered_json reportOf(const BenchStudy& study, const FrameTradeoffOptions& options,
                                const FrameTradeoff& result);
nlohmann::ordered_json toJson(const ModelPoint& point);
nlohmann::ordered_json toJson(const FramePoint& point);

// Three plots: FLIP of whole frames over milliseconds, FLIP around the gaze over milliseconds, and FLIP of
// models over seconds. The first two draw splats alone, a Pareto front for each field of the fovea, and that
// of all; the third a curve for each thing that is varied, and the front.
std::vector<Plot> plotsOf(const FrameTradeoff& tradeoff);

}  // namespace macula::evaluate
