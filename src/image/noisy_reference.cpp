#include "image/noisy_reference.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "image/planes.h"

namespace macula::image {

namespace {

constexpr double kDbPerNeper = 10.0 / 2.302585092994046;  // for squares: 10 / ln 10

Result<void> fits(const NoisyReference& reference, const Mask& mask) {
    MACULA_TRY_VOID(comparable(reference.whole, reference.first));
    MACULA_TRY_VOID(comparable(reference.whole, reference.second));
    MACULA_CHECK_EQ(mask.size(), std::size_t(reference.whole.width) * std::size_t(reference.whole.height));
    return {};
}

Result<void> fits(const NoisyReference& reference, const Image& test, const Mask& mask) {
    MACULA_TRY_VOID(comparable(reference.whole, test));
    return fits(reference, mask);
}

// The planes of a reference, and for each value the mean and difference of its halves.
class Halves {
  public:
    explicit Halves(const NoisyReference& reference)
        : first_(colourPlanes(reference.first)),
          second_(colourPlanes(reference.second)),
          whole_(colourPlanes(reference.whole)) {}

    std::size_t channels() const { return whole_.size(); }
    double mean(std::size_t c, std::size_t i) const {
        return 0.5 * (first_[c].values[i] + second_[c].values[i]);
    }
    // Half the difference of the halves, which has the same variance as the noise of their mean.
    double halfDifference(std::size_t c, std::size_t i) const {
        return 0.5 * (first_[c].values[i] - second_[c].values[i]);
    }
    // Removes the curve's bias to first order: the whole has half the variance of its halves, so half their
    // bias.
    double withoutCurve(std::size_t c, std::size_t i) const { return 2.0 * whole_[c].values[i] - mean(c, i); }

  private:
    std::vector<Plane> first_;
    std::vector<Plane> second_;
    std::vector<Plane> whole_;
};

}  // namespace

Result<std::optional<SquareError>> squareErrorLessNoise(const NoisyReference& reference, const Image& test,
                                                        const Mask& mask) {
    MACULA_TRY_VOID(fits(reference, test, mask));
    const Halves halves(reference);
    const std::vector<Plane> tested = colourPlanes(test);
    double squares = 0.0;
    double variance = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        double byNoise = 0.0;
        for (std::size_t c = 0; c < halves.channels(); ++c) {
            const double value = tested[c].values[i];
            const double noise = halves.halfDifference(c, i);
            const double error = value - halves.withoutCurve(c, i);
            // If `error` is taken from the mean of the halves, this is the product of both differences.
            squares += error * error - noise * noise;
            // The mean of its square is the variance of that product, of Gaussian noise exactly, also where
            // the noise of the channels of a pixel is the same.
            byNoise += 2.0 * (value - halves.mean(c, i)) * noise;
        }
        variance += byNoise * byNoise;
        ++count;
    }
    if (count == 0) return std::optional<SquareError>();
    const double values = double(halves.channels() * count);
    return std::optional(
        SquareError{.mean = squares / values, .standardError = std::sqrt(variance) / values});
}

std::optional<double> psnrOf(const SquareError& error) {
    if (!(error.mean > 0.0)) return {};
    return -kDbPerNeper * std::log(error.mean);
}

std::optional<double> psnrErrorOf(const SquareError& error) {
    if (!(error.mean > 0.0)) return {};
    return kDbPerNeper * error.standardError / error.mean;
}

Result<std::optional<double>> luminanceRatioLessNoise(const NoisyReference& reference, const Image& test,
                                                      const Mask& mask) {
    MACULA_TRY_VOID(fits(reference, test, mask));
    const double light = 2.0 * lightOf(reference.whole, mask) -
                         0.5 * (lightOf(reference.first, mask) + lightOf(reference.second, mask));
    if (!(light > 0.0)) return std::optional<double>();
    return std::optional(lightOf(test, mask) / light);
}

Result<double> noiseOf(const NoisyReference& reference, const Mask& mask) {
    MACULA_TRY_VOID(fits(reference, mask));
    const Halves halves(reference);
    double squares = 0.0;
    std::size_t values = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        for (std::size_t c = 0; c < halves.channels(); ++c, ++values)
            squares += halves.halfDifference(c, i) * halves.halfDifference(c, i);
    }
    return std::sqrt(squares / double(std::max<std::size_t>(values, 1)));
}

}  // namespace macula::image
