// Measures elapsed time.
#pragma once

#include <chrono>

namespace macula {

// Seconds of wall-clock time.
inline double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace macula
