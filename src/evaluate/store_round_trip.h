// What it costs to keep a peripheral model between runs of the program: a model learns, is saved while frames
// are drawn, is put away, and is gone on with, on a device that has the volume all the time.
//
// Targets: the first picture of the model 300 ms after the volume is on the device, for which its splats are
// there in 30 ms; no frame later by more than 5 ms for saving; in a store of 10 000 studies and 2 000 models
// 50 ms to list studies, and 30 ms to find and read a model.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/frame_times.h"
#include "evaluate/session_reopening.h"
#include "evaluate/store_benchmark.h"

namespace macula::evaluate {

struct StoreRoundTripOptions {
    double learnS = 20.0;  // at least until the model can be drawn
    int frames = 50;       // of a block, one turn around the patient
    int blocks = 4;        // with saving; as many without take turns with them
    // New or empty, and then it stays. None: a temporary one.
    std::filesystem::path folder;
    bool large = false;  // measureStore too
};

struct LearntModel {
    double seconds = 0.0;
    std::string_view stage;  // nameOf
    std::uint64_t steps = 0;
    std::size_t splats = 0;  // that are shown
    std::size_t views = 0;
    std::size_t heldOut = 0;
    std::optional<double> trainedError;  // as of Reopening
    std::optional<double> shownError;
};

struct SavingTimes {
    FrameTimes without;  // of blocks without saving
    FrameTimes beside;   // that began while a save was asked for, which is part of them, or under way
    std::size_t framesBetween = 0;  // of blocks with saving, after one was done
    std::vector<double> callsMs;    // to ask for a save, of the thread that draws
    double firstMs = 0.0;           // until the store has it; nothing was packed before
    double laterMs = 0.0;           // likewise, of a model whose pictures are packed; a median
    std::uint64_t firstBytes = 0;   // of the blob
    std::uint64_t laterBytes = 0;

    double slowerMs(double fraction) const {
        return beside.percentileMs(fraction) - without.percentileMs(fraction);
    }
};

struct ClosingTimes {
    double hideMs = 0.0;   // of the thread that draws
    double savedMs = 0.0;  // until the keeper has ended; from the same start
};

struct StoreRoundTrip {
    LearntModel learnt;  // as it was put away
    SavingTimes saving;
    ClosingTimes closing;
    ReadingTimes reading;
    std::vector<Reopening> reopenings;
    std::optional<StoreBenchmark> store;
};

// What can be known to be wrong before anything takes time: usage for lights that are not built in or hang on
// the camera; outputNotWritable for a folder that holds anything.
Result<void> check(const BenchStudyOptions& study, const StoreRoundTripOptions& options);

// inputNotUsable when nothing can be seen; outOfMemory when the device has no room for a model; `cancelled`;
// and what the keeper has to tell, the first of it.
Result<StoreRoundTrip> measureSession(const BenchStudy& study, const StoreRoundTripOptions& options,
                                      Progress& progress);

}  // namespace macula::evaluate
