// Data parallelism over all cores.
#pragma once

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

}  // namespace macula
