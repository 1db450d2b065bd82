// Figures from a recording of the live picture. Times are in seconds unless their names say otherwise.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "live/frame/live_recording.h"

namespace macula::evaluate {

// When the first input of the phase was published (RecordedInput::atS). Nothing without such a phase.
std::optional<double> beginS(const live::LiveRecording& recording, live::RecordingPhase phase);

// From the first picture of any kind to the first of the model. Nothing if none came before the camera
// moved.
std::optional<double> firstModelS(const live::LiveRecording& recording);

// How soon the screen followed a change of the drawing, in times since its input was published.
struct ChangeTimes {
    std::optional<double> firstNewS;   // the first picture of the new drawing
    std::optional<double> firstFullS;  // the first one with all pixels: of the model, or traced
    // The longest time without a new picture, until the first one with all pixels, or the recording's end.
    double longestStaleS = 0.0;
    bool wasSaid = false;  // a RecordedNotice came within kSaidS
};
inline constexpr double kSaidS = 0.3;
// Nothing if the drawing did not change.
std::optional<ChangeTimes> changeTimes(const live::LiveRecording& recording);

// A picture of a camera at rest, compared with its reference. Functions below expect them in order of time.
struct RestPicture {
    double atS = 0.0;  // since the rest began
    live::OnScreen picture = live::OnScreen::nothing;
    std::uint64_t samplesPerPixel = 0;   // 0 if it was not traced
    double flip = 0.0;                   // of the whole picture
    std::optional<double> maskedPsnrDb;  // where the reference has coverage; nothing if not finite
};

// The first time after which no picture has a FLIP above `limit`. Nothing if the last one has.
inline constexpr double kNearFlip = 0.02;
std::optional<double> nearFromS(std::span<const RestPicture> pictures, double limit = kNearFlip);

// The largest growth of FLIP over `overS`, which is above 0: the FLIP of a picture minus that of the last one
// at least so much older. Below 0 if FLIP always fell; nothing if no two pictures are so far apart.
inline constexpr double kSetbackS = 5.0;
std::optional<double> worstSetback(std::span<const RestPicture> pictures, double overS = kSetbackS);

// The largest difference between the FLIP of a picture and the least of all earlier ones: 0 or below if no
// picture is worse than one that it replaced. Nothing for fewer than two pictures.
std::optional<double> worstRise(std::span<const RestPicture> pictures);

}  // namespace macula::evaluate
