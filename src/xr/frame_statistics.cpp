#include "xr/frame_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace macula::xr {

namespace {

constexpr double kMsPerNs = 1e-6;
// A longer gap is not a late frame: the computer slept.
constexpr double kMostMissed = 1000.0;

constexpr double FrameTimes::*kStages[] = {&FrameTimes::waitMs, &FrameTimes::lookMs,   &FrameTimes::lendMs,
                                           &FrameTimes::drawMs, &FrameTimes::submitMs, &FrameTimes::deviceMs,
                                           &FrameTimes::workMs, &FrameTimes::drawnMs};

double finite(double ms) {
    return std::isfinite(ms) ? std::max(ms, 0.0) : 0.0;
}

}  // namespace

double FrameFigures::inTimePercent() const {
    return frames == 0 ? 100.0 : 100.0 * double(frames) / double(frames + missed);
}

void FrameStatistics::note(const FrameTimes& frame) {
    if (displayedNs_ && frame.periodMs > 0.0) {
        const double periods = double(frame.displayedNs - *displayedNs_) * kMsPerNs / frame.periodMs;
        const double missed = std::round(periods) - 1.0;
        if (missed >= 1.0 && missed <= kMostMissed) {
            sums_.missed += std::uint64_t(missed);
            ++sums_.late;
        }
    }
    displayedNs_ = frame.displayedNs;
    ++sums_.frames;
    sums_.periodMs += finite(frame.periodMs);
    if (frame.isEmpty) {
        ++sums_.empty;
        return;
    }
    for (const auto stage : kStages) sums_.mean.*stage += finite(frame.*stage);
    sums_.longestMs = std::max(sums_.longestMs, finite(frame.drawnMs));
    sums_.worstLevel = std::max(sums_.worstLevel, frame.level);
    sums_.lastLevel = frame.level;
}

FrameFigures FrameStatistics::figures() const {
    FrameFigures figures = sums_;
    if (figures.frames > 0) figures.periodMs /= double(figures.frames);
    const std::uint64_t drawn = figures.frames - figures.empty;
    for (const auto stage : kStages)
        if (drawn > 0) figures.mean.*stage /= double(drawn);
    figures.mean.periodMs = figures.periodMs;
    return figures;
}

std::string textOf(const FrameFigures& figures) {
    const FrameTimes& mean = figures.mean;
    return fmt::format(
        "In time:  {:.1f} % of {} frames, {:.1f} ms each; {} times the headset had none, after {} late "
        "ones\nDrawn in: {:.1f} ms, the longest in {:.1f} ms\nOf that:  look {:.1f}, images {:.1f}, tell "
        "{:.1f}, submit {:.1f}, device {:.1f} ms; then {:.1f} ms of work for later frames\nLeft out: level "
        "{} at the end, {} at most",
        figures.inTimePercent(), figures.frames, figures.periodMs, figures.missed, figures.late, mean.drawnMs,
        figures.longestMs, mean.lookMs, mean.lendMs, mean.drawMs, mean.submitMs, mean.deviceMs, mean.workMs,
        figures.lastLevel, figures.worstLevel);
}

}  // namespace macula::xr
