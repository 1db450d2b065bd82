#include "cli/quality_choice.h"

#include <algorithm>
#include <filesystem>

#include "base/atomic_file.h"
#include "presets/embedded_files.h"

namespace macula::cli {

Result<std::vector<trace::Quality>> builtInQualities() {
    std::vector<trace::Quality> qualities;
    for (const auto& file : presets::qualityFiles()) {
        MACULA_TRY(trace::Quality quality, trace::qualityFromJson(file.text, std::string(file.name)));
        qualities.push_back(std::move(quality));
    }
    std::sort(qualities.begin(), qualities.end(),
              [](const auto& a, const auto& b) { return a.samplesPerPixel < b.samplesPerPixel; });
    return qualities;
}

Result<trace::Quality> chooseQuality(const std::string& nameOrFile) {
    MACULA_TRY(const std::vector<trace::Quality> all, builtInQualities());
    std::string names;
    for (const trace::Quality& quality : all) {
        if (quality.name == nameOrFile) return quality;
        names += (names.empty() ? "" : ", ") + quality.name;
    }
    const std::filesystem::path path = nameOrFile;
    std::error_code error;
    if (path.extension() != ".json" && !std::filesystem::exists(path, error)) {
        return Error{ErrorCode::usage, "There is no such quality.", nameOrFile,
                     "Use one of " + names + ", or the path of a JSON file."};
    }
    MACULA_TRY(const std::string text, readText(path));
    return trace::qualityFromJson(text, path.string());
}

}  // namespace macula::cli
