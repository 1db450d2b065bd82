// How fast Macula reads headers, compared with bare DCMTK.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "base/result.h"

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

}  // namespace macula::evaluate
