#include "evaluate/live_figures.h"

#include <algorithm>

namespace macula::evaluate {

namespace {

bool hasAllPixels(live::OnScreen picture) {
    return picture != live::OnScreen::nothing && picture != live::OnScreen::preview;
}

}  // namespace

std::optional<double> beginS(const live::LiveRecording& recording, live::RecordingPhase phase) {
    const auto first = std::ranges::find(recording.inputs, phase, &live::RecordedInput::phase);
    return first == recording.inputs.end() ? std::nullopt : std::optional(first->atS);
}

std::optional<double> firstModelS(const live::LiveRecording& recording) {
    for (const live::RecordedFrame& frame : recording.frames) {
        if (frame.phase != live::RecordingPhase::opening) break;
        if (frame.shown.picture == live::OnScreen::model) return frame.atS - recording.frames.front().atS;
    }
    return std::nullopt;
}

std::optional<ChangeTimes> changeTimes(const live::LiveRecording& recording) {
    const std::optional<double> changedS = beginS(recording, live::RecordingPhase::changed);
    if (!changedS) return std::nullopt;
    ChangeTimes times;
    times.wasSaid = std::ranges::any_of(recording.notices, [&](const live::RecordedNotice& notice) {
        return notice.atS >= *changedS && notice.atS <= *changedS + kSaidS;
    });
    double lastS = *changedS;
    const auto newsAt = [&](double atS) {
        times.longestStaleS = std::max(times.longestStaleS, atS - lastS);
        lastS = atS;
    };
    for (const live::RecordedFrame& frame : recording.frames) {
        if (frame.phase != live::RecordingPhase::changed) continue;
        newsAt(frame.atS);
        if (!times.firstNewS) times.firstNewS = frame.atS - *changedS;
        if (!hasAllPixels(frame.shown.picture)) continue;
        times.firstFullS = frame.atS - *changedS;
        return times;
    }
    newsAt(recording.seconds);
    return times;
}

std::optional<double> nearFromS(std::span<const RestPicture> pictures, double limit) {
    std::optional<double> fromS;
    for (const RestPicture& picture : pictures) {
        if (!(picture.flip <= limit))
            fromS.reset();
        else if (!fromS)
            fromS = picture.atS;
    }
    return fromS;
}

std::optional<double> worstSetback(std::span<const RestPicture> pictures, double overS) {
    std::optional<double> worst;
    std::size_t old = 0;  // how many are older than `picture` by `overS`
    for (const RestPicture& picture : pictures) {
        while (pictures[old].atS <= picture.atS - overS) ++old;
        if (old == 0) continue;
        const double grown = picture.flip - pictures[old - 1].flip;
        worst = std::max(worst.value_or(grown), grown);
    }
    return worst;
}

std::optional<double> worstRise(std::span<const RestPicture> pictures) {
    std::optional<double> worst;
    std::optional<double> least;
    for (const RestPicture& picture : pictures) {
        if (least) worst = std::max(worst.value_or(picture.flip - *least), picture.flip - *least);
        least = std::min(least.value_or(picture.flip), picture.flip);
    }
    return worst;
}

}  // namespace macula::evaluate
