#include "base/available_memory.h"

#include "base/process_limits.h"

namespace macula {

std::optional<std::uint64_t> availableMemory() {
    return availableMemoryBytes();
}

Error notEnoughMemory(std::uint64_t bytesNeeded, std::optional<std::uint64_t> bytesAvailable) {
    const auto gibibytes = [](std::uint64_t bytes) {
        return Text("{:.1f} GiB", static_cast<double>(bytes) / static_cast<double>(1u << 30));
    };
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory for this series: it needs {}{}.", gibibytes(bytesNeeded),
                 bytesAvailable ? Text(", and {} are free", gibibytes(*bytesAvailable)) : Text()),
            {},
            Text("Close other programs, or choose a smaller series.")};
}

}  // namespace macula
