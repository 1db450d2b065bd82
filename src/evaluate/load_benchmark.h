// How fast headers are read, compared with bare DCMTK, and a volume is loaded, compared with ITK's reader of
// series and a bare DCMTK loop in the same run: ratios are comparable between machines, seconds are not.
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

struct HeaderBenchmark {
    std::size_t files = 0;  // with DICOM, each read once per round
    std::size_t threads = 0;
    int rounds = 0;
    // In the fastest round; all rounds have a warm cache.
    double headersPerSecond = 0.0;    // readHeader
    double bareDcmtkPerSecond = 0.0;  // DcmFileFormat::loadFileUntilTag up to PixelData, and nothing else
    double scanPerSecond = 0.0;       // scanFolder, which also groups and sorts; always on all cores
};

// Measures the contenders in alternation. Fails as scanFolder does.
Result<HeaderBenchmark> benchmarkHeaders(const std::filesystem::path& path, std::size_t threads, int rounds,
                                         Progress& progress);

struct LoadBenchmarkOptions {
    std::vector<std::filesystem::path> files;  // of the volume's slices, sorted, one frame each
    std::function<Result<std::shared_ptr<const Volume>>(Progress&)> load;  // the measured loader
    std::size_t threads = 2;  // for ITK and DCMTK; Macula uses all cores
    int rounds = 5;           // contenders alternate, so that other load affects all of them
};

// The file of each slice, in their order; empty if slices are interpolated, or share a file.
std::vector<std::filesystem::path> filesOf(const dicom::Stack& stack);

struct Loading {
    double seconds = 0.0;          // median
    std::uint64_t peakBytes = 0;   // largest resident memory while loading, over all rounds
    double secondsOverOurs = 0.0;  // median of the ratios of each round
};

struct LoadBenchmark {
    std::uint64_t bytesBefore = 0;  // resident memory before loading
    Loading ours;
    std::optional<Loading> itk;    // itk::ImageSeriesReader with GDCM; nothing if it fails to read
    std::optional<Loading> dcmtk;  // only chooseRepresentation and a copy; nothing likewise
    std::size_t voxels = 0;
    std::size_t differingVoxels = 0;  // whose value ITK reads differently
};

// Does not time the first round, which warms the cache. Fails as `load` does. Runs in a plug-in
// (base/plugin.h), because nothing else needs the other readers.
Result<LoadBenchmark> benchmarkLoading(const LoadBenchmarkOptions& options, Progress& progress);

}  // namespace macula::evaluate

// The plug-in's export, which benchmarkLoading calls.
extern "C" void maculaBenchmarkLoading(const macula::evaluate::LoadBenchmarkOptions& options,
                                       macula::Progress& progress,
                                       macula::Result<macula::evaluate::LoadBenchmark>& result);
