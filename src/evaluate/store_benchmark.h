// What a store of sessions (session/store.h) costs that has grown for years.
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
    int models = 2'000;      // two of each volume that has any: at most twice as many as volumes
    std::size_t modelBytes = 16'384;
    int repetitions = 9;  // medians are told
};

struct StoreBenchmark {
    double makeSeconds = 0.0;      // by calls of the store
    bool wasMadeInMemory = false;  // and then copied
    // As they are listed.
    std::size_t studies = 0;
    std::size_t series = 0;
    std::size_t models = 0;
    std::uint64_t modelBytes = 0;  // of all of them
    double openMs = 0.0;
    double firstListingMs = 0.0;  // of all studies, the first time
    double listingMs = 0.0;
    double findMs = 0.0;         // one model by its key
    double findAndReadMs = 0.0;  // and its blob, checked
    double evictionMs = 0.0;     // to half of modelBytes
    std::size_t evictedModels = 0;
    std::uint64_t capBytes = 0;       // that half
    std::uint64_t bytesLeft = 0;      // as they are listed then
    std::uint64_t fileBytesLeft = 0;  // in the folder of the blobs

    bool capHolds() const { return bytesLeft <= capBytes && fileBytesLeft <= capBytes; }
};

// `folder` is not there yet, and stays; the folder that it is in is there. `cancelled`; and as the store
// fails.
Result<StoreBenchmark> measureStore(const std::filesystem::path& folder, const StoreBenchmarkOptions& options,
                                    Progress& progress);

}  // namespace macula::evaluate
