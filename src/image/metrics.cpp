#include "image/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "image/masked_metrics.h"
#include "image/planes.h"
#include "image/ssim.h"

namespace macula::image {

Result<double> psnr(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    const Mask whole(std::size_t(reference.width) * std::size_t(reference.height), 1);
    MACULA_TRY(const std::optional<double> db, maskedPsnr(reference, test, whole));
    return *db;
}

Result<double> ssim(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    const std::vector<Plane> maps = ssimMaps(reference, test, Edge::cut);
    double sum = 0.0;
    for (const Plane& map : maps) sum += std::accumulate(map.values.begin(), map.values.end(), 0.0);
    return sum / double(maps.size() * maps.front().values.size());
}

namespace {

// Wang et al. 2003, section 3.2; finest scale first.
constexpr std::array kWeights{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

// Averages 2 x 2 pixels; as in the authors' program an odd last row or column is averaged with itself.
Plane halved(const Plane& plane) {
    Plane half((plane.width + 1) / 2, (plane.height + 1) / 2);
    for (int y = 0; y < half.height; ++y) {
        const int below = std::min(2 * y + 1, plane.height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int beside = std::min(2 * x + 1, plane.width - 1);
            half.at(x, y) = 0.25 * (plane.at(2 * x, 2 * y) + plane.at(beside, 2 * y) +
                                    plane.at(2 * x, below) + plane.at(beside, below));
        }
    }
    return half;
}

// The mean over windows that lie wholly inside.
double meanInside(const Plane& map) {
    double sum = 0.0;
    for (int y = kSsimRadius; y < map.height - kSsimRadius; ++y)
        for (int x = kSsimRadius; x < map.width - kSsimRadius; ++x) sum += map.at(x, y);
    return sum / (double(map.width - 2 * kSsimRadius) * double(map.height - 2 * kSsimRadius));
}

double multiscale(Plane a, Plane b) {
    double result = 1.0;
    for (std::size_t scale = 0; scale < kWeights.size(); ++scale) {
        const SsimTerms terms = ssimTerms(a, b, Edge::cut);
        const bool isLast = scale + 1 == kWeights.size();
        const double mean = meanInside(isLast ? terms.whole : terms.contrastStructure);
        result *= std::pow(std::max(mean, 0.0), kWeights[scale]);
        if (isLast) break;
        a = halved(a);
        b = halved(b);
    }
    return result;
}

}  // namespace

Result<double> msSsim(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    if (std::min(reference.width, reference.height) < kMsSsimLeastPx) {
        return Error{
            ErrorCode::usage,
            Text("Pictures of {} x {} pixels are too small for MS-SSIM.", reference.width, reference.height),
            {},
            Text("Compare pictures of at least {} pixels on each side.", kMsSsimLeastPx)};
    }
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    double sum = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += multiscale(a[c], b[c]);
    return sum / double(a.size());
}

}  // namespace macula::image
