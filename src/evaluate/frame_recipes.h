// Ways to make hybrid frames and their models, which trade quality for time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// How a picture for the fovea is traced.
struct TracedFovea {
    double fieldDeg = trace::kFovealFieldDeg;
    std::uint32_t samplesPerPixel = 1;
    int bounces = trace::kDefaultBounces;
    bool isDenoised = true;
};

struct FrameRecipe {
    TracedFovea fovea;
    int framesPerFovea = 1;  // traced once in so many frames
    bool isWarped = true;    // reprojected to the present eye; else left in place on the screen
};

// All combinations are measured, each with and without denoising, warped and not.
struct FrameLevels {
    std::vector<double> fieldsDeg{10.0, 20.0, 40.0};
    std::vector<std::uint32_t> samplesPerPixel{1, 4, 16};
    std::vector<int> bounces{4, 8, 16};
    std::vector<int> framesPerFovea{1, 4, 16};
};

// All pictures for the fovea, and all frames made with one of them.
std::vector<TracedFovea> foveaeOf(const FrameLevels& levels);
std::vector<FrameRecipe> recipesOf(const TracedFovea& fovea, const FrameLevels& levels);

// The ages of the fovea, in frames, that represent all of `framesPerFovea`, ascending: the first and the
// last; from kMiddleFrom on also the middle one, because error does not grow evenly.
inline constexpr int kMiddleFrom = 8;
std::vector<int> agesOf(int framesPerFovea);
// The ages that all levels together need, ascending, each once.
std::vector<int> agesOf(const FrameLevels& levels);

inline constexpr std::string_view kNothingVaried = "nothing";
struct ModelRecipe {
    std::string_view varied;  // "views", "iterations", "splats"; kNothingVaried for the usual model
    hybrid::FirstModelOptions options;
};

// Each recipe differs from the usual model in one of these values.
struct ModelLevels {
    std::vector<std::size_t> views{6, 12, 24};
    std::vector<double> iterations{1.0 / 3.0, 3.0};  // factor of the usual number
    std::vector<double> splats{0.5, 2.0};            // factor of the usual points and of the capacity
};

// The usual model comes first.
std::vector<ModelRecipe> modelRecipesOf(const hybrid::FirstModelOptions& usual, const ModelLevels& levels);

}  // namespace macula::evaluate
