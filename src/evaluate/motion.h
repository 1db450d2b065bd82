// Measures the quality of a frame whose eye has moved since its fovea was traced: with the fovea reprojected,
// with the fovea left in place on the screen, and with splats alone; each compared with a picture traced for
// the present eye.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/measurement.h"
#include "image/edges.h"
#include "image/frame_metrics.h"
#include "pipeline/hybrid/model/first_model.h"

namespace macula::evaluate {

struct MotionOptions {
    glm::ivec2 sizePx{360, 360};
    double verticalFovDeg = 40.0;
    std::vector<double> stepsMm{1.0, 5.0, 20.0};   // to the side
    std::vector<double> turnsDeg{1.0, 5.0, 20.0};  // of the head to the side, around the eye
    std::uint32_t foveaSamples = 4;                // denoised
    std::uint32_t truthSamples = 128;              // not denoised
    hybrid::FirstModelOptions model;
    // A folder for VIEW-MOVED-AMOUNT-WAY.png and …-traced.png; empty: none.
    std::filesystem::path pictures = {};
};

enum class Moved { step, turn };
// The name in reports: "step", "turn".
std::string_view nameOf(Moved moved);

// The score of one way to make a frame.
struct FrameScore {
    double flip = 0.0;        // of the whole frame
    double fovealFlip = 0.0;  // of kFovealFieldDeg around its middle
    std::size_t through = 0;  // pixels that show background where truth and neighbours have none
    std::optional<image::SeamVisibility> seam;  // of the fovea's border; nothing without a fovea
    // Along the truth's silhouette in the middle, and where fovea and splats are mixed; nothing without such
    // pixels.
    std::optional<image::EdgeVisibility> silhouette;
    std::optional<image::EdgeVisibility> mixed;
    // Pixels of the middle that are darker than both splats alone and the truth, by more than kDarkerBy.
    std::size_t darker = 0;
    static constexpr double kDarkerBy = 0.02;
};

struct MovedFrame {
    Moved moved = Moved::step;
    double amount = 0.0;    // mm or degrees
    std::string_view from;  // name of the viewpoint
    FrameScore reprojected;
    FrameScore pasted;  // with the fovea left in place on the screen
    FrameScore splats;
    double drawMs = 0.0;        // of the frame: splats, reprojection, composition
    double splatsDrawMs = 0.0;  // without the fovea
};

struct MotionReport {
    std::vector<MovedFrame> frames;
    std::size_t splats = 0;
    double foveaMs = 0.0;  // of the last picture for the fovea
    // The shares of frames in which reprojection has the least FLIP: over the whole frame, over the middle.
    double best = 0.0;
    double fovealBest = 0.0;
};

// From the front, the left, and above. Fails with `cancelled`, and with inputNotUsable if nothing can be
// seen.
Result<MotionReport> measureMotion(const BenchStudy& study, const MotionOptions& options, Progress& progress);

}  // namespace macula::evaluate
