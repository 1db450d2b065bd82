#include "pipeline/splat/model/density_control.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"

namespace macula::splat {

namespace {

// The distance of each half from the middle, in standard deviations along the longest axis, and the factor by
// which each is shorter: together they cover what the whole splat covered, with a little less in the middle.
constexpr float kApart = 0.6f;
constexpr float kShorter = 0.6f;

// An axis of a splat, in the axes of the model.
glm::vec3 axisOf(const glm::vec4& rotation, int axis) {
    const glm::vec4 q = rotation / glm::length(rotation);
    const float w = q[0], x = q[1], y = q[2], z = q[3];
    if (axis == 0) return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    if (axis == 1) return {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

// Marks the splats with the least weight, up to `share` of the total. Splats that were not drawn stay,
// because nothing is known about them.
std::vector<std::uint8_t> unneeded(std::span<const shared::SplatStatistics> statistics, double share) {
    std::vector<std::uint32_t> order(statistics.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return statistics[a].weight < statistics[b].weight;
    });
    double total = 0.0;
    for (const auto& s : statistics) total += double(s.weight);
    std::vector<std::uint8_t> result(statistics.size(), 0);
    if (!(total > 0.0)) return result;  // nothing has been drawn yet
    double sum = 0.0;
    for (const std::uint32_t i : order) {
        sum += double(statistics[i].weight);
        if (sum > share * total) break;
        result[i] = statistics[i].views > 0.0f ? 1 : 0;
    }
    return result;
}

double pullOf(const shared::SplatStatistics& s) {
    return s.views > 0.0f ? double(s.pull) / double(s.views) : 0.0;
}

}  // namespace

Regrouped regroup(const Splats& splats, std::span<const shared::SplatStatistics> statistics,
                  const DensityOptions& options, std::uint32_t capacity) {
    MACULA_CHECK_EQ(statistics.size(), splats.size());
    const std::vector<std::uint8_t> drop = unneeded(statistics, options.unseenShare);
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < splats.size(); ++i)
        if (drop[i] == 0) kept.push_back(i);

    std::vector<std::uint32_t> byPull = kept;
    std::stable_sort(byPull.begin(), byPull.end(), [&](std::uint32_t a, std::uint32_t b) {
        return pullOf(statistics[a]) > pullOf(statistics[b]);
    });
    const std::size_t room = capacity > kept.size() ? capacity - kept.size() : 0;
    byPull.resize(
        std::min({byPull.size(), room, static_cast<std::size_t>(options.splitShare * double(kept.size()))}));
    std::vector<std::uint8_t> split(splats.size(), 0);
    for (const std::uint32_t i : byPull) split[i] = pullOf(statistics[i]) > 0.0 ? 1 : 0;

    Regrouped result;
    result.splats = splats;
    result.splats.resize(0);
    for (const std::uint32_t i : kept) {
        for (int half = 0; half <= split[i]; ++half) {
            result.splats.append(splats, i);
            result.source.push_back(i);
            result.isNew.push_back(split[i]);
            if (split[i] == 0) continue;
            const glm::vec3& scale = splats.logScale[i];
            const int longest = scale.x >= scale.y && scale.x >= scale.z ? 0 : scale.y >= scale.z ? 1 : 2;
            const float side = half == 0 ? kApart : -kApart;
            result.splats.position.back() +=
                axisOf(splats.rotation[i], longest) * (side * std::exp(scale[longest]));
            result.splats.logScale.back()[longest] += std::log(kShorter);
        }
    }
    return result;
}

}  // namespace macula::splat
