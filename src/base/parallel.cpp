#include "base/parallel.h"

#include <algorithm>
#include <thread>
#include <vector>

#include "base/process_limits.h"

namespace macula {

std::size_t coreCount() {
    static const std::size_t count = usableProcessors();  // asked of files
    return count;
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, const CancelToken& token) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count && !token.cancelled(); i = next++) body(i);
    };
    std::vector<std::jthread> helpers(std::min(coreCount(), std::max<std::size_t>(count, 1)) - 1);
    for (auto& helper : helpers) helper = std::jthread(work);
    work();
}

}  // namespace macula
