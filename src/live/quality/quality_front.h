// The measured trade of time against error in frames in motion, and what each point of it means for a window:
// presets/front/live-frame.json, specified by presets/schema/quality-front.schema.json.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "live/frame/frame_input.h"

namespace macula::live {

struct FrontPoint {
    struct Fovea {
        hybrid::FoveaOptions request{};
        int framesPerFovea = 1;  // one fovea is traced per so many frames
        bool operator==(const Fovea&) const = default;
    };
    std::optional<Fovea> fovea = {};  // nothing: splats alone
    double ms = 0.0;                  // time of a frame with its share of a fovea, on the machine measured
    double flip = 0.0;                // FLIP error of the whole frame
    double fovealFlip = 0.0;          // FLIP error of the 20 degrees around the gaze

    bool operator==(const FrontPoint&) const = default;
};

struct QualityFront {
    std::string title;
    std::string source;  // for people: the machine and data measured
    glm::ivec2 sizePx{0};
    double verticalFovDeg = 0.0;
    int bounces = 0;             // the same for all points
    double calibrationMs = 0.0;  // time of the trace of calibration.h, on the machine measured
    struct Drawn {
        double pixels = 0.0;
        double ms = 0.0;
    };
    std::vector<Drawn> drawing;      // frames without tracing, by ascending pixels
    std::vector<FrontPoint> points;  // all measured points
    // The points that no other beats in both time and error at the gaze (the Pareto front), by ascending time
    // and falling error. At least two.
    std::vector<FrontPoint> stops;
};

// Fails with inputNotUsable: the message names the line or key, the hint the expected value. `where` is for
// the error.
Result<QualityFront> qualityFrontFromJson(std::string_view text, const std::string& where);
// The quality front built into the programs.
Result<QualityFront> builtInQualityFront();

// The size and field of view of a window.
struct WindowView {
    glm::ivec2 sizePx{0};
    double verticalFovDeg = 30.0;
    bool operator==(const WindowView&) const = default;
};

// The cost of a stop in that window, on a machine that takes `slowness` (above 0) times as long as the one
// that measured. Drawing scales with the pixels, tracing with the pixels of the fovea.
struct FrameCost {
    double drawMs = 0.0;
    double foveaMs = 0.0;    // time of a whole fovea
    double betweenMs = 0.0;  // the part of foveaMs between two frames: at most kMostBetweenFramesMs
    double ms() const { return drawMs + betweenMs; }
};
inline constexpr double kMostBetweenFramesMs = 2000.0;
FrameCost costOf(const QualityFront& front, const FrontPoint& stop, const WindowView& view, double slowness);

// The settings of frames at that stop.
LiveQuality liveQualityOf(const FrontPoint& stop, const FrameCost& cost);

// The last stop whose frames take at most `ms`, or the first stop.
std::size_t stopOf(const QualityFront& front, const WindowView& view, double slowness, double ms);

}  // namespace macula::live
