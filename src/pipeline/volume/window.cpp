#include "pipeline/volume/window.h"

#include <algorithm>
#include <vector>

#include "pipeline/volume/entry_map.h"
#include "pipeline/volume/volume_fit.h"

namespace macula {

namespace {

constexpr double kUsualHighSuv = 10.0;

// At most 200 000 evenly spaced values of the volume, without padding.
std::vector<double> someValues(const Volume& volume) {
    constexpr std::size_t kMost = 200'000;
    const glm::ivec3 size = volume.size();
    const std::size_t all = volume.voxelCount();
    const std::size_t stride = all / kMost + 1;
    std::vector<double> values;
    const auto width = std::size_t(size.x);
    const auto height = std::size_t(size.y);
    for (std::size_t at = 0; at < all; at += stride) {
        const auto i = int(at % width);
        const auto j = int(at / width % height);
        const auto k = int(at / width / height);
        if (!volume.isPadding(i, j, k)) values.push_back(volume.value(i, j, k));
    }
    return values;
}

}  // namespace

bool isActivity(const Volume& volume) {
    return volume.unit() == Unit::becquerelsPerMillilitre || volume.unit() == Unit::suvBodyWeight ||
           volume.modality() == "PT";
}

std::optional<DisplayWindow> activityWindow(const Volume& volume) {
    if (!volume.valueRange() || !(volume.valueRange()->high > 0.0)) return std::nullopt;
    const double highest = volume.valueRange()->high;
    if (volume.unit() == Unit::suvBodyWeight) return windowOver({0.0, std::min(kUsualHighSuv, highest)});
    std::vector<double> values = someValues(volume);
    if (values.empty()) return std::nullopt;
    constexpr double kAllBut = 0.999;
    const auto place = values.begin() + std::ptrdiff_t(kAllBut * double(values.size() - 1));
    std::ranges::nth_element(values, place);
    return windowOver({0.0, *place > 0.0 ? *place : highest});
}

DisplayWindow seriesWindow(const Volume& volume) {
    if (isActivity(volume)) {
        if (const auto window = activityWindow(volume)) return *window;
    }
    if (!volume.windows().empty()) return volume.windows().front();
    return windowOver(volume.valueRange().value_or(ValueRange{0.0, 1.0}));
}

namespace {

// The largest stored values along evenly spread rays in each axis, ascending, without rays that meet only
// padding.
std::vector<std::uint16_t> largestAlongAxes(const Volume& volume) {
    constexpr int kRaysPerSide = 64;
    const glm::ivec3 size = volume.size();
    const std::optional<StoredRange> padding = volume.padding();
    std::vector<std::uint16_t> largest;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        const int strideU = (size[u] + kRaysPerSide - 1) / kRaysPerSide;
        const int strideV = (size[v] + kRaysPerSide - 1) / kRaysPerSide;
        for (int b = strideV / 2; b < size[v]; b += strideV) {
            for (int a = strideU / 2; a < size[u]; a += strideU) {
                std::optional<std::uint16_t> most;
                glm::ivec3 at(0);
                at[u] = a;
                at[v] = b;
                for (at[axis] = 0; at[axis] < size[axis]; ++at[axis]) {
                    const std::uint16_t stored = volume.stored(at.x, at.y, at.z);
                    if (padding && padding->contains(stored)) continue;
                    most = std::max(most.value_or(stored), stored);
                }
                if (most) largest.push_back(*most);
            }
        }
    }
    std::ranges::sort(largest);
    return largest;
}

}  // namespace

DisplayWindow maximumWindow(const Volume& volume) {
    if (isActivity(volume)) return seriesWindow(volume);
    const std::vector<std::uint16_t> largest = largestAlongAxes(volume);
    if (largest.empty()) return seriesWindow(volume);
    const auto valueAt = [&](double share) {
        return volume.unitsFromStored()(largest[std::size_t(share * double(largest.size() - 1))]);
    };
    constexpr double kMostWhite = 1.0 / 3.0;
    if (!volume.windows().empty()) {
        const DisplayWindow& window = volume.windows().front();
        if (valueAt(1.0 - kMostWhite) < window.center + window.width / 2.0) return window;
    }
    return windowOver({valueAt(0.1), valueAt(0.99)});
}

std::optional<DisplayWindow> presetWindow(const TransferFunction& preset, const Volume& volume) {
    const std::optional<ValueRange> range = fitted(preset, volume).effectiveRange;
    if (!range || !(range->low < range->high)) return std::nullopt;
    return windowOver(*range);
}

std::pair<float, float> entriesOf(const DisplayWindow& window, const Volume& volume) {
    const bool isExact = window.width <= 1.0 || window.function == "LINEAR_EXACT";
    const double low = window.center - window.width / 2.0;
    const double high = window.center + window.width / 2.0 - (isExact ? 0.0 : 1.0);
    const UnitsFromStored units = volume.unitsFromStored();
    const int firstStored = entryMapOf(volume).low;
    const auto entry = [&](double value) { return (value - units.intercept) / units.slope - firstStored; };
    return {static_cast<float>(entry(low)), static_cast<float>(std::max(entry(high), entry(low) + 0.02))};
}

DisplayWindow windowOver(const ValueRange& range) {
    return {.center = (range.low + range.high) / 2.0,
            .width = std::max(range.high - range.low, 1e-6),
            .explanation = {},
            .function = "LINEAR_EXACT"};
}

}  // namespace macula
