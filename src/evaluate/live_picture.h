// What the live picture is worth over time: a recording of it, as a window shows it, beside pictures that are
// traced until chance hardly matters. It shows how soon there is anything, how a moving hand is followed, how
// fast a picture at rest becomes right, and whether it ever falls back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/live_figures.h"
#include "pictures/recorded_study.h"

namespace macula::evaluate {

struct LivePictureOptions {
    // Size and second drawing are those of the study.
    live::RecordingOptions recording{.movingS = 1.0, .learningS = 10.0, .restingS = 60.0};
    std::uint32_t truthSamples = 512;  // of each reference; even
};

// A camera at rest.
struct RestCourse {
    std::vector<RestPicture> pictures;  // those that were kept
    double referenceFlip = 0.0;         // of half the samples of the reference to all: what chance leaves
};

struct PresetChange {
    std::string preset;  // a name that may be told
    ChangeTimes times;
    RestCourse rest;
};

struct LivePictureReport {
    pictures::MotionFigures motion;
    std::optional<double> firstModelS;
    RestCourse rest;
    std::optional<PresetChange> change;  // where the study has a second preset
    int bounces = 0;                     // of all that is traced
    bool isFull = false;                 // pictures were left out because of their number
};

// All that can be known to be wrong before anything takes time: `usage` for presets that are none, lights
// that are not built in (a window has no others), and samples that cannot be halved.
Result<void> check(const BenchStudyOptions& study, const LivePictureOptions& options);

// The recording has a device of its own, which is gone when references are traced. They have the bounces of
// the live picture, another seed, and are not denoised; all pictures are over black. `cancelled`;
// inputNotUsable when nothing can be seen; as live::recordLive.
Result<LivePictureReport> measureLivePicture(const BenchStudy& study, const LivePictureOptions& options,
                                             Progress& progress);

}  // namespace macula::evaluate
