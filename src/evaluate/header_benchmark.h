// How fast headers are read, beside DCMTK alone.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "base/result.h"

namespace macula::evaluate {

struct HeaderBenchmark {
    std::size_t files = 0;  // that hold DICOM, each read once per round
    std::size_t threads = 0;
    int rounds = 0;
    // Of the fastest round, all of them with a warm cache.
    double headersPerSecond = 0.0;    // readHeader
    double bareDcmtkPerSecond = 0.0;  // DcmFileFormat::loadFileUntilTag up to PixelData, and nothing else
    double scanPerSecond =
        0.0;  // scanFolder, which groups and sorts too; on all cores, whatever `threads` is
};

// The contenders take turns. Fails like scanFolder.
Result<HeaderBenchmark> benchmarkHeaders(const std::filesystem::path& path, std::size_t threads, int rounds,
                                         Progress& progress);

}  // namespace macula::evaluate
