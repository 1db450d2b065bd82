#include "cli/clip_choice.h"

#include <algorithm>
#include <filesystem>

#include "base/atomic_file.h"
#include "presets/embedded_files.h"

namespace macula::cli {

Result<std::vector<ClipPreset>> builtInClips() {
    std::vector<ClipPreset> clips;
    for (const auto& file : presets::clipFiles()) {
        MACULA_TRY(ClipPreset clip, clipPresetFromJson(file.text, std::string(file.name)));
        clips.push_back(std::move(clip));
    }
    return clips;
}

Result<ClipPreset> chooseClip(const std::string& nameOrFile) {
    std::string names;
    for (const auto& file : presets::clipFiles()) {
        if (file.name == nameOrFile) return clipPresetFromJson(file.text, std::string(file.name));
        names += (names.empty() ? "" : ", ") + std::string(file.name);
    }
    const std::filesystem::path path = nameOrFile;
    std::error_code error;
    if (path.extension() != ".json" && !std::filesystem::exists(path, error)) {
        return Error{ErrorCode::usage, "There is no such clip.", nameOrFile,
                     "Use one of " + names + ", or the path of a JSON file."};
    }
    MACULA_TRY(const std::string text, readText(path));
    return clipPresetFromJson(text, path.string());
}

std::string publicClipName(const std::string& nameOrFile) {
    const auto files = presets::clipFiles();
    const bool builtIn =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.name == nameOrFile; });
    if (nameOrFile.empty()) return "none";
    return builtIn ? nameOrFile : "custom";
}

}  // namespace macula::cli
