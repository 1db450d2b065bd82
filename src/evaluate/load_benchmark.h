// How fast a volume is loaded, beside ITK's own reader of series and a bare DCMTK loop, in the same run: a
// ratio means something on every machine, seconds only on one.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::evaluate {

struct LoadBenchmarkOptions {
    std::vector<std::filesystem::path> files;  // of the volume's slices, sorted, one frame each
    std::function<Result<std::shared_ptr<const Volume>>(Progress&)> load;  // what is measured
    std::size_t threads = 2;  // of ITK and of DCMTK; ours takes all cores
    int rounds = 5;           // the contenders take turns, so that a busy neighbour hits all
};

struct LoadBenchmark {
    struct Contender {
        double seconds = 0.0;         // median
        std::uint64_t peakBytes = 0;  // resident memory of the process while it loaded; largest of all rounds
        double secondsOverOurs = 0.0;  // median of the ratios of each round
    };
    std::uint64_t bytesBefore = 0;  // resident before each of them
    Contender ours;
    std::optional<Contender> itk;  // itk::ImageSeriesReader with GDCM; absent when that cannot read the files
    std::optional<Contender>
        dcmtk;  // chooseRepresentation and a copy of the cells, nothing else; absent likewise
    std::size_t voxels = 0;
    std::size_t differingVoxels = 0;  // where ITK's value is another than ours
};

// A first round, which warms the cache, is not timed. Fails like `load`. In a plug-in (base/plugin.h),
// because nothing else needs the readers beside which ours is measured.
Result<LoadBenchmark> benchmarkLoading(const LoadBenchmarkOptions& options, Progress& progress);

}  // namespace macula::evaluate

// The plug-in's export, which benchmarkLoading calls.
extern "C" void maculaBenchmarkLoading(const macula::evaluate::LoadBenchmarkOptions& options,
                                       macula::Progress& progress,
                                       macula::Result<macula::evaluate::LoadBenchmark>& result);
