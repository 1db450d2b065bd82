// What can be traded for time in hybrid frames and in the models under them, as lists of ways to make them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// A picture for the fovea.
struct TracedFovea {
    double fieldDeg = trace::kFovealFieldDeg;
    std::uint32_t samplesPerPixel = 1;
    int bounces = trace::kDefaultBounces;
    bool isDenoised = true;
};

struct FrameRecipe {
    TracedFovea fovea;
    int framesPerFovea = 1;  // it is traced once in so many frames
    bool isWarped = true;    // reprojected to where the eye is now; else left where it was on the screen
};

// Each with each other, with and without denoising, warped and not.
struct FrameLevels {
    std::vector<double> fieldsDeg{10.0, 20.0, 40.0};
    std::vector<std::uint32_t> samplesPerPixel{1, 4, 16};
    std::vector<int> bounces{4, 8, 16};
    std::vector<int> framesPerFovea{1, 4, 16};
};

// All pictures that there are to trace, and all frames that are made with one of them.
std::vector<TracedFovea> foveaeOf(const FrameLevels& levels);
std::vector<FrameRecipe> recipesOf(const TracedFovea& fovea, const FrameLevels& levels);

// How many frames ago the fovea was traced, in the frames that stand for all of `framesPerFovea`, ascending:
// the first and the last, and from kMiddleFrom on the one between them, because error does not grow evenly.
inline constexpr int kMiddleFrom = 8;
std::vector<int> agesOf(int framesPerFovea);
// The ages that any of the levels needs, ascending, each once.
std::vector<int> agesOf(const FrameLevels& levels);

inline constexpr std::string_view kNothingVaried = "nothing";
struct ModelRecipe {
    std::string_view varied;  // "views", "iterations", "splats"; kNothingVaried of the usual model
    hybrid::FirstModelOptions options;
};

// One of them differs from the usual model, whose values are left out here.
struct ModelLevels {
    std::vector<std::size_t> views{6, 12, 24};
    std::vector<double> iterations{1.0 / 3.0, 3.0};  // times the usual ones
    std::vector<double> splats{0.5, 2.0};            // times the usual points, and room for splats
};

// The usual one first.
std::vector<ModelRecipe> modelRecipesOf(const hybrid::FirstModelOptions& usual, const ModelLevels& levels);

}  // namespace macula::evaluate
