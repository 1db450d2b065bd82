#include "scene/choice/built_in_choice.h"

#include <algorithm>
#include <filesystem>

#include "base/atomic_file.h"
#include "scene/choice/nearest_name.h"

namespace macula::scene {

const presets::EmbeddedFile* findBuiltIn(std::span<const presets::EmbeddedFile> files,
                                         std::string_view name) {
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; });
    return found == files.end() ? nullptr : &*found;
}

std::vector<std::string> namesOf(std::span<const presets::EmbeddedFile> files) {
    std::vector<std::string> names;
    for (const presets::EmbeddedFile& file : files) names.emplace_back(file.name);
    return names;
}

Result<ChosenText> chooseText(std::span<const presets::EmbeddedFile> files, const Text& noSuch,
                              const std::string& nameOrFile) {
    if (const presets::EmbeddedFile* file = findBuiltIn(files, nameOrFile))
        return ChosenText{std::string(file->text), std::string(file->name)};
    const std::filesystem::path path = nameOrFile;
    std::error_code error;
    if (path.extension() != ".json" && !std::filesystem::exists(path, error))
        return noSuchName(noSuch, nameOrFile, namesOf(files), Text("Or give the path of a JSON file."));
    MACULA_TRY(std::string text, readText(path));
    return ChosenText{std::move(text), path.string()};
}

std::string publicName(std::span<const presets::EmbeddedFile> files, const std::string& nameOrFile) {
    return findBuiltIn(files, nameOrFile) != nullptr ? nameOrFile : "custom";
}

}  // namespace macula::scene
