#include "base/utc_time.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace macula {

namespace {

std::string secondsOf(std::time_t time) {
    std::tm utc{};
    gmtime_r(&time, &utc);
    char text[32];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc);
    return std::string(text, length);
}

}  // namespace

std::string nowInUtc() {
    return secondsOf(std::time(nullptr)) + "Z";
}

std::string nowInUtcMs() {
    const auto sinceEpoch = std::chrono::system_clock::now().time_since_epoch();
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count();
    return fmt::format("{}.{:03}Z", secondsOf(static_cast<std::time_t>(ms / 1000)), ms % 1000);
}

}  // namespace macula
