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

// Smallest and largest voxel for which `isPadding` is false; low > high if there is none.
template <class T, class IsPadding>
std::pair<T, T> rangeWithoutPadding(std::span<const T> voxels, const IsPadding& isPadding) {
    using Limits = std::numeric_limits<T>;
    std::mutex mutex;
    std::pair<T, T> range{Limits::max(), Limits::lowest()};
    inChunks(voxels.size(), [&](std::size_t first, std::size_t count) {
        std::pair<T, T> local{Limits::max(), Limits::lowest()};
        for (const T voxel : voxels.subspan(first, count)) {
            if (isPadding(voxel)) continue;
            local.first = std::min(local.first, voxel);
            local.second = std::max(local.second, voxel);
        }
        const std::lock_guard lock(mutex);
        range.first = std::min(range.first, local.first);
        range.second = std::max(range.second, local.second);
    });
    return range;
}

Result<void> checkOptions(const VolumeOptions& options, std::size_t voxels) {
    const auto fail = [](Text message) {
        return Error{ErrorCode::inputNotUsable, std::move(message), {}, Text("Choose another series.")};
    };
    const glm::ivec3 size = options.size;
    if (size.x < 1 || size.y < 1 || size.z < 1 || size.x > kMaxVoxelsPerAxis || size.y > kMaxVoxelsPerAxis ||
        size.z > kMaxVoxelsPerAxis) {
        return fail(Text("A volume of {} x {} x {} voxels cannot be shown.", size.x, size.y, size.z));
    }
    const std::size_t expected = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    if (voxels != expected) {
        return fail(Text("The volume should have {} voxels, and has {}.", expected, voxels));
    }
    if (!isInvertibleAffine(options.worldFromVoxel)) {
        return fail(
            Text("The position of the voxels in the patient is not usable: the axes do not span a volume."));
    }
    const auto [slope, intercept] = options.unitsFromStored;
    if (!(std::isfinite(slope) && slope > 0.0 && std::isfinite(intercept))) {
        return fail(Text("The map from stored values to units is not usable."));
    }
    return {};
}

}  // namespace

std::string_view unitSymbol(Unit unit) {
    switch (unit) {
        case Unit::hounsfield:
            return "HU";
        case Unit::becquerelsPerMillilitre:
            return "Bq/mL";
        case Unit::suvBodyWeight:
            return "SUV bw";
        case Unit::raw:
        case Unit::other:
            break;
    }
    return {};
}

Text unitText(std::string_view name) {
    if (name == "another unit") return Text("another unit");
    if (name == "× reference dose") return Text("× reference dose");
    // Of a difference of two phases (slices/difference.h).
    if (name == "difference") return Text("difference");
    if (constexpr std::string_view kOf = " difference"; name.ends_with(kOf))
        return Text("{} difference", name.substr(0, name.size() - kOf.size()));
    return Text::verbatim(name);
}

Result<Volume> Volume::create(VolumeOptions options, std::vector<std::uint16_t> voxels) {
    MACULA_TRY_VOID(checkOptions(options, voxels.size()));
    return Volume(std::move(options), std::move(voxels));
}

Result<Volume> Volume::createFloat(VolumeOptions options, std::vector<float> voxels) {
    MACULA_TRY_VOID(checkOptions(options, voxels.size()));
    MACULA_CHECK(options.unitsFromStored == UnitsFromStored{} && !options.padding);
    return Volume(std::move(options), std::move(voxels));
}

Volume::Volume(VolumeOptions options, std::vector<std::uint16_t> voxels)
    : options_(std::move(options)), voxels_(std::move(voxels)) {
    const std::optional<StoredRange> padding = options_.padding;
    const auto [low, high] = rangeWithoutPadding<std::uint16_t>(
        voxels_, [&](std::uint16_t stored) { return padding && padding->contains(stored); });
    if (low > high) return;
    storedRange_ = {low, high};
    valueRange_ = ValueRange{options_.unitsFromStored(low), options_.unitsFromStored(high)};
}

Volume::Volume(VolumeOptions options, std::vector<float> voxels)
    : options_(std::move(options)), format_(VoxelFormat::float32), floatVoxels_(std::move(voxels)) {
    inChunks(floatVoxels_.size(), [&](std::size_t first, std::size_t count) {
        for (float& voxel : std::span(floatVoxels_).subspan(first, count)) {
            if (std::isinf(voxel)) voxel = std::numeric_limits<float>::quiet_NaN();
        }
    });
    const auto [low, high] =
        rangeWithoutPadding<float>(floatVoxels_, [&](float voxel) { return isPadding(voxel); });
    if (low <= high) valueRange_ = ValueRange{low, high};
}

std::size_t Volume::voxelCount() const {
    return format_ == VoxelFormat::float32 ? floatVoxels_.size() : voxels_.size();
}

std::string Volume::unitName() const {
    return options_.unitName.empty() ? std::string(unitSymbol(options_.unit)) : options_.unitName;
}

std::span<const std::uint16_t> Volume::voxels() const {
    return MACULA_CHECK(format_ == VoxelFormat::stored16), voxels_;
}

std::span<const float> Volume::floatVoxels() const {
    return MACULA_CHECK(format_ == VoxelFormat::float32), floatVoxels_;
}

std::size_t Volume::indexOf(int i, int j, int k) const {
    const glm::ivec3 size = options_.size;
    MACULA_CHECK(i >= 0 && j >= 0 && k >= 0 && i < size.x && j < size.y && k < size.z);
    return (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) + std::size_t(i);
}

std::uint16_t Volume::stored(int i, int j, int k) const {
    return voxels()[indexOf(i, j, k)];
}

double Volume::value(int i, int j, int k) const {
    if (format_ == VoxelFormat::float32) return floatVoxels_[indexOf(i, j, k)];
    return options_.unitsFromStored(stored(i, j, k));
}

bool Volume::isPadding(float voxel) const {
    return std::isnan(voxel) || voxel == options_.floatPadding;
}

bool Volume::isPadding(int i, int j, int k) const {
    if (format_ == VoxelFormat::float32) return isPadding(floatVoxels_[indexOf(i, j, k)]);
    return options_.padding && options_.padding->contains(stored(i, j, k));
}

StoredRange Volume::storedRange() const {
    return MACULA_CHECK(format_ == VoxelFormat::stored16), storedRange_;
}

int Volume::airStored() const {
    if (options_.unit != Unit::hounsfield) return storedRange().low;
    MACULA_CHECK(format_ == VoxelFormat::stored16);
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
    for (const glm::dvec3& voxel : cornersOf({glm::dvec3(-0.5), glm::dvec3(options_.size) - 0.5})) {
        const glm::dvec3 world = transformPoint(options_.worldFromVoxel, voxel);
        box.low = glm::min(box.low, world);
        box.high = glm::max(box.high, world);
    }
    return box;
}

}  // namespace macula
