#include "evaluate/frame_recipes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace macula::evaluate {

namespace {

// The product, rounded, but at least 1.
template <class Count>
Count times(Count count, double factor) {
    return std::max(static_cast<Count>(std::llround(double(count) * factor)), Count{1});
}

}  // namespace

std::vector<TracedFovea> foveaeOf(const FrameLevels& levels) {
    std::vector<TracedFovea> foveae;
    for (const double fieldDeg : levels.fieldsDeg) {
        for (const std::uint32_t samples : levels.samplesPerPixel) {
            for (const int bounces : levels.bounces) {
                for (const bool isDenoised : {false, true}) {
                    foveae.push_back({.fieldDeg = fieldDeg,
                                      .samplesPerPixel = samples,
                                      .bounces = bounces,
                                      .isDenoised = isDenoised});
                }
            }
        }
    }
    return foveae;
}

std::vector<FrameRecipe> recipesOf(const TracedFovea& fovea, const FrameLevels& levels) {
    std::vector<FrameRecipe> recipes;
    for (const int frames : levels.framesPerFovea) {
        for (const bool isWarped : {false, true})
            recipes.push_back({.fovea = fovea, .framesPerFovea = frames, .isWarped = isWarped});
    }
    return recipes;
}

std::vector<int> agesOf(int framesPerFovea) {
    std::set<int> ages{0, framesPerFovea - 1};
    if (framesPerFovea >= kMiddleFrom) ages.insert(framesPerFovea / 2);
    return {ages.begin(), ages.end()};
}

std::vector<int> agesOf(const FrameLevels& levels) {
    std::set<int> all;
    for (const int frames : levels.framesPerFovea) {
        const std::vector<int> ages = agesOf(frames);
        all.insert(ages.begin(), ages.end());
    }
    return {all.begin(), all.end()};
}

std::vector<ModelRecipe> modelRecipesOf(const hybrid::FirstModelOptions& usual, const ModelLevels& levels) {
    std::vector<ModelRecipe> recipes{{.varied = kNothingVaried, .options = usual}};
    for (const std::size_t views : levels.views) {
        if (views == usual.views) continue;
        recipes.push_back({.varied = "views", .options = usual});
        recipes.back().options.views = views;
    }
    for (const double factor : levels.iterations) {
        recipes.push_back({.varied = "iterations", .options = usual});
        recipes.back().options.iterations = times(usual.iterations, factor);
    }
    for (const double factor : levels.splats) {
        recipes.push_back({.varied = "splats", .options = usual});
        hybrid::FirstModelOptions& options = recipes.back().options;
        options.points.count = times(usual.points.count, factor);
        options.capacity = times(usual.capacity, factor);
    }
    return recipes;
}

}  // namespace macula::evaluate
