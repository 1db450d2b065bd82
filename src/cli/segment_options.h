// The options of macula segment.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/segments/recipe_file.h"

namespace macula::cli {

struct SegmentOptions {
    std::filesystem::path path;
    std::string series;
    scene::RecipeFile file;  // without its threshold and point, which follow
    std::vector<double> threshold;
    std::vector<double> growFromMm;
    bool overwrite = false;
    bool json = false;

    scene::RecipeFile whole() const;
};

// `options` outlives the command.
void addSegmentOptions(CLI::App& command, SegmentOptions& options);

}  // namespace macula::cli
