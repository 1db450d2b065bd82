#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <random>
#include <utility>

#include "base/sha256.h"

namespace macula::log {

namespace {

spdlog::level::level_enum spdlogLevel(Level level) {
    switch (level) {
        case Level::debug:
            return spdlog::level::debug;
        case Level::info:
            return spdlog::level::info;
        case Level::warning:
            return spdlog::level::warn;
        case Level::error:
            return spdlog::level::err;
        case Level::off:
            break;
    }
    return spdlog::level::off;
}

Level levelFromEnvironment() {
    const char* text = std::getenv("MACULA_LOG");
    const std::string_view name = text ? text : "";
    if (name == "debug") return Level::debug;
    if (name == "info") return Level::info;
    if (name == "error") return Level::error;
    if (name == "off") return Level::off;
    return Level::warning;
}

// The logger, the sink and the key below are never destroyed, because threads log until the process has
// ended.
spdlog::logger& logger() {
    static auto* const instance = [] {
        auto* made = new spdlog::logger("macula", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        made->set_pattern("%H:%M:%S.%e %^%l%$ %v");
        made->set_level(spdlogLevel(levelFromEnvironment()));
        return made;
    }();
    return *instance;
}

struct SinkOfHost {
    std::mutex mutex;
    Sink sink;  // empty: no sink
};

SinkOfHost& sinkOfHost() {
    static auto* const instance = new SinkOfHost;
    return *instance;
}

// Gives the line to the host's sink. False if there is none.
bool giveToSink(Level level, std::string_view line) {
    SinkOfHost& host = sinkOfHost();
    const std::lock_guard lock(host.mutex);
    if (host.sink) host.sink(level, line);
    return bool(host.sink);
}

}  // namespace

void setLevel(Level level) {
    logger().set_level(spdlogLevel(level));
}

void setSink(Sink sink) {
    SinkOfHost& host = sinkOfHost();
    const std::lock_guard lock(host.mutex);
    host.sink = std::move(sink);
}

bool hasSink() {
    SinkOfHost& host = sinkOfHost();
    const std::lock_guard lock(host.mutex);
    return bool(host.sink);
}

void write(Level level, std::string_view line) {
    if (level == Level::off || !logger().should_log(spdlogLevel(level))) return;
    if (!giveToSink(level, line)) logger().log(spdlogLevel(level), line);
}

void announce(std::string_view line) {
    if (giveToSink(Level::info, line)) return;
    std::fputs(fmt::format("{}\n", line).c_str(), stderr);
}

std::string redact(std::string_view text) {
    static const auto* const key = [] {
        std::random_device device;
        return new std::string(
            fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device()));
    }();
    return sha256Hex(*key + std::string(text)).substr(0, 8);
}

}  // namespace macula::log
