#include "pipeline/volume/additions.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "base/srgb.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

namespace {

constexpr double kSlackVoxels = 0.05;  // voxels of the second volume by which rounding may move a point
constexpr double kSlackOfWay = 1e-6;   // likewise, relative to its distance from the corner

bool isShare(float x) {
    return x >= 0.0f && x <= 1.0f;
}

Result<void> validate(const DrawnSecondVolume& second) {
    if (!second.volume || !second.function || second.volume->format() != VoxelFormat::stored16)
        return Error{ErrorCode::usage,
                     Text("There is no second volume with a preset."),
                     {},
                     Text("Open a second volume, and choose a preset for it.")};
    if (!isInvertibleAffine(second.secondFromVolumeMm))
        return Error{ErrorCode::usage,
                     Text("Where the second volume lies is not usable."),
                     {},
                     Text("Register the two volumes again.")};
    return validate(*second.function);
}

// Shaders index voxels with 31 bits.
bool isWhole(const TintBox& box) {
    if (box.size.x < 1 || box.size.y < 1 || box.size.z < 1) return false;
    const std::size_t voxels = std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z);
    return box.voxels.size() == voxels && voxels <= std::size_t(std::numeric_limits<std::int32_t>::max());
}

bool isKnown(const SegmentTints& tints, const std::optional<SegmentTints>& valid) {
    return valid && tints.box == valid->box && tints.colours.size() >= valid->colours.size();
}

Result<void> validate(const SegmentTints& tints, const Volume& volume,
                      const std::optional<SegmentTints>& valid) {
    const bool isOf = tints.box && tints.box->volumeSize == volume.size() && isWhole(*tints.box);
    if (!isOf || tints.colours.size() > SegmentTints::kMostColours)
        return Error{ErrorCode::usage,
                     Text("The coloured segments are not of this volume."),
                     {},
                     Text("Show the segmentation again.")};
    if (!isKnown(tints, valid) &&
        std::size_t(*std::ranges::max_element(tints.box->voxels)) > tints.colours.size())
        return Error{ErrorCode::usage,
                     Text("A coloured segment has no colour."),
                     {},
                     Text("Show the segmentation again.")};
    for (const SegmentTints::Colour& colour : tints.colours) {
        if (isShare(colour.rgb.r) && isShare(colour.rgb.g) && isShare(colour.rgb.b) &&
            isShare(colour.opacity))
            continue;
        return Error{ErrorCode::usage,
                     Text("The colour of a segment is not usable."),
                     {},
                     Text("Give red, green, blue and opacity from 0 to 1.")};
    }
    return {};
}

// The box of a brick in voxels of the second volume, enlarged against rounding.
Box roomInSecond(const glm::dmat4& secondFromVoxel, const glm::ivec3& brick, const glm::ivec3& voxels) {
    const glm::dvec3 first = double(kBrickVoxels) * glm::dvec3(brick) - 1.0;
    const glm::dvec3 low = glm::max(first, glm::dvec3(-0.5));
    const glm::dvec3 high = glm::min(first + double(kBrickVoxels), glm::dvec3(voxels) - 0.5);
    const glm::dvec3 centre = transformPoint(secondFromVoxel, 0.5 * (low + high));
    const glm::dmat3 axes(secondFromVoxel);
    const glm::dvec3 half = glm::dmat3(glm::abs(axes[0]), glm::abs(axes[1]), glm::abs(axes[2])) *
                            (0.5 * glm::max(high - low, glm::dvec3(0.0)));
    const glm::dvec3 slack = kSlackVoxels + kSlackOfWay * (glm::abs(centre) + half);
    return {centre - half - slack, centre + half + slack};
}

}  // namespace

Result<void> validate(const Additions& additions, const Volume& volume, const Additions& valid) {
    if (additions.second) MACULA_TRY_VOID(validate(*additions.second));
    if (additions.tints) MACULA_TRY_VOID(validate(*additions.tints, volume, valid.tints));
    return {};
}

bool isSameMatter(const Additions& a, const Additions& b) {
    return a.second == b.second;
}

glm::dmat4 secondVoxelFromVoxel(const DrawnSecondVolume& second, const Volume& volume) {
    return glm::inverse(second.volume->worldFromVoxel()) * second.secondFromVolumeMm *
           volume.worldFromVoxel();
}

SecondMedium makeSecondMedium(const DrawnSecondVolume& second) {
    SecondMedium made{.grid = makeBrickGrid(*second.volume), .medium = {}};
    made.medium = makeMedium(*second.volume, made.grid, *second.function);
    return made;
}

std::vector<float> boundsInVolume(const DrawnSecondVolume& second, const SecondMedium& made,
                                  const Volume& volume, const BrickGrid& grid) {
    MACULA_CHECK_EQ(made.medium.bounds.size(), made.grid.ranges.size());
    const glm::dmat4 secondFromVoxel = secondVoxelFromVoxel(second, volume);
    const glm::dvec3 end = glm::dvec3(second.volume->size()) - 0.5;
    std::vector<float> bounds(grid.ranges.size(), 0.0f);
    parallelFor(std::size_t(grid.size.y) * std::size_t(grid.size.z), [&](std::size_t row) {
        const int y = static_cast<int>(row) % grid.size.y;
        const int z = static_cast<int>(row) / grid.size.y;
        for (int x = 0; x < grid.size.x; ++x) {
            const Box room = roomInSecond(secondFromVoxel, {x, y, z}, volume.size());
            if (glm::any(glm::lessThan(room.high, glm::dvec3(-0.5))) ||
                glm::any(glm::greaterThan(room.low, end)))
                continue;
            // Clamps before the conversion: points far outside would overflow an integer.
            const glm::dvec3 within = glm::dvec3(made.grid.size - 1) * double(kBrickVoxels);
            const glm::ivec3 low(
                glm::floor(glm::clamp(room.low + 1.0, glm::dvec3(0.0), within) / double(kBrickVoxels)));
            const glm::ivec3 high(
                glm::floor(glm::clamp(room.high + 1.0, glm::dvec3(0.0), within) / double(kBrickVoxels)));
            float bound = 0.0f;
            for (int k = low.z; k <= high.z; ++k)
                for (int j = low.y; j <= high.y; ++j)
                    for (int i = low.x; i <= high.x; ++i)
                        bound = std::max(bound, made.medium.bounds[made.grid.index(i, j, k)]);
            bounds[grid.index(x, y, z)] = bound;
        }
    });
    return bounds;
}

std::vector<float> addedBounds(const Additions& additions, const Volume& volume, const BrickGrid& grid) {
    if (!additions.second) return {};
    return boundsInVolume(*additions.second, makeSecondMedium(*additions.second), volume, grid);
}

std::vector<glm::vec4> additionTable(const Additions& additions) {
    std::vector<glm::vec4> table;
    if (additions.second) table = opticsByEntry(*additions.second->volume, *additions.second->function);
    if (!additions.tints) return table;
    for (const SegmentTints::Colour& colour : additions.tints->colours)
        table.emplace_back(decodedSrgb(colour.rgb.r), decodedSrgb(colour.rgb.g), decodedSrgb(colour.rgb.b),
                           colour.opacity);
    return table;
}

double stepsPerEntryOf(const DrawnSecondVolume& second) {
    const Volume& volume = *second.volume;
    return volume.unitsFromStored().slope / featureUnitsOf(*second.function, volume);
}

SecondExtinction::SecondExtinction(const DrawnSecondVolume& second, const Volume& volume)
    : second_(second.volume),
      optics_(opticsByEntry(*second.volume, *second.function)),
      secondFromVoxel_(secondVoxelFromVoxel(second, volume)) {}

double SecondExtinction::at(const glm::dvec3& voxel) const {
    const glm::dvec3 there = transformPoint(secondFromVoxel_, voxel);
    const glm::dvec3 last = glm::dvec3(second_->size()) - 1.0;
    if (!(glm::all(glm::greaterThanEqual(there, glm::dvec3(-0.5))) &&
          glm::all(glm::lessThanEqual(there, last + 0.5))))
        return 0.0;
    const EntryMap map = entryMapOf(*second_);
    const glm::dvec3 at = glm::clamp(there, glm::dvec3(0.0), last);
    const glm::ivec3 low(at);
    const glm::ivec3 high = glm::min(low + 1, second_->size() - 1);
    const glm::dvec3 f = at - glm::dvec3(low);
    const auto entry = [&](int i, int j, int k) { return double(map.entryOf(second_->stored(i, j, k))); };
    const auto along = [&](int j, int k) { return glm::mix(entry(low.x, j, k), entry(high.x, j, k), f.x); };
    const double position = glm::mix(glm::mix(along(low.y, low.z), along(high.y, low.z), f.y),
                                     glm::mix(along(low.y, high.z), along(high.y, high.z), f.y), f.z);
    const auto entryBelow = static_cast<std::size_t>(position);
    return glm::mix(double(optics_[entryBelow].w), double(optics_[entryBelow + 1].w),
                    position - double(entryBelow));
}

}  // namespace macula
