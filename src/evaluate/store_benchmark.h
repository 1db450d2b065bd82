// Measures a study store (session/store.h) as large as after years of use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"

namespace macula::evaluate {

struct StoreBenchmarkOptions {
    int studies = 10'000;
    int seriesPerStudy = 5;  // each with a volume of its own
    int models = 2'000;      // two for each volume that has any: at most twice the number of volumes
    std::size_t modelBytes = 16'384;
    int repetitions = 9;  // the report has medians
};

struct StoreBenchmark {
    double makeSeconds = 0.0;      // with calls of the store
    bool wasMadeInMemory = false;  // and then copied
    // As the store lists them.
    std::size_t studies = 0;
    std::size_t series = 0;
    std::size_t models = 0;
    std::uint64_t modelBytes = 0;  // of all models
    double openMs = 0.0;
    double firstListingMs = 0.0;  // of all studies, for the first time
    double listingMs = 0.0;
    double findMs = 0.0;         // one model by its key
    double findAndReadMs = 0.0;  // likewise, and its blob, checked
    double evictionMs = 0.0;     // to half of modelBytes
    std::size_t evictedModels = 0;
    std::uint64_t capBytes = 0;       // half of modelBytes
    std::uint64_t bytesLeft = 0;      // as listed after eviction
    std::uint64_t fileBytesLeft = 0;  // in the folder of the blobs

    bool capHolds() const { return bytesLeft <= capBytes && fileBytesLeft <= capBytes; }
};

// Makes `folder`, which must not exist yet, in an existing folder, and leaves it there. Fails with
// `cancelled`, and as the store does.
Result<StoreBenchmark> measureStore(const std::filesystem::path& folder, const StoreBenchmarkOptions& options,
                                    Progress& progress);

}  // namespace macula::evaluate
