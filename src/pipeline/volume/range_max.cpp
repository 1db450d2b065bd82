#include "pipeline/volume/range_max.h"

#include <algorithm>
#include <bit>

#include "base/check.h"

namespace macula {

RangeMax::RangeMax(std::span<const float> values) {
    MACULA_CHECK(!values.empty());
    levels_.emplace_back(values.begin(), values.end());
    for (std::size_t half = 1; 2 * half <= values.size(); half *= 2) {
        const std::vector<float>& below = levels_.back();
        std::vector<float> level(values.size() - 2 * half + 1);
        for (std::size_t i = 0; i < level.size(); ++i) level[i] = std::max(below[i], below[i + half]);
        levels_.push_back(std::move(level));
    }
}

float RangeMax::operator()(std::size_t first, std::size_t last) const {
    MACULA_CHECK_LE(first, last);
    MACULA_CHECK_LT(last, levels_.front().size());
    const std::size_t count = last - first + 1;
    const std::size_t level = std::bit_width(count) - 1;
    return std::max(levels_[level][first], levels_[level][last + 1 - (std::size_t{1} << level)]);
}

}  // namespace macula
