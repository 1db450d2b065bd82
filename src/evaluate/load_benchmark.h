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
#include "dicom/scan.h"

namespace macula::evaluate {

struct LoadBenchmarkOptions {
    std::vector<std::filesystem::path> files;  // of the volume's slices, sorted, one frame each
    std::function<Result<std::shared_ptr<const Volume>>(Progress&)> load;  // what is measured
    std::size_t threads = 2;  // of ITK and of DCMTK; ours takes all cores
    int rounds = 5;           // the contenders take turns, so that a busy neighbour hits all
};

// One file for each slice, in their order; nothing when slices are interpolated, or share a file.
std::vector<std::filesystem::path> filesOf(const dicom::Stack& stack);

struct Loading {
    double seconds = 0.0;          // median
    std::uint64_t peakBytes = 0;   // resident memory of the process while it loaded; largest of all rounds
    double secondsOverOurs = 0.0;  // median of the ratios of each round
};

struct LoadBenchmark {
    std::uint64_t bytesBefore = 0;  // resident before each of them
    Loading ours;
    std::optional<Loading> itk;    // itk::ImageSeriesReader with GDCM; absent when that cannot read the files
    std::optional<Loading> dcmtk;  // chooseRepresentation and a copy of the cells alone; absent likewise
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
