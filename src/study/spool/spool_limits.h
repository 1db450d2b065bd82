// How much the spool takes.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace macula::study {

struct SpoolLimits {
    // How long to wait for another fetch of the same study, such as one that was cancelled and still ends.
    std::chrono::milliseconds patience{10'000};
    std::uintmax_t mostBytes = 50ull << 30;      // of all studies; those used longest ago go first
    std::uintmax_t leastFreeBytes = 1ull << 30;  // left on the disk
    std::uintmax_t mostBytesOfInstance = 8ull << 30;
    std::size_t mostInstancesOfStudy = 100'000;
};

}  // namespace macula::study
