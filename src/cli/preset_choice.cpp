#include "cli/preset_choice.h"

#include <algorithm>
#include <filesystem>

#include "base/atomic_file.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"

namespace macula::cli {

Result<std::vector<TransferFunction>> builtInPresets() {
    std::vector<TransferFunction> presets;
    for (const auto& file : presets::transferFiles()) {
        MACULA_TRY(TransferFunction preset, transferFunctionFromJson(file.text, std::string(file.name)));
        presets.push_back(std::move(preset));
    }
    return presets;
}

Result<TransferFunction> choosePreset(const std::string& nameOrFile) {
    std::string names;
    for (const auto& file : presets::transferFiles()) {
        if (file.name == nameOrFile) return transferFunctionFromJson(file.text, std::string(file.name));
        names += (names.empty() ? "" : ", ") + std::string(file.name);
    }
    const std::filesystem::path path = nameOrFile;
    std::error_code error;
    if (!path.has_extension() && !std::filesystem::exists(path, error)) {
        return Error{ErrorCode::usage, "There is no such preset.", nameOrFile,
                     "Use one of " + names + ", or the path of a JSON file."};
    }
    MACULA_TRY(const std::string text, readText(path));
    return transferFunctionFromJson(text, path.string(), "custom");
}

std::string publicPresetName(const std::string& nameOrFile) {
    const auto files = presets::transferFiles();
    const bool builtIn =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.name == nameOrFile; });
    return builtIn ? nameOrFile : "custom";
}

}  // namespace macula::cli
