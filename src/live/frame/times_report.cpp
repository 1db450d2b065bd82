#include "live/frame/times_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace macula::live {

namespace {

constexpr const char* kNothingToDo = "nothing to do";

double rounded(double ms) {
    return std::round(100.0 * ms) / 100.0;
}

}  // namespace

nlohmann::ordered_json toJson(std::vector<StageTimes> stages, double watchedMs) {
    std::sort(stages.begin(), stages.end(),
              [](const StageTimes& a, const StageTimes& b) { return a.ms > b.ms; });
    auto json = nlohmann::ordered_json::array();
    double sumMs = 0.0;
    for (const StageTimes& stage : stages) {
        sumMs += stage.ms;
        json.push_back({{"stage", stage.name},
                        {"times", stage.times},
                        {"ms", rounded(stage.ms)},
                        {"waitedMs", rounded(stage.waitedMs)},
                        {"longestMs", rounded(stage.longestMs)}});
    }
    if (watchedMs > sumMs)
        json.push_back({{"stage", kNothingToDo},
                        {"times", 1},
                        {"ms", rounded(watchedMs - sumMs)},
                        {"waitedMs", rounded(watchedMs - sumMs)},
                        {"longestMs", rounded(watchedMs - sumMs)}});
    return json;
}

std::string tableOf(const nlohmann::ordered_json& times) {
    double allMs = 0.0;
    for (const auto& stage : times) allMs += stage.at("ms").get<double>();
    std::string table = fmt::format("{:<26}{:>8}{:>10}{:>8}{:>10}{:>12}\n", "stage", "times", "ms", "share",
                                    "waited", "longest");
    for (const auto& stage : times) {
        const auto ms = stage.at("ms").get<double>();
        if (!(ms >= 0.001 * allMs)) continue;
        table += fmt::format("{:<26}{:>8}{:>10.0f}{:>7.1f}%{:>10.0f}{:>12.1f}\n",
                             stage.at("stage").get<std::string>(), stage.at("times").get<std::uint64_t>(), ms,
                             100.0 * ms / allMs, stage.at("waitedMs").get<double>(),
                             stage.at("longestMs").get<double>());
    }
    return table;
}

}  // namespace macula::live
