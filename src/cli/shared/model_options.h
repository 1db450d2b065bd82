// What a first model is made of, as options of the verbs that make one: the same names, ranges and words in
// each.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "pipeline/hybrid/model/first_model.h"

namespace macula::cli {

struct ModelOptionsAdded {
    std::vector<CLI::Option*> ofTheStart;  // all that is settled before the first step
    CLI::Option* iterations = nullptr;
};

// Their defaults are what `options` holds; it must outlive the parsing.
ModelOptionsAdded addModelOptions(CLI::App& command, hybrid::FirstModelOptions& options);

// What ranges of single options do not say. usage.
Result<void> checkModelOptions(const hybrid::FirstModelOptions& options);

// For any number of views or samples, and any number of splats.
inline constexpr int kMostViews = 4096;
inline constexpr int kMostSamplesOfView = 1 << 16;
inline constexpr int kMostIterations = 1 << 24;

}  // namespace macula::cli
