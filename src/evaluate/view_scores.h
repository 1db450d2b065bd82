// Scores of a model's picture against the ground truth, and their spread over views and scenes.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/noisy_reference.h"
#include "pipeline/hybrid/views/truth_pictures.h"

namespace macula::evaluate {

// Of displayed pictures, over black, in 8 bits. "Masked" covers pixels where either picture shows light.
// "Covered" covers pixels where the truth has coverage, whatever its colour. "LessNoise" estimates the error
// to the converged truth, not in 8 bits (image/noisy_reference.h). Nothing without such pixels or, as in the
// protocol, if a PSNR is not finite or above 75 dB.
struct ViewScores {
    std::optional<double> psnrDb;
    std::optional<double> maskedPsnrDb;
    std::optional<double> maskedPsnrLessNoiseDb;    // also nothing if the mean square is not above 0
    std::optional<double> maskedMseLessNoise;       // may be below 0 if noise hides a small error
    std::optional<double> maskedMseLessNoiseError;  // its standard error, from noise of the truth
    std::optional<double> coveredPsnrDb;
    std::optional<double> maskedSsim;
    std::optional<double> coveredSsim;
    std::optional<double> flip;
    std::optional<double> luminanceRatio;        // model over truth, masked, less noise
    std::optional<double> sharedLuminanceRatio;  // the same, where both cover more than half
    std::optional<double> coverageError;         // mean absolute, where either has coverage
    std::optional<double> truthNoise;            // standard error of the truth's pixels, covered
};

struct Score {
    std::string_view key;  // key in JSON
    std::optional<double> ViewScores::*value;
};
inline constexpr std::array<Score, 13> kScores{
    {{"psnrDb", &ViewScores::psnrDb},
     {"maskedPsnrDb", &ViewScores::maskedPsnrDb},
     {"maskedPsnrLessNoiseDb", &ViewScores::maskedPsnrLessNoiseDb},
     {"maskedMseLessNoise", &ViewScores::maskedMseLessNoise},
     {"maskedMseLessNoiseError", &ViewScores::maskedMseLessNoiseError},
     {"coveredPsnrDb", &ViewScores::coveredPsnrDb},
     {"maskedSsim", &ViewScores::maskedSsim},
     {"coveredSsim", &ViewScores::coveredSsim},
     {"flip", &ViewScores::flip},
     {"luminanceRatio", &ViewScores::luminanceRatio},
     {"sharedLuminanceRatio", &ViewScores::sharedLuminanceRatio},
     {"coverageError", &ViewScores::coverageError},
     {"truthNoise", &ViewScores::truthNoise}}};

// `model` is linear premultiplied RGBA, as large as the truth.
Result<ViewScores> scoresOf(const hybrid::TruthPicture& truth, std::span<const glm::vec4> model);

// The mean of maskedMseLessNoise over views. Unlike a mean of PSNRs it has no bias, however noisy views are.
std::optional<image::SquareError> squareErrorOver(std::span<const ViewScores> views);

struct Spread {
    std::size_t count = 0;  // number of known values
    double mean = 0.0;
    double p10 = 0.0;
    double p50 = 0.0;
    double p90 = 0.0;
};
// Nothing if no value is known. Percentiles as in NumPy.
std::optional<Spread> spreadOf(std::span<const std::optional<double>> values);
// The spread of one score over views.
std::optional<Spread> spreadOf(std::span<const ViewScores> views, std::optional<double> ViewScores::*value);

}  // namespace macula::evaluate
