// The results of frame_tradeoff.h as JSON and as plots. Neither contains patient data.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "evaluate/bench_study.h"
#include "evaluate/frame_tradeoff.h"
#include "evaluate/svg_plot.h"

namespace macula::evaluate {

// Begins with `describe` of its study. Unknown values, and the recipe of splats alone, are null.
nlohmann::ordered_json reportOf(const BenchStudy& study, const FrameTradeoffOptions& options,
                                const FrameTradeoff& result);
nlohmann::ordered_json toJson(const ModelPoint& point);
nlohmann::ordered_json toJson(const FramePoint& point);

// Three plots: FLIP of whole frames over milliseconds, FLIP around the gaze over milliseconds, and FLIP of
// models over seconds. The first two show splats alone, a Pareto front for each field of the fovea, and the
// front of all; the third shows a curve for each varied quantity, and the front.
std::vector<Plot> plotsOf(const FrameTradeoff& tradeoff);

}  // namespace macula::evaluate
