// What was measured of time against error in frames in motion, and what each of these trades means for a
// window: presets/front/live-frame.json, of which presets/schema/quality-front.schema.json is the reference.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "live/frame/live_quality.h"

namespace macula::app {

struct FrontPoint {
    struct Fovea {
        hybrid::FoveaWish wish{};
        int framesPerFovea = 1;  // it is traced once in so many frames
        bool operator==(const Fovea&) const = default;
    };
    std::optional<Fovea> fovea = {};  // nothing: splats alone
    double ms = 0.0;                  // of a frame on the machine that measured, with its share of the fovea
    double flip = 0.0;                // of the whole frame
    double fovealFlip = 0.0;          // of 20 degrees around where one looks

    bool operator==(const FrontPoint&) const = default;
};

struct QualityFront {
    std::string title;
    std::string source;  // for people: on what it was measured
    glm::ivec2 sizePx{0};
    double verticalFovDeg = 0.0;
    int bounces = 0;             // of all points
    double calibrationMs = 0.0;  // of the trace of calibration.h, on that machine
    struct Drawn {
        double pixels = 0.0;
        double ms = 0.0;
    };
    std::vector<Drawn> drawing;      // frames without tracing, by pixels, ascending
    std::vector<FrontPoint> points;  // all that were measured
    // Of these the ones that no other beats both in time and in error where one looks: ever slower, and ever
    // nearer the truth. At least two.
    std::vector<FrontPoint> stops;
};

// inputNotUsable: the message tells the line or the key, the hint what was expected. `where` is for the
// error.
Result<QualityFront> qualityFrontFromJson(std::string_view text, const std::string& where);
// The one that the programs carry.
Result<QualityFront> builtInQualityFront();

// What is seen in a window.
struct WindowView {
    glm::ivec2 sizePx{0};
    double verticalFovDeg = 30.0;
    bool operator==(const WindowView&) const = default;
};

// What a stop costs in that window, on a machine that takes `slowness` times as long as the one that
// measured; above 0. Drawing goes by pixels, tracing by the pixels of the fovea.
struct FrameCost {
    double drawMs = 0.0;
    double foveaMs = 0.0;    // of a whole one
    double betweenMs = 0.0;  // of that, between two frames: at most kMostBetweenFramesMs
    double ms() const { return drawMs + betweenMs; }
};
inline constexpr double kMostBetweenFramesMs = 2000.0;
FrameCost costOf(const QualityFront& front, const FrontPoint& stop, const WindowView& view, double slowness);

// How frames are made at that stop.
LiveQuality liveQualityOf(const FrontPoint& stop, const FrameCost& cost);

// The stop whose frames take about `ms`: the last that takes no longer, or the first.
std::size_t stopOf(const QualityFront& front, const WindowView& view, double slowness, double ms);

}  // namespace macula::app
