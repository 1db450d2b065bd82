#include "segment/shape_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "segment/dense_box.h"
#include "segment/distance.h"
#include "segment/voxel_sets.h"

namespace macula::segment {

namespace {

Result<void> checkLength(double mm) {
    if (std::isfinite(mm) && mm > 0.0 && mm <= kMostMm) return {};
    return Error{ErrorCode::usage,
                 Text("That length cannot be used: {} mm.", mm),
                 {},
                 Text("Enter one above 0, and of at most {} mm.", kMostMm)};
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to change the segment."),
            {},
            Text("Close other programs, or make the segment smaller first.")};
}

// The set within its box and so many voxels around it, as far as the grid goes.
Result<DenseBox> boxAround(const VoxelSet& set, const SegmentGrid& grid, const glm::ivec3& margin,
                           double bytesPerVoxel) {
    const glm::ivec3 low = glm::max(set.low() - margin, glm::ivec3(0));
    const glm::ivec3 high = glm::min(set.high() + margin, grid.size - 1);
    const glm::dvec3 size = glm::dvec3(high - low + 1);
    MACULA_TRY_VOID(checkMemory(size.x * size.y * size.z, bytesPerVoxel));
    return DenseBox::of(set, low, high, grid.spacingMm);
}

// Voxels that a length reaches along each axis, rounded down, with some room for rounding.
glm::ivec3 voxelsIn(double mm, const glm::dvec3& spacingMm) {
    constexpr double kRounding = 1e-9;
    constexpr double kMost = 65536.0;  // a spacing may be tiny
    return glm::ivec3(glm::min(glm::floor(glm::dvec3(mm) / spacingMm + kRounding), glm::dvec3(kMost)));
}

// Replaces each line of `values` along the axis by sums over it, weighted by `weights` (from the middle
// outwards, both sides alike). Beyond the box there is nothing. False: cancelled.
bool convolve(std::vector<float>& values, const Grid& grid, int axis, const std::vector<float>& weights,
              Progress& progress) {
    const std::array<std::size_t, 3> strides{1, std::size_t(grid.size.x), grid.sliceSize()};
    const std::size_t stride = strides[std::size_t(axis)];
    const int length = grid.size[axis];
    const int reach = int(weights.size()) - 1;
    const int outer = axis == 2 ? 1 : 2;  // lines are ordered by the other two axes
    const int inner = axis == 0 ? 1 : 0;
    parallelFor(
        std::size_t(grid.size[outer]),
        [&](std::size_t sheet) {
            std::vector<float> line(static_cast<std::size_t>(length));
            for (int n = 0; n < grid.size[inner]; ++n) {
                float* first = values.data() + sheet * strides[std::size_t(outer)] +
                               std::size_t(n) * strides[std::size_t(inner)];
                for (int at = 0; at < length; ++at) line[std::size_t(at)] = first[std::size_t(at) * stride];
                for (int at = 0; at < length; ++at) {
                    double sum = 0.0;
                    for (int by = std::max(-reach, -at); by <= std::min(reach, length - 1 - at); ++by)
                        sum += double(weights[std::size_t(std::abs(by))]) *
                               double(line[std::size_t(at) + std::size_t(by)]);
                    first[std::size_t(at) * stride] = float(sum);
                }
            }
        },
        progress.token());
    progress.advance();
    return !progress.cancelled();
}

// By place along an axis of the box: the sum of the weights that lie in the grid.
std::vector<double> weightsInGrid(int low, int length, int gridLength, const std::vector<float>& weights) {
    std::vector<double> sums(static_cast<std::size_t>(length));
    const int reach = int(weights.size()) - 1;
    for (int at = 0; at < length; ++at)
        for (int by = -reach; by <= reach; ++by)
            if (low + at + by >= 0 && low + at + by < gridLength)
                sums[std::size_t(at)] += double(weights[std::size_t(std::abs(by))]);
    return sums;
}

// The voxels where the weighted mean of the set is above one half; or equal to it, with `halfIsIn`.
Result<VoxelSet> whereMeanIsHalf(const VoxelSet& set, const SegmentGrid& grid,
                                 const std::array<std::vector<float>, 3>& weights, bool halfIsIn,
                                 Progress& progress) try {
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return VoxelSet();
    glm::ivec3 reach;
    for (int axis = 0; axis < 3; ++axis) reach[axis] = int(weights[std::size_t(axis)].size()) - 1;
    MACULA_TRY(const DenseBox box, boxAround(small, grid, reach, 6.0));
    progress.beginStage(Text("Smoothing"), 3);
    std::vector<float> means(box.mask.begin(), box.mask.end());
    std::array<std::vector<double>, 3> whole;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<float>& along = weights[std::size_t(axis)];
        if (!convolve(means, box.grid, axis, along, progress)) return segmentingCancelled();
        whole[std::size_t(axis)] = weightsInGrid(box.low[axis], box.grid.size[axis], grid.size[axis], along);
    }
    constexpr double kRounding = 1e-6;  // sums in float32
    const auto row = std::size_t(box.grid.size.x);
    return box.setWhere([&](std::size_t n) {
        const double most = whole[0][n % row] * whole[1][n / row % std::size_t(box.grid.size.y)] *
                            whole[2][n / box.grid.sliceSize()];
        const double half = 0.5 * most;
        return double(means[n]) > (halfIsIn ? half - kRounding * most : half + kRounding * most);
    });
} catch (const std::bad_alloc&) {
    return noMemory();
}

// The distances of a slice that lies in a box of one voxel along the axis: below 0 inside, in mm.
std::vector<float> signedDistances(const DenseBox& slice, const CancelToken& token) {
    Mask outside(slice.mask.size());
    std::ranges::transform(slice.mask, outside.begin(),
                           [](std::uint8_t in) { return std::uint8_t(in == 0); });
    std::vector<float> mm = distanceTo(slice.grid, slice.mask, token);
    const std::vector<float> depth = distanceTo(slice.grid, outside, token);
    for (std::size_t n = 0; n < mm.size(); ++n) mm[n] -= depth[n];
    return mm;
}

std::vector<int> slicesWithVoxels(const VoxelSet& set, int axis) {
    std::vector<bool> isThere(std::size_t(set.high()[axis] - set.low()[axis] + 1));
    set.forEach([&](const glm::ivec3& v) { isThere[std::size_t(v[axis] - set.low()[axis])] = true; });
    std::vector<int> slices;
    for (std::size_t n = 0; n < isThere.size(); ++n)
        if (isThere[n]) slices.push_back(set.low()[axis] + int(n));
    return slices;
}

bool hasGap(const std::vector<int>& slices) {
    return !slices.empty() && std::size_t(slices.back() - slices.front()) >= slices.size();
}

DenseBox sliceOf(const VoxelSet& set, const SegmentGrid& grid, int axis, int at) {
    // One voxel more around, so that there is an outside.
    glm::ivec3 low = set.low() - 1;
    glm::ivec3 high = set.high() + 1;
    low[axis] = high[axis] = at;
    DenseBox box{.low = low, .grid = {high - low + 1, grid.spacingMm}, .mask = {}};
    box.mask.resize(box.grid.count());
    std::size_t n = 0;
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) box.mask[n++] = set.contains({i, j, k}) ? 1 : 0;
    return box;
}

}  // namespace

Result<VoxelSet> medianOf(const VoxelSet& set, const SegmentGrid& grid, double radiusMm, Progress& progress) {
    MACULA_TRY_VOID(checkLength(radiusMm));
    const glm::ivec3 reach = voxelsIn(radiusMm, grid.spacingMm);
    std::array<std::vector<float>, 3> weights;
    for (int axis = 0; axis < 3; ++axis)
        weights[std::size_t(axis)].assign(std::size_t(std::min(reach[axis], grid.size[axis])) + 1, 1.0f);
    return whereMeanIsHalf(set, grid, weights, false, progress);
}

Result<VoxelSet> gaussianOf(const VoxelSet& set, const SegmentGrid& grid, double sigmaMm,
                            Progress& progress) {
    MACULA_TRY_VOID(checkLength(sigmaMm));
    constexpr double kSigmas = 3.0;
    const glm::ivec3 reach = voxelsIn(kSigmas * sigmaMm, grid.spacingMm);
    std::array<std::vector<float>, 3> weights;
    for (int axis = 0; axis < 3; ++axis) {
        const int most = std::min(reach[axis], grid.size[axis]);
        double sum = 0.0;
        std::vector<double> all;
        for (int by = 0; by <= most; ++by) {
            const double mm = by * grid.spacingMm[axis] / sigmaMm;
            all.push_back(std::exp(-0.5 * mm * mm));
            sum += (by == 0 ? 1.0 : 2.0) * all.back();
        }
        for (const double weight : all) weights[std::size_t(axis)].push_back(float(weight / sum));
    }
    return whereMeanIsHalf(set, grid, weights, true, progress);
}

Result<VoxelSet> grownBy(const VoxelSet& set, const SegmentGrid& grid, double mm, Progress& progress) try {
    MACULA_TRY_VOID(checkLength(mm));
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return VoxelSet();
    MACULA_TRY(const DenseBox box, boxAround(small, grid, voxelsIn(mm, grid.spacingMm), 14.0));
    progress.beginStage(Text("Growing the segment"), 1);
    const std::vector<float> far = distanceTo(box.grid, box.mask, progress.token());
    if (progress.cancelled()) return segmentingCancelled();
    const float most = float(mm * (1.0 + 1e-6));
    return box.setWhere([&](std::size_t n) { return far[n] <= most; });
} catch (const std::bad_alloc&) {
    return noMemory();
}

Result<VoxelSet> shrunkBy(const VoxelSet& set, const SegmentGrid& grid, double mm, Progress& progress) try {
    MACULA_TRY_VOID(checkLength(mm));
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return VoxelSet();
    MACULA_TRY(const DenseBox box, boxAround(small, grid, glm::ivec3(1), 16.0));
    progress.beginStage(Text("Shrinking the segment"), 1);
    Mask outside(box.mask.size());
    std::ranges::transform(box.mask, outside.begin(), [](std::uint8_t in) { return std::uint8_t(in == 0); });
    const std::vector<float> depth = distanceTo(box.grid, outside, progress.token());
    if (progress.cancelled()) return segmentingCancelled();
    const float least = float(mm * (1.0 + 1e-6));
    return box.setWhere([&](std::size_t n) { return box.mask[n] != 0 && depth[n] > least; });
} catch (const std::bad_alloc&) {
    return noMemory();
}

Result<VoxelSet> filledBetweenSlices(const VoxelSet& set, const SegmentGrid& grid, int axis,
                                     Progress& progress) try {
    const VoxelSet small = set.cropped();
    if (small.isEmpty()) return VoxelSet();
    for (int each = 2; axis < 0 && each >= 0; --each)
        if (hasGap(slicesWithVoxels(small, each))) axis = each;
    const std::vector<int> slices = axis < 0 ? std::vector<int>() : slicesWithVoxels(small, axis);
    if (axis > 2 || !hasGap(slices))
        return Error{ErrorCode::usage,
                     Text("There are no empty slices between others that are painted."),
                     {},
                     Text("Paint in one slice alone, then in another farther away, and fill between them.")};
    const glm::dvec3 size = glm::dvec3(small.high() - small.low() + 3);
    MACULA_TRY_VOID(checkMemory(size.x * size.y * size.z / size[axis], 40.0));
    VoxelSet filled = small;
    progress.beginStage(Text("Filling between slices"), slices.size());
    DenseBox below = sliceOf(small, grid, axis, slices.front());
    std::vector<float> belowMm = signedDistances(below, progress.token());
    for (std::size_t n = 1; n < slices.size(); ++n, progress.advance()) {
        const DenseBox above = sliceOf(small, grid, axis, slices[n]);
        const std::vector<float> aboveMm = signedDistances(above, progress.token());
        if (progress.cancelled()) return segmentingCancelled();
        const int from = slices[n - 1];
        const int to = slices[n];
        for (int at = from + 1; at < to; ++at) {
            const double part = double(at - from) / double(to - from);
            std::size_t cell = 0;
            for (int k = 0; k < above.grid.size.z; ++k)
                for (int j = 0; j < above.grid.size.y; ++j)
                    for (int i = 0; i < above.grid.size.x; ++i, ++cell) {
                        const double mm = (1.0 - part) * double(belowMm[cell]) + part * double(aboveMm[cell]);
                        if (mm >= 0.0) continue;
                        glm::ivec3 voxel = above.low + glm::ivec3(i, j, k);
                        voxel[axis] = at;
                        filled.add(voxel);
                    }
        }
        belowMm = aboveMm;
    }
    return filled.cropped();
} catch (const std::bad_alloc&) {
    return noMemory();
}

}  // namespace macula::segment
