// The steps and constants of Andersson et al. 2020, sections 4 and 5.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/srgb.h"
#include "image/metrics.h"
#include "image/planes.h"

namespace macula::image {

namespace {

using Triple = std::array<double, 3>;
constexpr double kPi = 3.14159265358979323846;

// sRGB (IEC 61966-2-1) to CIE XYZ and back, D65.
constexpr double kXyzFromRgb[3][3] = {
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

Triple times(const double (&m)[3][3], const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

struct Inverse {
    double m[3][3];
};
// Inverts by cofactors, so that the round trip is exact to rounding.
Inverse inverted(const double (&a)[3][3]) {
    Inverse result{};
    double determinant = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r1 = (j + 1) % 3;
            const std::size_t r2 = (j + 2) % 3;
            const std::size_t c1 = (i + 1) % 3;
            const std::size_t c2 = (i + 2) % 3;
            result.m[i][j] = a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1];
        }
        determinant += a[0][i] * result.m[i][0];
    }
    for (auto& row : result.m)
        for (double& value : row) value /= determinant;
    return result;
}

Triple white() {
    return times(kXyzFromRgb, {1, 1, 1});
}

// The linear opponent space YCxCz, which is CIELAB without the cube root: only there is filtering correct.
Triple opponentFromLinear(const Triple& rgb) {
    const Triple n = white();
    const Triple xyz = times(kXyzFromRgb, rgb);
    const double x = xyz[0] / n[0];
    const double y = xyz[1] / n[1];
    const double z = xyz[2] / n[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple linearFromOpponent(const Triple& opponent) {
    static const Inverse rgbFromXyz = inverted(kXyzFromRgb);
    const Triple n = white();
    const double y = (opponent[0] + 16) / 116;
    const double x = y + opponent[1] / 500;
    const double z = y - opponent[2] / 200;
    return times(rgbFromXyz.m, {x * n[0], y * n[1], z * n[2]});
}

// CIELAB, with chroma reduced in the dark (Hunt's effect).
Triple huntLabFromLinear(const Triple& rgb) {
    const Triple n = white();
    const Triple xyz = times(kXyzFromRgb, rgb);
    const auto f = [](double t) {
        constexpr double kDelta = 6.0 / 29.0;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const double x = f(xyz[0] / n[0]);
    const double y = f(xyz[1] / n[1]);
    const double z = f(xyz[2] / n[2]);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Triple& a, const Triple& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

constexpr double kColourExponent = 0.7;
constexpr double kFeatureExponent = 0.5;

double colourDifference(const Triple& linearA, const Triple& linearB) {
    static const double largest =
        std::pow(hyab(huntLabFromLinear({0, 1, 0}), huntLabFromLinear({0, 0, 1})), kColourExponent);
    constexpr double kKnee = 0.4;
    constexpr double kAtKnee = 0.95;
    const double e = std::pow(hyab(huntLabFromLinear(linearA), huntLabFromLinear(linearB)), kColourExponent);
    const double knee = kKnee * largest;
    return e < knee ? kAtKnee * e / knee : kAtKnee + (e - knee) / (largest - knee) * (1 - kAtKnee);
}

std::vector<double> gaussian(int radius, double twiceVariance) {
    std::vector<double> weights;
    for (int k = -radius; k <= radius; ++k) weights.push_back(std::exp(-double(k) * k / twiceVariance));
    return weights;
}

// The eye's contrast sensitivity to one channel: sums of Gaussians in frequency, hence in space (table 1 of
// the paper).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kSensitivities[] = {
    {1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};

Plane seen(const Plane& plane, const Sensitivity& s, double pixelsPerDegree) {
    const int radius = int(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixelsPerDegree));
    Plane result(plane.width, plane.height);
    double total = 0.0;
    for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
        if (a == 0.0) continue;
        const auto weights = gaussian(radius, b * pixelsPerDegree * pixelsPerDegree / (kPi * kPi));
        double sum = 0.0;
        for (const double weight : weights) sum += weight;
        const double height = a * std::sqrt(kPi / b);
        total += height * sum * sum;
        const Plane part = filter(plane, weights, weights, Edge::repeat);
        for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] += height * part.values[i];
    }
    for (double& value : result.values) value /= total;
    return result;
}

// Linear RGB as seen from the viewing distance.
std::array<Plane, 3> seenColour(const std::array<Plane, 3>& opponent, double pixelsPerDegree) {
    std::array<Plane, 3> result{seen(opponent[0], kSensitivities[0], pixelsPerDegree),
                                seen(opponent[1], kSensitivities[1], pixelsPerDegree),
                                seen(opponent[2], kSensitivities[2], pixelsPerDegree)};
    for (std::size_t i = 0; i < result[0].values.size(); ++i) {
        const Triple rgb =
            linearFromOpponent({result[0].values[i], result[1].values[i], result[2].values[i]});
        for (std::size_t c = 0; c < 3; ++c) result[c].values[i] = std::clamp(rgb[c], 0.0, 1.0);
    }
    return result;
}

// Strength of edges and of points: derivatives of a Gaussian as wide as a feature that attracts the eye.
struct Features {
    Plane edges;
    Plane points;
};
Features features(const Plane& achromatic, double pixelsPerDegree) {
    constexpr double kWidthDeg = 0.082;
    const double sigma = 0.5 * kWidthDeg * pixelsPerDegree;
    const int radius = std::max(int(std::ceil(3.0 * sigma)), 1);
    const std::vector<double> smooth = gaussian(radius, 2 * sigma * sigma);
    double across = 0.0;
    for (const double weight : smooth) across += weight;
    const auto magnitude = [&](std::vector<double> weights) {
        // Normalises the kernel: positive weights add up to 1, negative ones to -1.
        double positive = 0.0;
        double negative = 0.0;
        for (const double weight : weights) (weight > 0 ? positive : negative) += weight;
        for (double& weight : weights) weight /= across * (weight > 0 ? positive : -negative);
        const Plane x = filter(achromatic, weights, smooth, Edge::repeat);
        const Plane y = filter(achromatic, smooth, weights, Edge::repeat);
        Plane result(x.width, x.height);
        for (std::size_t i = 0; i < x.values.size(); ++i)
            result.values[i] = std::hypot(x.values[i], y.values[i]);
        return result;
    };
    std::vector<double> first;
    std::vector<double> second;
    for (int k = -radius; k <= radius; ++k) {
        const double weight = smooth[first.size()];
        first.push_back(-double(k) * weight);
        second.push_back((double(k) * k / (sigma * sigma) - 1.0) * weight);
    }
    return {magnitude(first), magnitude(second)};
}

std::array<Plane, 3> opponentPlanes(const Image& image) {
    const std::vector<Plane> rgb = colourPlanes(image);
    const Plane empty(image.width, image.height);
    std::array<Plane, 3> result{empty, empty, empty};
    for (std::size_t i = 0; i < empty.values.size(); ++i) {
        Triple linear{};
        for (std::size_t c = 0; c < 3; ++c) linear[c] = decodedSrgb(rgb[rgb.size() == 3 ? c : 0].values[i]);
        const Triple opponent = opponentFromLinear(linear);
        for (std::size_t c = 0; c < 3; ++c) result[c].values[i] = opponent[c];
    }
    return result;
}

}  // namespace

Result<Flip> flip(const Image& reference, const Image& test, const FlipOptions& options) {
    MACULA_TRY_VOID(comparable(reference, test));
    if (!(options.pixelsPerDegree > 0.0 && options.pixelsPerDegree < 1e4)) {
        return Error{ErrorCode::usage,
                     Text("The number of pixels in a degree is not usable."),
                     {},
                     Text("Give 1 to 1000.")};
    }
    std::array<Plane, 3> a = opponentPlanes(reference);
    std::array<Plane, 3> b = opponentPlanes(test);
    const auto colourA = seenColour(a, options.pixelsPerDegree);
    const auto colourB = seenColour(b, options.pixelsPerDegree);
    for (Plane* plane : {&a[0], &b[0]})
        for (double& value : plane->values) value = (value + 16) / 116;
    const Features featuresA = features(a[0], options.pixelsPerDegree);
    const Features featuresB = features(b[0], options.pixelsPerDegree);

    Flip result;
    result.perPixel.resize(a[0].values.size());
    for (std::size_t i = 0; i < result.perPixel.size(); ++i) {
        const double colour =
            colourDifference({colourA[0].values[i], colourA[1].values[i], colourA[2].values[i]},
                             {colourB[0].values[i], colourB[1].values[i], colourB[2].values[i]});
        const double feature = std::max(std::abs(featuresA.edges.values[i] - featuresB.edges.values[i]),
                                        std::abs(featuresA.points.values[i] - featuresB.points.values[i]));
        const double exponent = 1.0 - std::pow(std::min(feature / std::sqrt(2.0), 1.0), kFeatureExponent);
        const double error = std::pow(colour, exponent);
        result.perPixel[i] = static_cast<float>(error);
        result.mean += error;
    }
    result.mean /= double(result.perPixel.size());
    return result;
}

}  // namespace macula::image
