// Measures the difference of a picture from the limit to which a noisy reference converges. The reference is
// given twice, as the halves of a long exposure, with independent noise of one distribution. Pictures and
// errors are as in metrics.h, but not rounded to 8 bits, whose steps would count as error.
//
// The noise of the halves is independent, so the expected product of their differences from the picture is
// exactly the squared difference without noise, however few samples there were. A curve applied to the
// halves, such as the display's, biases their means: to first order twice as much as the mean of the whole,
// and this relation removes the bias.
#pragma once

#include <optional>

#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"

namespace macula::image {

// All are display-encoded and of one size.
struct NoisyReference {
    Image first;
    Image second;
    Image whole;  // the curve applied to the mean of both: not the mean of `first` and `second`
};

struct SquareError {
    // Mean square over masked pixels and channels. Noise may make it negative when the true difference is
    // small.
    double mean = 0.0;
    // The standard error of `mean` due to the reference's noise, if pixels are independent of each other.
    double standardError = 0.0;
};
// Nothing when the mask is empty.
Result<std::optional<SquareError>> squareErrorLessNoise(const NoisyReference& reference, const Image& test,
                                                        const Mask& mask);

// The PSNR in dB; nothing when the mean is not above 0.
std::optional<double> psnrOf(const SquareError& error);
// The standard error of psnrOf in dB; nothing if psnrOf is nothing.
std::optional<double> psnrErrorOf(const SquareError& error);

// The ratio of the light that `test` emits on screen to that of the reference, without the bias of the curve:
// 1 when `test` is as bright on the whole. Nothing when the reference is black. The curve biases all noise in
// one direction, so that it does not average out over a picture: in deep shadow the toe of a tone map makes a
// noisy reference too bright.
Result<std::optional<double>> luminanceRatioLessNoise(const NoisyReference& reference, const Image& test,
                                                      const Mask& mask);

// RMS noise of the whole over masked pixels and channels, from the difference of its halves; 0 when the mask
// is empty.
Result<double> noiseOf(const NoisyReference& reference, const Mask& mask);

}  // namespace macula::image
