// The files of presets/transfer, lights, clip, quality and front, carried inside the program: it needs
// no data files to run.
#pragma once

#include <span>
#include <string_view>

namespace macula::presets {

struct EmbeddedFile {
    std::string_view name;  // without folder and extension: "cinematic-bone"
    std::string_view text;  // JSON
};

// Sorted by name.
std::span<const EmbeddedFile> transferFiles();
std::span<const EmbeddedFile> lightFiles();
std::span<const EmbeddedFile> clipFiles();
std::span<const EmbeddedFile> qualityFiles();
std::span<const EmbeddedFile> frontFiles();

}  // namespace macula::presets
