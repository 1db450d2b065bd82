// What a recording of the live picture tells in numbers. Times are in seconds unless they say otherwise.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "live/frame/live_recording.h"

namespace macula::evaluate {

// When the first input of the phase was published, as RecordedInput::atS. Nothing without such a phase.
std::optional<double> beginS(const live::LiveRecording& recording, live::RecordingPhase phase);

// From the first picture of any kind to the first of the model. Nothing when none came before the camera
// moved.
std::optional<double> firstModelS(const live::LiveRecording& recording);

// What a change of the drawing shows; times are since its input was published.
struct ChangeTimes {
    std::optional<double> firstNewS;   // the first picture of the new drawing
    std::optional<double> firstFullS;  // the first with all pixels: of the model, or traced
    // Without a new picture, at a stretch, until the first with all pixels is there or the recording ends.
    double longestStaleS = 0.0;
    bool wasSaid = false;  // a RecordedNotice came within kSaidS
};
inline constexpr double kSaidS = 0.3;
// Nothing when the drawing did not change.
std::optional<ChangeTimes> changeTimes(const live::LiveRecording& recording);

// A picture of a camera at rest, beside its reference. Below, such pictures are in order of time.
struct RestPicture {
    double atS = 0.0;  // since the rest began
    live::OnScreen picture = live::OnScreen::nothing;
    std::uint64_t samplesPerPixel = 0;   // 0 where it was not traced
    double flip = 0.0;                   // of all of it
    std::optional<double> maskedPsnrDb;  // where the reference has coverage; nothing where it is not finite
};

// The first time from which on no picture has a FLIP above `limit`. Nothing when the last one has.
inline constexpr double kNearFlip = 0.02;
std::optional<double> nearFromS(std::span<const RestPicture> pictures, double limit = kNearFlip);

// By how much FLIP has grown at most: that of a picture less that of the last one that is older by `overS`,
// which is above 0. Below 0 when it fell all along; nothing when no two pictures are so far apart.
inline constexpr double kSetbackS = 5.0;
std::optional<double> worstSetback(std::span<const RestPicture> pictures, double overS = kSetbackS);

// By how much the FLIP of a picture is at most above the least that any before it has: 0 or below when no
// picture is worse than one that it has replaced. Nothing for fewer than two pictures.
std::optional<double> worstRise(std::span<const RestPicture> pictures);

}  // namespace macula::evaluate
