// Finds the preset file that a user names: one that the program carries, or a file on disk.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "presets/embedded_files.h"

namespace macula::scene {

// Null when no file has that name.
const presets::EmbeddedFile* findBuiltIn(std::span<const presets::EmbeddedFile> files, std::string_view name);
std::vector<std::string> namesOf(std::span<const presets::EmbeddedFile> files);

struct ChosenText {
    std::string text;   // JSON
    std::string where;  // for errors
};

// One of `files` by name, or a JSON file by its path. Fails with usage when it is neither; the hint lists the
// names, and the message is `noSuch`.
Result<ChosenText> chooseText(std::span<const presets::EmbeddedFile> files, const Text& noSuch,
                              const std::string& nameOrFile);

// The name to show in a picture or a report: a built-in name, otherwise "custom", because the name of a
// user's file may identify a person.
std::string publicName(std::span<const presets::EmbeddedFile> files, const std::string& nameOrFile);

// All files, each parsed by parse(text, where).
template <class T, class Parse>
Result<std::vector<T>> parseAll(std::span<const presets::EmbeddedFile> files, const Parse& parse) {
    std::vector<T> all;
    for (const presets::EmbeddedFile& file : files) {
        MACULA_TRY(T parsed, parse(file.text, std::string(file.name)));
        all.push_back(std::move(parsed));
    }
    return all;
}

}  // namespace macula::scene
