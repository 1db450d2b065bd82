// How near a model's picture comes to the truth, in numbers; and how these are spread over views and scenes.
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

// Of pictures as they are displayed, over black, in 8 bits. Masked: over pixels where either shows any light.
// Covered: over those where the truth has coverage, whatever its colour. Less noise: against what the truth
// converges to, and not in 8 bits (image/noisy_reference.h). Nothing where there is no such pixel or, as in
// the protocol, where a PSNR is not finite or above 75 dB.
struct ViewScores {
    std::optional<double> psnrDb;
    std::optional<double> maskedPsnrDb;
    std::optional<double> maskedPsnrLessNoiseDb;  // also absent where the mean square is not above 0
    std::optional<double> maskedMseLessNoise;  // below 0 where the error is less than the noise leaves to see
    std::optional<double> maskedMseLessNoiseError;  // standard error of that, by noise of the truth
    std::optional<double> coveredPsnrDb;
    std::optional<double> maskedSsim;
    std::optional<double> coveredSsim;
    std::optional<double> flip;
    std::optional<double> luminanceRatio;        // model over truth, masked, less noise
    std::optional<double> sharedLuminanceRatio;  // the same where both cover more than half
    std::optional<double> coverageError;         // mean absolute, over pixels where either has coverage
    std::optional<double> truthNoise;            // standard error of the truth, covered
};

struct Score {
    std::string_view key;  // in JSON
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

// `model`: linear premultiplied RGBA, as large as the truth.
Result<ViewScores> scoresOf(const hybrid::TruthPicture& truth, std::span<const glm::vec4> model);

// maskedMseLessNoise over views: its mean is right however noisy each of them is, a mean of their PSNRs is
// not.
std::optional<image::SquareError> squareErrorOver(std::span<const ViewScores> views);

struct Spread {
    std::size_t count = 0;  // values that there are
    double mean = 0.0;
    double p10 = 0.0;
    double p50 = 0.0;
    double p90 = 0.0;
};
// Nothing when none has a number. Percentiles as NumPy's.
std::optional<Spread> spreadOf(std::span<const std::optional<double>> values);
// Of one number over views.
std::optional<Spread> spreadOf(std::span<const ViewScores> views, std::optional<double> ViewScores::*value);

}  // namespace macula::evaluate
