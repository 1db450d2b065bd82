// The cost of keeping a peripheral model between runs of the program: a model learns, is saved while frames
// are drawn, is put away, and is resumed, on a device that has the volume all the time.
//
// Targets: the first picture of the model 300 ms after the volume is on the device, with splats found within
// 30 ms; no frame more than 5 ms slower because of saving; in a store of 10 000 studies and 2 000 models, 50
// ms to list studies, and 30 ms to find and read a model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/session_reopening.h"
#include "evaluate/store_benchmark.h"

namespace macula::evaluate {

// Upper edges of buckets. A frame belongs to the first bucket whose edge it does not exceed, or to an
// additional one after the last.
inline constexpr std::array kFrameBucketsMs{5.0,   10.0,  20.0,  30.0,  50.0,  75.0,
                                            100.0, 150.0, 200.0, 300.0, 500.0, 1000.0};

// Wall-clock times of single frames, from the first call until the device has drawn the frame: percentiles
// and the maximum, because a mean would hide a late frame.
struct FrameTimes {
    std::vector<double> ms;

    // Need at least one frame; `fraction` as in image::percentile.
    double percentileMs(double fraction) const;
    double maxMs() const;
    // Frames in each bucket.
    std::array<std::size_t, kFrameBucketsMs.size() + 1> histogram() const;
};

struct StoreRoundTripOptions {
    double learnS = 20.0;  // or longer, until the model can be drawn
    int frames = 50;       // in a block: one turn around the patient
    int blocks = 4;        // with saving, in alternation with as many without
    // A new or empty folder, which stays. Empty path: a temporary folder.
    std::filesystem::path folder;
    bool large = false;  // also calls measureStore
};

struct LearntModel {
    double seconds = 0.0;
    std::string_view stage;  // nameOf
    std::uint64_t steps = 0;
    std::size_t splats = 0;  // those shown
    std::size_t views = 0;
    std::size_t heldOut = 0;
    std::optional<double> trainedError;  // as in Reopening
    std::optional<double> shownError;
};

struct SavingTimes {
    FrameTimes without;             // frames of blocks without saving
    FrameTimes beside;              // frames that asked for a save, or were drawn during one
    std::size_t framesBetween = 0;  // frames of blocks with saving, drawn between saves
    std::vector<double> callsMs;    // to ask for a save, in the thread that draws
    double firstMs = 0.0;           // of the first save, when no picture is packed yet
    double laterMs = 0.0;           // of later saves, with packed pictures; median
    std::uint64_t firstBytes = 0;   // size of the blob
    std::uint64_t laterBytes = 0;

    double slowerMs(double fraction) const {
        return beside.percentileMs(fraction) - without.percentileMs(fraction);
    }
};

struct ClosingTimes {
    double hideMs = 0.0;   // in the thread that draws
    double savedMs = 0.0;  // until the keeper has ended, from the same start
};

struct StoreRoundTrip {
    LearntModel learnt;  // as it was when put away
    SavingTimes saving;
    ClosingTimes closing;
    ReadingTimes reading;
    std::vector<Reopening> reopenings;
    std::optional<StoreBenchmark> store;
};

// Finds errors before any measurement. Fails with usage for lights that are not built in or follow the
// camera, and with outputNotWritable for a folder that is not empty.
Result<void> check(const BenchStudyOptions& study, const StoreRoundTripOptions& options);

// Fails with inputNotUsable if nothing can be seen; with outOfMemory if the device has no room for a model;
// with `cancelled`; and with the first error of a keeper.
Result<StoreRoundTrip> measureSession(const BenchStudy& study, const StoreRoundTripOptions& options,
                                      Progress& progress);

// All results as JSON, null for those that do not exist. `store` is present only if it was measured.
nlohmann::ordered_json toJson(const StoreRoundTrip& measured);

// Begins with `describe` of the study; contains no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const StoreRoundTripOptions& options,
                                const StoreRoundTrip& measured);

}  // namespace macula::evaluate
