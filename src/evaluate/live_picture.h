// The quality of the live picture over time: compares a recording of it, as a window shows it, with traced
// pictures that have hardly any noise. It shows how soon there is a picture, how it follows a moving hand,
// how fast a picture at rest converges, and whether it ever becomes worse.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
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
    // Size and second drawing come from the study.
    live::RecordingOptions recording{.movingS = 1.0, .learningS = 10.0, .restingS = 60.0};
    std::uint32_t truthSamples = 512;  // of each reference; even
};

// How the picture of a camera at rest develops.
struct RestCourse {
    std::vector<RestPicture> pictures;  // those kept by the recording
    double referenceFlip = 0.0;         // remaining noise: of half the reference's samples to all
};

struct PresetChange {
    std::string preset;  // a name without private parts
    ChangeTimes times;
    RestCourse rest;
};

struct LivePictureReport {
    pictures::MotionFigures motion;
    std::optional<double> firstModelS;
    RestCourse rest;
    std::optional<PresetChange> change;  // if the study has a second preset
    int bounces = 0;                     // of everything traced
    bool isFull = false;                 // the recording dropped pictures, because there were too many
};

// Finds errors before any measurement. Fails with usage for unknown presets, for lights that are not built in
// (a window has no others), and for an odd number of samples.
Result<void> check(const BenchStudyOptions& study, const LivePictureOptions& options);

// The recording has a device of its own, which is closed before references are traced. References have the
// bounces of the live picture and another seed, and are not denoised; all pictures are over black. Fails with
// `cancelled`; with inputNotUsable if nothing can be seen; and as live::recordLive does.
Result<LivePictureReport> measureLivePicture(const BenchStudy& study, const LivePictureOptions& options,
                                             Progress& progress);

// All results, null for those that do not exist; docs/hybrid-frame.md says what each number is.
nlohmann::ordered_json toJson(const LivePictureReport& report);

// Begins with `describe` of the study; contains no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const LivePictureOptions& options,
                                const LivePictureReport& report);

}  // namespace macula::evaluate
