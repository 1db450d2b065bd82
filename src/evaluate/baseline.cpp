#include "evaluate/baseline.h"

#include <algorithm>
#include <utility>

#include "base/atomic_file.h"

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

bool hasStages(const Json& result) {
    return result.is_object() && result.contains("picture") && result.contains("stages") &&
           result["stages"].is_object() &&
           std::all_of(result["stages"].begin(), result["stages"].end(),
                       [](const Json& stage) { return stage.is_object(); });
}

bool isUsable(const Json& report, std::string_view benchmark) {
    if (!report.is_object() || report.value("benchmark", Json()) != std::string(benchmark) ||
        !report.contains("results"))
        return false;
    const Json& results = report["results"];
    if (benchmark == "load") return results.is_object();
    return results.is_array() &&
           (benchmark != "train" || std::all_of(results.begin(), results.end(), hasStages));
}

std::string_view argumentsOf(std::string_view benchmark) {
    return benchmark == "load" ? " PATH --json" : benchmark == "train" ? " --json" : "";
}

bool isSamePlace(const Json& a, const Json& b) {
    return a.is_object() && b.is_object() &&
           std::ranges::all_of(std::initializer_list<const char*>{"filter", "picture"},
                               [&](const char* key) { return a.value(key, Json()) == b.value(key, Json()); });
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the report that was just made
void compareWith(const Json& before, std::span<const std::string_view> ratios, Json& now) {
    if (now.is_array() && before.is_array()) {
        for (Json& result : now) {
            const auto same = std::find_if(before.begin(), before.end(),
                                           [&](const Json& b) { return isSamePlace(b, result); });
            if (same != before.end()) compareWith(*same, ratios, result);
        }
    }
    if (!now.is_object() || !before.is_object()) return;
    for (auto& [key, value] : now.items()) {
        if (before.contains(key)) compareWith(before[key], ratios, value);
    }
    for (const std::string_view ratio : ratios) {
        const std::string key(ratio);
        const Json earlier = before.value(key, Json());
        if (!now.contains(key) || !now[key].is_number() || !earlier.is_number()) continue;
        if (earlier.get<double>() > 0.0)
            now[key + "OverBaseline"] = now[key].get<double>() / earlier.get<double>();
    }
}

}  // namespace

Result<Baseline> Baseline::read(const std::filesystem::path& path, std::string_view benchmark) {
    MACULA_TRY(const std::string text, readText(path));
    Json report = Json::parse(text, nullptr, false);
    if (isUsable(report, benchmark)) return Baseline(path, std::move(report));
    return Error{ErrorCode::inputNotUsable, Text("The baseline is no output of macula-bench {}.", benchmark),
                 path.string(),
                 Text("Make one with: macula-bench {}{} > baseline.json", benchmark, argumentsOf(benchmark))};
}

Result<void> Baseline::checkSame(const Json& report) const {
    for (const auto& [key, what] : {std::pair{"study", Text("of another series")},
                                    {"preset", Text("of another preset")},
                                    {"deviceKind", Text("of another kind of device")},
                                    {"shDegree", Text("of another degree")},
                                    {"splats", Text("of another number of splats")}}) {
        if (report.contains(key) && report_.value(key, Json()) != report[key])
            return Error{ErrorCode::inputNotUsable, Text("The baseline is {}.", what), path_.string(),
                         Text("Choose one that was made with the same options.")};
    }
    return {};
}

void Baseline::compare(std::span<const std::string_view> ratios, Json& results) const {
    compareWith(report_["results"], ratios, results);
}

}  // namespace macula::evaluate
