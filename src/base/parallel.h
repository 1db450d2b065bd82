// Data parallelism over all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "base/progress.h"

namespace macula {

// Number of cores this process may use, at least 1.
std::size_t coreCount();

// Calls body(i) once for each i in [0, count), in no particular order, on all cores, and returns when all
// calls are done. Once the token is cancelled or a call throws, no further call starts; the caller gets the
// first exception.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                 const CancelToken& token = {});

// Calls body(first, count) for portions of `size` elements, on all cores.
template <class Body>
void inChunks(std::size_t size, const Body& body) {
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    parallelFor((size + kChunk - 1) / kChunk,
                [&](std::size_t chunk) { body(chunk * kChunk, std::min(kChunk, size - chunk * kChunk)); });
}

}  // namespace macula
