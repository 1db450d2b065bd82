#include "image/metrics.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "image/planes.h"
#include "image/ssim.h"

namespace macula::image {

Result<double> psnr(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    double squares = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t i = 0; i < a[c].values.size(); ++i) {
            const double difference = a[c].values[i] - b[c].values[i];
            squares += difference * difference;
        }
    }
    if (squares == 0.0) return std::numeric_limits<double>::infinity();
    return -10.0 * std::log10(squares / double(a.size() * a.front().values.size()));
}

Result<double> ssim(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    const std::vector<Plane> maps = ssimMaps(reference, test, Edge::cut);
    double sum = 0.0;
    for (const Plane& map : maps) sum += std::accumulate(map.values.begin(), map.values.end(), 0.0);
    return sum / double(maps.size() * maps.front().values.size());
}

}  // namespace macula::image
