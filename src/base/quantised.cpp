#include "base/quantised.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace macula {

namespace {

constexpr double kLargestStored = 65535.0;
constexpr std::size_t kMostLookedAt = 1'000'000;  // voxels sampled to find the ends of the range
constexpr double kShareBeyond = 1e-4;             // of the voxels may lie beyond the range, at each end
constexpr double kStretched = 8.0;  // a range wider than the others' range by this factor is cut

bool isPadding(float value, std::optional<float> padding) {
    return std::isnan(value) || value == padding;
}

bool areWholeNumbers(std::span<const float> values, std::optional<float> padding) {
    std::atomic<bool> whole{true};
    inChunks(values.size(), [&](std::size_t first, std::size_t count) {
        if (!whole) return;
        for (const float value : values.subspan(first, count)) {
            if (!isPadding(value, padding) && value != std::trunc(value)) {
                whole = false;
                return;
            }
        }
    });
    return whole;
}

// Stored 0 is padding, 1 the smallest value. Whole numbers stay exact if there is room for them. If all
// values are equal, the step is that value's own size, so that it stays exact.
UnitsFromStored mapOver(const ValueRange& range, const Volume& volume) {
    UnitsFromStored map;
    map.slope = (range.high - range.low) / (kLargestStored - 1.0);
    if (map.slope > 0.0 && map.slope <= 1.0 && areWholeNumbers(volume.floatVoxels(), volume.floatPadding()))
        map.slope = 1.0;
    if (!(map.slope > 0.0)) map.slope = range.low != 0.0 ? std::abs(range.low) : 1.0;
    map.intercept = range.low - map.slope;
    return map;
}

// What quantising lost.
struct Loss {
    double largestError = 0.0;  // of the values within the range
    std::size_t beyond = 0;     // values that were clamped to an end of the range

    void add(const Loss& other) {
        largestError = std::max(largestError, other.largestError);
        beyond += other.beyond;
    }
};

Loss quantise(const Volume& volume, const ValueRange& range, const UnitsFromStored& map,
              std::span<std::uint16_t> stored) {
    const std::span<const float> values = volume.floatVoxels();
    const std::optional<float> padding = volume.floatPadding();
    std::mutex mutex;
    Loss loss;
    inChunks(values.size(), [&](std::size_t first, std::size_t count) {
        Loss here;
        for (std::size_t i = first; i < first + count; ++i) {
            if (isPadding(values[i], padding)) continue;
            const double value = values[i];
            const double within = std::clamp(value, range.low, range.high);
            const double steps = std::round((within - map.intercept) / map.slope);
            stored[i] = static_cast<std::uint16_t>(std::clamp(steps, 1.0, kLargestStored));
            here.add(
                {.largestError = std::abs(map(stored[i]) - within), .beyond = within != value ? 1U : 0U});
        }
        const std::lock_guard lock(mutex);
        loss.add(here);
    });
    return loss;
}

std::vector<Text> sentencesOf(const Loss& loss, const ValueRange& range, const std::string& unitName) {
    const Text unit = unitName.empty() ? Text() : Text(" {}", unitText(unitName));
    std::vector<Text> sentences;
    if (loss.largestError > 0.0)
        sentences.push_back(Text("The 3D picture has values of 16 bits, with an error of at most {:.3g}{}.",
                                 loss.largestError, unit));
    if (loss.beyond > 0)
        sentences.push_back(Text("The 3D picture shows values below {:.4g}{} or above {:.4g}{} as these.",
                                 range.low, unit, range.high, unit));
    return sentences;
}

}  // namespace

std::optional<ValueRange> rangeToQuantise(const Volume& volume) {
    const std::optional<ValueRange> whole = volume.valueRange();
    if (!whole || volume.format() != VoxelFormat::float32) return whole;
    const std::span<const float> voxels = volume.floatVoxels();
    const std::size_t stride = voxels.size() / kMostLookedAt + 1;
    std::vector<float> values;
    for (std::size_t at = 0; at < voxels.size(); at += stride)
        if (!isPadding(voxels[at], volume.floatPadding())) values.push_back(voxels[at]);
    const auto beyond = static_cast<std::ptrdiff_t>(kShareBeyond * double(values.size()));
    if (beyond == 0) return whole;
    std::ranges::nth_element(values, values.begin() + beyond);
    const double low = values[std::size_t(beyond)];
    std::ranges::nth_element(values, values.end() - 1 - beyond);
    const double high = values[values.size() - 1 - std::size_t(beyond)];
    const double width = high - low;
    if (!(width > 0.0) || whole->high - whole->low <= kStretched * width) return whole;
    return ValueRange{std::max(whole->low, low - width), std::min(whole->high, high + width)};
}

Quantised quantised(std::shared_ptr<const Volume> volume) {
    if (volume->format() == VoxelFormat::stored16) return {.volume = std::move(volume)};
    const ValueRange range = rangeToQuantise(*volume).value_or(ValueRange{});
    const UnitsFromStored map = mapOver(range, *volume);
    std::vector<std::uint16_t> stored(volume->voxelCount());
    const Loss loss = quantise(*volume, range, map, stored);
    VolumeOptions options{.size = volume->size(),
                          .worldFromVoxel = volume->worldFromVoxel(),
                          .unitsFromStored = map,
                          .unit = volume->unit(),
                          .modality = volume->modality(),
                          .padding = StoredRange{0, 0},
                          .provenance = volume->provenance(),
                          .floatPadding = {},
                          .unitName = volume->unitName(),
                          .windows = volume->windows(),
                          .bodyPart = volume->bodyPart()};
    for (Text& sentence : sentencesOf(loss, range, options.unitName))
        options.provenance.assumptions.push_back(std::move(sentence));
    auto made = Volume::create(std::move(options), std::move(stored));
    return {.volume = std::make_shared<const Volume>(std::move(made).value()),
            .isExact = !(loss.largestError > 0.0) && loss.beyond == 0};
}

std::shared_ptr<const Volume> in16Bits(std::shared_ptr<const Volume> volume) {
    return quantised(std::move(volume)).volume;
}

}  // namespace macula
