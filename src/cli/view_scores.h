// How near a model's picture comes to the truth, in numbers; and how these are spread over views and scenes.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "pipeline/hybrid/traced_view.h"

namespace macula::cli {

// Of pictures as they are displayed, over black, in 8 bits. Masked: over pixels where either shows any light.
// Covered: over those where the truth has coverage, whatever its colour. Nothing where there is no such pixel
// or, as in the protocol, where a PSNR is not finite or above 75 dB.
struct ViewScores {
    std::optional<double> psnrDb;
    std::optional<double> maskedPsnrDb;
    std::optional<double> maskedPsnrLessNoiseDb;  // image::psnrLessNoise
    std::optional<double> coveredPsnrDb;
    std::optional<double> maskedSsim;
    std::optional<double> coveredSsim;
    std::optional<double> flip;
    std::optional<double> luminanceRatio;  // model over truth, masked
    std::optional<double> coverageError;   // mean absolute, over pixels where either has coverage
};

struct Score {
    std::string_view key;  // in JSON
    std::optional<double> ViewScores::*value;
};
inline constexpr std::array<Score, 9> kScores{{{"psnrDb", &ViewScores::psnrDb},
                                               {"maskedPsnrDb", &ViewScores::maskedPsnrDb},
                                               {"maskedPsnrLessNoiseDb", &ViewScores::maskedPsnrLessNoiseDb},
                                               {"coveredPsnrDb", &ViewScores::coveredPsnrDb},
                                               {"maskedSsim", &ViewScores::maskedSsim},
                                               {"coveredSsim", &ViewScores::coveredSsim},
                                               {"flip", &ViewScores::flip},
                                               {"luminanceRatio", &ViewScores::luminanceRatio},
                                               {"coverageError", &ViewScores::coverageError}}};

// `model`: linear premultiplied RGBA, as large as the truth, of which `noise` is the standard error
// (TruthPicture).
Result<ViewScores> scoresOf(const hybrid::TracedView& truth, double noise, std::span<const glm::vec4> model);

// Linear premultiplied RGBA as it is displayed: three channels of 8 bits.
image::Image displayImage(const glm::ivec2& sizePx, std::span<const glm::vec4> rgba);

struct Spread {
    std::size_t count = 0;  // of what has a number
    double mean = 0.0;
    double p10 = 0.0;
    double p50 = 0.0;
    double p90 = 0.0;
};
// Nothing when none has a number. Percentiles as NumPy's.
std::optional<Spread> spreadOf(std::span<const std::optional<double>> values);
// Of one number over views.
std::optional<Spread> spreadOf(std::span<const ViewScores> views, std::optional<double> ViewScores::*value);

}  // namespace macula::cli
