#include "net/archive/first_images.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

namespace macula::net {

namespace {

constexpr std::size_t kFirstImages = 16;
// A smaller series is soon there. Of larger ones, what comes twice (web_fetch.cpp) is a tenth at most.
constexpr std::size_t kLeastImagesOfSeries = 160;

}  // namespace

std::vector<FoundInstance> firstImagesOf(const std::vector<FoundInstance>& wanted) {
    std::map<std::string, std::vector<const FoundInstance*>> bySeries;
    for (const FoundInstance& each : wanted) bySeries[each.seriesInstanceUid].push_back(&each);
    const auto largest =
        std::ranges::max_element(bySeries, {}, [](const auto& series) { return series.second.size(); });
    if (largest == bySeries.end() || largest->second.size() < kLeastImagesOfSeries) return {};
    std::vector<const FoundInstance*>& images = largest->second;
    const auto numberOf = [](const FoundInstance* image) { return image->number; };
    std::ranges::sort(images, {}, numberOf);
    // Without a number, an image sorts before all others.
    const bool areNumbered = images.front()->number.has_value() &&
                             std::ranges::adjacent_find(images, {}, numberOf) == images.end();
    if (!areNumbered) return {};
    std::vector<FoundInstance> first;
    const std::size_t from = (images.size() - kFirstImages) / 2;
    for (std::size_t i = from; i < from + kFirstImages; ++i) first.push_back(*images[i]);
    return first;
}

}  // namespace macula::net
