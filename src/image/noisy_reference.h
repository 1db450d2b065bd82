// Measures the difference of a picture from what a noisy reference converges to. The reference is given
// twice, as the halves of a long exposure, with independent noise of one distribution. Errors and pictures
// are as in metrics.h, but not rounded to 8 bits, whose steps would count as error.
//
// The noise of the halves is independent, so the expected product of their differences from the picture is
// exactly the squared difference without noise, however few samples there were. A curve that was applied to
// the halves, such as the display's, shifts their means: to first order twice as much as it shifts that of
// the whole, and by this its effect is removed.
#pragma once

#include <optional>

#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"

namespace macula::image {

// All display-encoded and of one size.
struct NoisyReference {
    Image first;
    Image second;
    Image whole;  // the mean of both before the curve, then the curve: not the mean of these two
};

struct SquareError {
    // Mean square over masked pixels and channels. Noise may bring it below 0 when the true difference is
    // small.
    double mean = 0.0;
    // The standard error of `mean` by the noise of the reference. Pixels must be independent of each other.
    double standardError = 0.0;
};
// Nothing when the mask is empty.
Result<std::optional<SquareError>> squareErrorLessNoise(const NoisyReference& reference, const Image& test,
                                                        const Mask& mask);

// The PSNR in dB; nothing when the mean is not above 0.
std::optional<double> psnrOf(const SquareError& error);
// The standard error of psnrOf in dB; nothing where psnrOf is nothing.
std::optional<double> psnrErrorOf(const SquareError& error);

// The ratio of the light that leaves the screen of `test` to that of the reference, without the bias by the
// curve: 1 when `test` is as bright on the whole. Nothing when the reference is black. The curve shifts all
// noise in one direction, so that it does not average out over a picture: in deep shadow the toe of a tone
// map makes a noisy reference brighter than it is.
Result<std::optional<double>> luminanceRatioLessNoise(const NoisyReference& reference, const Image& test,
                                                      const Mask& mask);

// RMS over masked pixels and channels of the noise of the whole, from the difference of its halves; 0 when
// the mask is empty.
Result<double> noiseOf(const NoisyReference& reference, const Mask& mask);

}  // namespace macula::image
