#include "slices/sampled_slice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.h"
#include "slices/interpolated.h"
#include "slices/slab_steps.h"
#include "slices/voxel_grid.h"

namespace macula::slices {

namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

// The bounds within which a place has voxels on both sides along each axis.
Bounds insideOf(const glm::ivec3& size) {
    Bounds inside{glm::dvec3(0.0), glm::dvec3(size - 1)};
    for (int axis = 0; axis < 3; ++axis) inside.high[axis] = std::nextafter(inside.high[axis], -1.0);
    return inside;
}

// The middles of the pixels of a row, in voxel coordinates. Each is found from the first, so that a long row
// does not drift.
struct Line {
    glm::dvec3 first{0.0};
    glm::dvec3 step{0.0};

    glm::dvec3 at(int n) const { return first + double(n) * step; }
};

// A range of pixels of a row; `end` is one past the last.
struct Span {
    int begin = 0;
    int end = 0;
};

// The pixels of `among` within the bounds. They are contiguous, because rounding keeps the order of
// coordinates; so only the two ends need an exact test, after the quotients have given their approximate
// places.
Span within(const Bounds& bounds, const Line& line, const Span& among) {
    double first = among.begin;
    double last = among.end - 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double step = line.step[axis];
        if (step == 0.0) continue;
        const double a = (bounds.low[axis] - line.first[axis]) / step;
        const double b = (bounds.high[axis] - line.first[axis]) / step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    constexpr double kRounding = 1.0;
    if (!(first <= last + 2.0 * kRounding)) return {among.begin, among.begin};
    Span found{std::max(among.begin, static_cast<int>(first - kRounding)),
               std::min(among.end, static_cast<int>(last + kRounding) + 1)};
    while (found.begin < found.end && !bounds.contain(line.at(found.begin))) ++found.begin;
    while (found.begin < found.end && !bounds.contain(line.at(found.end - 1))) --found.end;
    if (found.begin >= found.end) return {among.begin, among.begin};
    return found;
}

// Writes the pixels of the row that lie in the volume, and returns which these are.
template <class Voxels>
Span readLine(const VoxelGrid<Voxels>& grid, const Line& line, Filter filter, std::span<float> row) {
    const Span all = within(boundsOf(grid.size()), line, {0, static_cast<int>(row.size())});
    const auto write = [&](int begin, int end, const auto& value) {
        for (int n = begin; n < end; ++n) row[std::size_t(n)] = static_cast<float>(value(line.at(n)));
    };
    if (filter == Filter::nearest) {
        write(all.begin, all.end, [&](const glm::dvec3& at) { return grid.nearest(at); });
        return all;
    }
    const Span inside = within(insideOf(grid.size()), line, all);
    const auto atBorder = [&](const glm::dvec3& at) { return grid.linear(at); };
    write(all.begin, inside.begin, atBorder);
    write(inside.begin, inside.end, [&](const glm::dvec3& at) { return grid.linearInside(at); });
    write(inside.end, all.end, atBorder);
    return all;
}

// Projects the planes of a slab onto a row of pixels, plane by plane. `row` is NaN at first.
class SlabRow {
  public:
    SlabRow(Projection projection, std::span<float> row) : projection_(projection), row_(row) {
        if (projection != Projection::mean) return;
        sums_.resize(row.size());
        weights_.resize(row.size());
    }

    void add(const Span& pixels, const std::vector<float>& values, double weight) {
        const auto begin = static_cast<std::size_t>(pixels.begin);
        const auto end = static_cast<std::size_t>(pixels.end);
        switch (projection_) {
            case Projection::mean:
                for (std::size_t n = begin; n < end; ++n) {
                    if (std::isnan(values[n])) continue;
                    sums_[n] += weight * values[n];
                    weights_[n] += weight;
                }
                break;
            case Projection::maximum:
                for (std::size_t n = begin; n < end; ++n)
                    if (values[n] > row_[n] || std::isnan(row_[n])) row_[n] = values[n];
                break;
            case Projection::minimum:
                for (std::size_t n = begin; n < end; ++n)
                    if (values[n] < row_[n] || std::isnan(row_[n])) row_[n] = values[n];
                break;
        }
    }

    void finish() {
        for (std::size_t n = 0; n < sums_.size(); ++n)
            if (weights_[n] > 0.0) row_[n] = static_cast<float>(sums_[n] / weights_[n]);
    }

  private:
    Projection projection_;
    std::span<float> row_;
    std::vector<double> sums_;
    std::vector<double> weights_;
};

// Samples the rows of a picture in a volume.
class Rows {
  public:
    Rows(const Volume& volume, const SliceFrame& frame) : frame_(frame), places_(volume) {
        step_ = places_.ofVector(frame.plane.right * frame.mmPerPixel);
    }

    Line row(std::size_t y, double depthMm) const {
        const glm::dvec3 mm = frame_.worldFromPicture({0.5, double(y) + 0.5});
        return {places_.ofPoint(mm + depthMm * frame_.plane.normal()), step_};
    }

  private:
    SliceFrame frame_;
    VoxelPlaces places_;
    glm::dvec3 step_{0.0};
};

template <class Voxels>
void readRow(const VoxelGrid<Voxels>& grid, const Rows& rows, std::size_t y,
             const std::vector<SlabStep>& steps, Projection projection, Filter filter, std::span<float> row) {
    if (steps.size() == 1) {
        readLine(grid, rows.row(y, steps.front().depthMm), filter, row);
        return;
    }
    SlabRow slab(projection, row);
    std::vector<float> values(row.size());
    for (const SlabStep& step : steps) {
        const Span pixels = readLine(grid, rows.row(y, step.depthMm), filter, values);
        slab.add(pixels, values, step.weight);
    }
    slab.finish();
}

}  // namespace

SampledSlice sampleSlice(const Volume& volume, const SliceFrame& frame, const Slab& slab, Filter filter,
                         const std::function<bool()>& cancelled) {
    const glm::ivec2 size = frame.sizePx;
    if (size.x < 1 || size.y < 1 || double(size.x) * double(size.y) > kMostSlicePixels) return {};
    const auto width = static_cast<std::size_t>(size.x);
    const auto height = static_cast<std::size_t>(size.y);
    SampledSlice slice{.sizePx = size, .values = std::vector<float>(width * height, kNoValue)};
    if (!frame.isUsable()) return slice;

    const Rows rows(volume, frame);
    const std::vector<SlabStep> steps = stepsThrough(volume, frame.plane, slab.thicknessMm);
    const CancelToken token;
    const auto read = [&](const auto& grid) {
        const auto readOne = [&](std::size_t y) {
            if (cancelled && cancelled()) {
                token.cancel();
                return;
            }
            readRow(grid, rows, y, steps, slab.projection, filter,
                    std::span(slice.values).subspan(y * width, width));
        };
        parallelFor(height, readOne, token);
    };
    if (volume.format() == VoxelFormat::float32)
        read(VoxelGrid<FloatVoxels>(volume));
    else
        read(VoxelGrid<StoredVoxels>(volume));
    if (token.cancelled()) return {};
    return slice;
}

std::optional<Probe> probe(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 at = VoxelPlaces(volume).ofPoint(mm);
    if (!boundsOf(volume.size()).contain(at)) return std::nullopt;
    const glm::ivec3 voxel = nearestVoxel(at, volume.size());
    return Probe{.voxel = voxel,
                 .value = volume.value(voxel.x, voxel.y, voxel.z),
                 .isPadding = volume.isPadding(voxel.x, voxel.y, voxel.z),
                 .isInterpolated = isInterpolated(volume, voxel.z)};
}

}  // namespace macula::slices
