#include "dicom/memory.h"

#include <fmt/format.h>

#include <fstream>
#include <string>

namespace macula::dicom {

std::optional<std::uint64_t> availableMemory() {
    std::ifstream stream("/proc/meminfo");
    std::string name;
    std::uint64_t kibibytes = 0;
    std::string rest;
    while (stream >> name >> kibibytes && std::getline(stream, rest)) {
        if (name == "MemAvailable:") return kibibytes * 1024;
    }
    return {};
}

Error notEnoughMemory(std::uint64_t bytesNeeded, std::optional<std::uint64_t> bytesAvailable) {
    const auto gibibytes = [](std::uint64_t bytes) {
        return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / static_cast<double>(1u << 30));
    };
    return {ErrorCode::outOfMemory,
            fmt::format("There is not enough memory for this series: it needs {}{}.", gibibytes(bytesNeeded),
                        bytesAvailable ? fmt::format(", and {} are free", gibibytes(*bytesAvailable)) : ""),
            {},
            "Close other programs, or choose a smaller series."};
}

}  // namespace macula::dicom
