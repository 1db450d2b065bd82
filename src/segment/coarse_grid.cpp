#include "segment/coarse_grid.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace macula::segment {

namespace {

constexpr double kBlockMm = 2.0;
// Nothing is less dense than vacuum (-1000): lower values (-2000, -3024) mark voxels outside the scanner's
// field of view.
constexpr double kNothingHu = -1100.0;

struct Counts {
    std::uint16_t solid = 0;
    std::uint16_t faint = 0;
    std::uint16_t outside = 0;
};

// Adds one row of voxels to the counts of the blocks along it.
template <class T, class IsSolid, class IsFaint, class IsOutside>
void addRow(std::span<const T> row, int factor, std::vector<Counts>& counts, std::size_t first,
            const IsSolid& isSolid, const IsFaint& isFaint, const IsOutside& isOutside) {
    std::size_t block = first;
    for (std::size_t i = 0; i < row.size(); i += std::size_t(factor), ++block) {
        const std::size_t end = std::min(row.size(), i + std::size_t(factor));
        unsigned solid = 0;
        unsigned faint = 0;
        unsigned outside = 0;
        for (std::size_t at = i; at < end; ++at) {
            const bool out = isOutside(row[at]);
            outside += out ? 1u : 0u;
            solid += !out && isSolid(row[at]) ? 1u : 0u;
            faint += !out && isFaint(row[at]) ? 1u : 0u;
        }
        counts[block].solid = static_cast<std::uint16_t>(counts[block].solid + solid);
        counts[block].faint = static_cast<std::uint16_t>(counts[block].faint + faint);
        counts[block].outside = static_cast<std::uint16_t>(counts[block].outside + outside);
    }
}

void addRow(const Volume& volume, std::size_t offset, int factor, std::vector<Counts>& counts,
            std::size_t first) {
    const auto length = std::size_t(volume.size().x);
    if (volume.format() == VoxelFormat::float32) {
        const float padding = volume.floatPadding().value_or(std::numeric_limits<float>::quiet_NaN());
        addRow(
            volume.floatVoxels().subspan(offset, length), factor, counts, first,
            [](float value) { return value > float(kSolidHu); },
            [](float value) { return value > float(kFaintHu); },
            [&](float value) { return !(value >= float(kNothingHu)) || value == padding; });
        return;
    }
    const UnitsFromStored map = volume.unitsFromStored();
    const double solid = (kSolidHu - map.intercept) / map.slope;
    const double faint = (kFaintHu - map.intercept) / map.slope;
    const double nothing = (kNothingHu - map.intercept) / map.slope;
    const auto clamped = [](double stored) {
        return static_cast<std::int32_t>(std::clamp(std::floor(stored), -1.0, 65536.0));
    };
    const std::int32_t solidAbove = clamped(solid);
    const std::int32_t faintAbove = clamped(faint);
    const std::int32_t nothingUpTo = clamped(nothing);
    const StoredRange padding = volume.padding().value_or(StoredRange{1, 0});  // empty when there is none
    addRow(
        volume.voxels().subspan(offset, length), factor, counts, first,
        [&](std::uint16_t stored) { return stored > solidAbove; },
        [&](std::uint16_t stored) { return stored > faintAbove; },
        [&](std::uint16_t stored) { return stored <= nothingUpTo || padding.contains(stored); });
}

}  // namespace

CoarseGrid makeCoarseGrid(const Volume& volume, const CancelToken& token) {
    const glm::ivec3 size = volume.size();
    const glm::dvec3 spacing = volume.spacingMm();
    CoarseGrid coarse;
    glm::ivec3 blocks;
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = std::clamp(std::round(kBlockMm / spacing[axis]), 1.0, 32.0);
        coarse.factor[std::size_t(axis)] = int(voxels);
        blocks[axis] = (size[axis] + int(voxels) - 1) / int(voxels);
    }
    const int fi = coarse.factor[0];  // a lambda cannot take structured bindings along
    const int fj = coarse.factor[1];
    const int fk = coarse.factor[2];

    // The table runs along the voxel axis that is nearest to the patient's long axis.
    int along = 2;
    for (int axis = 0; axis < 3; ++axis) {
        const auto slope = [&](int n) { return std::abs(volume.worldFromVoxel()[n].z) / spacing[n]; };
        if (slope(axis) > slope(along) + 1e-6) along = axis;
    }
    const std::array<int, 3> order{along == 0 ? 1 : 0, along == 2 ? 1 : 2, along};
    std::size_t stride = 1;
    for (int n = 0; n < 3; ++n) {
        const int axis = order[std::size_t(n)];
        coarse.grid.size[n] = blocks[axis];
        coarse.grid.spacingMm[n] = spacing[axis] * coarse.factor[std::size_t(axis)];
        coarse.stride[std::size_t(axis)] = stride;
        stride *= std::size_t(blocks[axis]);
    }
    coarse.voxelsPerBlock = double(fi) * fj * fk;
    coarse.blockMl =
        std::abs(glm::determinant(glm::dmat3(volume.worldFromVoxel()))) * coarse.voxelsPerBlock / 1000.0;
    coarse.solid.resize(coarse.grid.count());
    coarse.faint.resize(coarse.grid.count());
    coarse.outside.resize(coarse.grid.count());

    parallelFor(
        std::size_t(blocks.z),
        [&](std::size_t blockK) {
            std::vector<Counts> counts(std::size_t(blocks.x));
            const int kEnd = std::min(size.z, (int(blockK) + 1) * fk);
            for (int blockJ = 0; blockJ < blocks.y; ++blockJ) {
                std::fill(counts.begin(), counts.end(), Counts{});
                const int jEnd = std::min(size.y, (blockJ + 1) * fj);
                for (int k = int(blockK) * fk; k < kEnd; ++k) {
                    for (int j = blockJ * fj; j < jEnd; ++j) {
                        const std::size_t row = std::size_t(k) * std::size_t(size.y) + std::size_t(j);
                        addRow(volume, row * std::size_t(size.x), fi, counts, 0);
                    }
                }
                const unsigned rows = unsigned(kEnd - int(blockK) * fk) * unsigned(jEnd - blockJ * fj);
                for (std::size_t blockI = 0; blockI < counts.size(); ++blockI) {
                    const auto width = unsigned(std::min(fi, size.x - int(blockI) * fi));
                    const std::size_t at = blockI * coarse.stride[0] +
                                           std::size_t(blockJ) * coarse.stride[1] + blockK * coarse.stride[2];
                    coarse.solid[at] =
                        static_cast<std::uint8_t>(counts[blockI].solid * 255u / (rows * width));
                    coarse.faint[at] =
                        static_cast<std::uint8_t>(counts[blockI].faint * 255u / (rows * width));
                    coarse.outside[at] = 2u * counts[blockI].outside > rows * width ? 1 : 0;
                }
            }
        },
        token);
    return coarse;
}

}  // namespace macula::segment
