#include "base/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.h"

namespace macula {

namespace {

constexpr double kAirHu = -1000.0;
constexpr std::int64_t kMaxVoxelsPerAxis = 65536;

StoredRange rangeWithoutPadding(std::span<const std::uint16_t> voxels,
                                const std::optional<StoredRange>& padding) {
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    std::mutex mutex;
    StoredRange range{std::numeric_limits<std::uint16_t>::max(), 0};
    parallelFor((voxels.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        StoredRange local{std::numeric_limits<std::uint16_t>::max(), 0};
        for (const std::uint16_t stored :
             voxels.subspan(chunk * kChunk, std::min(kChunk, voxels.size() - chunk * kChunk))) {
            if (padding && padding->contains(stored)) continue;
            local.low = std::min(local.low, stored);
            local.high = std::max(local.high, stored);
        }
        const std::lock_guard lock(mutex);
        range.low = std::min(range.low, local.low);
        range.high = std::max(range.high, local.high);
    });
    return range.low <= range.high ? range : StoredRange{};
}

}  // namespace

Result<Volume> Volume::create(VolumeOptions options, std::vector<std::uint16_t> voxels) {
    const auto fail = [](std::string message) {
        return Error{ErrorCode::inputNotUsable, std::move(message), {}, "Choose another series."};
    };
    const glm::ivec3 size = options.size;
    if (size.x < 1 || size.y < 1 || size.z < 1 || size.x > kMaxVoxelsPerAxis || size.y > kMaxVoxelsPerAxis ||
        size.z > kMaxVoxelsPerAxis) {
        return fail(fmt::format("A volume of {} x {} x {} voxels cannot be shown.", size.x, size.y, size.z));
    }
    const std::size_t expected = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    if (voxels.size() != expected) {
        return fail(fmt::format("The volume should have {} voxels, and has {}.", expected, voxels.size()));
    }
    if (!isInvertibleAffine(options.worldFromVoxel)) {
        return fail(
            "The position of the voxels in the patient is not usable: the axes do not span a volume.");
    }
    const auto [slope, intercept] = options.unitsFromStored;
    if (!(std::isfinite(slope) && slope > 0.0 && std::isfinite(intercept))) {
        return fail("The map from stored values to units is not usable.");
    }
    return Volume(std::move(options), std::move(voxels));
}

Volume::Volume(VolumeOptions options, std::vector<std::uint16_t> voxels)
    : options_(std::move(options)),
      voxels_(std::move(voxels)),
      storedRange_(rangeWithoutPadding(voxels_, options_.padding)) {}

std::uint16_t Volume::stored(int i, int j, int k) const {
    const glm::ivec3 size = options_.size;
    MACULA_CHECK(i >= 0 && j >= 0 && k >= 0 && i < size.x && j < size.y && k < size.z);
    return voxels_[(std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) +
                   std::size_t(i)];
}

int Volume::airStored() const {
    if (options_.unit != Unit::hounsfield) return storedRange_.low;
    const double stored = (kAirHu - options_.unitsFromStored.intercept) / options_.unitsFromStored.slope;
    return static_cast<int>(std::clamp(std::round(stored), -65536.0, 131071.0));
}

glm::dvec3 Volume::spacingMm() const {
    const glm::dmat4& m = options_.worldFromVoxel;
    return {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
}

Box Volume::worldBox() const {
    Box box{glm::dvec3(std::numeric_limits<double>::max()),
            glm::dvec3(std::numeric_limits<double>::lowest())};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 voxel{(corner & 1 ? options_.size.x : 0) - 0.5,
                               (corner & 2 ? options_.size.y : 0) - 0.5,
                               (corner & 4 ? options_.size.z : 0) - 0.5};
        const glm::dvec3 world = transformPoint(options_.worldFromVoxel, voxel);
        box.low = glm::min(box.low, world);
        box.high = glm::max(box.high, world);
    }
    return box;
}

}  // namespace macula
