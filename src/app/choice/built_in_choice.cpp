#include "app/choice/built_in_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/choice/nearest_name.h"
#include "base/atomic_file.h"

namespace macula::app {

Result<ChosenText> chooseText(std::span<const presets::EmbeddedFile> files, std::string_view kind,
                              const std::string& nameOrFile) {
    std::vector<std::string> names;
    for (const presets::EmbeddedFile& file : files) {
        if (file.name == nameOrFile) return ChosenText{std::string(file.text), std::string(file.name)};
        names.emplace_back(file.name);
    }
    const std::filesystem::path path = nameOrFile;
    std::error_code error;
    if (path.extension() != ".json" && !std::filesystem::exists(path, error)) {
        return Error{ErrorCode::usage, fmt::format("There is no such {}.", kind), nameOrFile,
                     choiceAmong(nameOrFile, names) + " Or give the path of a JSON file."};
    }
    MACULA_TRY(std::string text, readText(path));
    return ChosenText{std::move(text), path.string()};
}

std::string publicName(std::span<const presets::EmbeddedFile> files, const std::string& nameOrFile) {
    const bool builtIn =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.name == nameOrFile; });
    return builtIn ? nameOrFile : "custom";
}

}  // namespace macula::app
