#include "pipeline/volume/window.h"

#include <algorithm>

#include "pipeline/volume/volume_fit.h"

namespace macula {

DisplayWindow seriesWindow(const Volume& volume) {
    if (!volume.windows().empty()) return volume.windows().front();
    return windowOver(volume.valueRange().value_or(ValueRange{0.0, 1.0}));
}

std::optional<DisplayWindow> presetWindow(const TransferFunction& preset, const Volume& volume) {
    const std::optional<ValueRange> range = fitted(preset, volume).effectiveRange;
    if (!range || !(range->low < range->high)) return std::nullopt;
    return windowOver(*range);
}

DisplayWindow windowOver(const ValueRange& range) {
    return {.center = (range.low + range.high) / 2.0,
            .width = std::max(range.high - range.low, 1e-6),
            .explanation = {},
            .function = "LINEAR_EXACT"};
}

}  // namespace macula
