// How far a picture is from what a noisy reference converges to, when the reference was made twice, with
// noise that is independent and alike: the halves of a long exposure. Errors and pictures as in metrics.h,
// but not rounded to 8 bits, whose steps would count as error.
//
// What the noise of one half does to a difference has nothing to do with what that of the other does: the
// mean of the product of both differences is the square of the difference without noise, exactly, however few
// samples there were. A curve that is put on the halves before, as the display's is, moves their means: to
// first order by as much again as it moves that of the whole, which is how it is taken out.
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
    Image whole;  // of the mean of both before the curve: not the mean of these two
};

struct SquareError {
    // Mean square over masked pixels and channels. It is below 0 when the picture is so near that chance
    // decides.
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

// Light that leaves the screen of `test`, in parts of that of the reference: 1 when nothing is too dark or
// too bright on the whole. Nothing when the reference is black. The curve moves sums of light in one
// direction, so that the noise of a whole picture does not average out of them: in deep shadow the toe of a
// tone map makes a noisy reference brighter than it is.
Result<std::optional<double>> luminanceRatioLessNoise(const NoisyReference& reference, const Image& test,
                                                      const Mask& mask);

// RMS over masked pixels and channels of the noise of the whole, from the difference of its halves; 0 when
// the mask is empty.
Result<double> noiseOf(const NoisyReference& reference, const Mask& mask);

}  // namespace macula::image
