#include "pipeline/volume/visible_hull.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/volume/voxel_gradient.h"

namespace macula {

namespace {

constexpr double kLeastDepth = 0.1;  // optical depth; a run with less does not count
constexpr int kNowhere = -1;         // no index in a row
constexpr int kBisections = 10;      // to a thousandth of a voxel

double cross(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Andrew's monotone chain.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    if (points.size() < 3) return points;
    std::vector<glm::dvec2> hull;
    const auto add = [&hull](const glm::dvec2& point, std::size_t keep) {
        while (hull.size() >= keep + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0.0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const glm::dvec2& point : points) add(point, 0);
    const std::size_t lower = hull.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, lower);
    return hull;
}

class Rows {
  public:
    Rows(const Volume& volume, const BrickGrid& grid, const Medium& medium, const Clip& clip,
         const MaskBits* mask, const Additions& additions)
        : volume_(volume),
          grid_(grid),
          medium_(medium),
          clip_(clip),
          mask_(mask),
          map_(entryMapOf(volume)),
          leastPerMm_(kLeastDepth / volume.worldBox().diagonal()),
          opaqueFrom_(std::numeric_limits<double>::infinity()) {
        if (additions.second) second_.emplace(*additions.second, volume);
        if (!clip.greyFaces || !clip.hasShape()) return;
        const UnitsFromStored units = volume.unitsFromStored();
        const double low = clip.greyFaces->center - 0.5 * clip.greyFaces->width;
        opaqueFrom_ = clip.facesBelowWindowAreBlack ? -1.0 : (low - units.intercept) / units.slope - map_.low;
    }

    // Where on an axis visible matter begins in the row through `voxel`, from its low end (`step` 1) or its
    // high end (-1). Nothing if it does not begin before the place `known` on the axis.
    std::optional<double> end(glm::ivec3 voxel, int axis, int step, double known) const {
        const int count = volume_.size()[axis];
        const double stepMm = glm::length(glm::dvec3(volume_.worldFromVoxel()[axis]));
        double depth = 0.0;
        int begin = kNowhere;
        for (int i = step > 0 ? 0 : count - 1; i >= 0 && i < count; i += step) {
            if (begin == kNowhere && (i - step - known) * step >= 0.0) return std::nullopt;
            voxel[axis] = i;
            if (!maySee(voxel)) {
                const int brick = (i + 1) / kBrickVoxels;
                i = brick * kBrickVoxels + (step > 0 ? kBrickVoxels - 2 : -1);  // the last voxel of the brick
                begin = kNowhere;
                depth = 0.0;
                continue;
            }
            const double extinction = extinctionAt(voxel);
            if (extinction < leastPerMm_) {
                begin = kNowhere;
                depth = 0.0;
                continue;
            }
            if (begin == kNowhere) begin = i;
            depth += extinction * stepMm;
            if (depth < kLeastDepth) continue;
            voxel[axis] = begin;
            return borderBefore(voxel, axis, step);
        }
        return std::nullopt;
    }

  private:
    bool maySee(const glm::ivec3& voxel) const {
        const glm::ivec3 at = (voxel + 1) / kBrickVoxels;
        const std::size_t brick = grid_.index(at.x, at.y, at.z);
        return medium_.bounds[brick] > 0.0f || double(grid_.ranges[brick].high) > opaqueFrom_;
    }
    double entryOf(const glm::ivec3& voxel) const {
        return double(map_.entryOf(volume_.stored(voxel.x, voxel.y, voxel.z)));
    }
    // The extinction per mm, linear between the entries, of matter of which `steepPart()` is steep. Calls
    // steepPart() only if it matters, because it reads six voxels.
    template <class SteepPart>
    double extinctionOf(double entry, const SteepPart& steepPart) const {
        if (entry > opaqueFrom_) return 1e9;
        const auto low = static_cast<std::size_t>(entry);
        const double part = entry - double(low);
        const double usual = double(medium_.extinctionPerMm[low]) * (1.0 - part) +
                             double(medium_.extinctionPerMm[low + 1]) * part;
        if (medium_.steep.empty()) return usual;
        const double steep = std::lerp(double(medium_.steep[low].w), double(medium_.steep[low + 1].w), part);
        return steep == usual ? usual : std::lerp(usual, steep, steepPart());
    }
    double steepPartOf(const glm::ivec3& voxel) const {
        if (medium_.steep.empty()) return 0.0;
        return steepPart(gradientPerMmAt(volume_, map_, voxel), medium_.steepGradientPerMm);
    }
    bool isShown(const glm::dvec3& voxel) const {
        if (mask_ != nullptr) {
            const glm::ivec3 nearest(glm::round(voxel));
            if (!mask_->shows(nearest.x, nearest.y, nearest.z)) return false;
        }
        return !clip_.hasShape() || shows(clip_, transformPoint(volume_.worldFromVoxel(), voxel));
    }
    double secondAt(const glm::dvec3& voxel) const { return second_ ? second_->at(voxel) : 0.0; }
    double extinctionAt(const glm::ivec3& voxel) const {
        const double extinction =
            extinctionOf(entryOf(voxel), [&] { return steepPartOf(voxel); }) + secondAt(glm::dvec3(voxel));
        return extinction < leastPerMm_ || isShown(glm::dvec3(voxel)) ? extinction : 0.0;
    }
    // The place of the border between a visible voxel and the one before it, which is not visible or does not
    // exist.
    double borderBefore(const glm::ivec3& voxel, int axis, int step) const {
        glm::ivec3 before = voxel;
        before[axis] -= step;
        if (before[axis] < 0 || before[axis] >= volume_.size()[axis]) return voxel[axis] - 0.5 * step;
        const double from = entryOf(before);
        const double to = entryOf(voxel);
        const double steepFrom = steepPartOf(before);
        const double steepTo = steepPartOf(voxel);
        double hidden = 0.0;
        double seen = 1.0;
        for (int i = 0; i < kBisections; ++i) {
            const double part = 0.5 * (hidden + seen);
            glm::dvec3 at(before);
            at[axis] += part * step;
            const double extinction =
                extinctionOf(from + (to - from) * part, [&] { return std::lerp(steepFrom, steepTo, part); }) +
                secondAt(at);
            const bool isSeen = extinction >= leastPerMm_ && isShown(at);
            (isSeen ? seen : hidden) = part;
        }
        return before[axis] + seen * step;
    }

    const Volume& volume_;
    const BrickGrid& grid_;
    const Medium& medium_;
    const Clip& clip_;
    const MaskBits* mask_;
    EntryMap map_;
    std::optional<SecondExtinction> second_;
    double leastPerMm_;  // extinction that would not be visible even if it were everywhere
    double opaqueFrom_;  // above this entry there may be a face of the clip
};

// The ends of matter in a row, in voxels; none if the low end is above the high one.
struct Ends {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool areThere() const { return low <= high; }
};

// Where the vertical line at `x` cuts a convex polygon.
Ends cutAt(const std::vector<glm::dvec2>& polygon, double x) {
    Ends cut;
    const auto add = [&cut](double y) {
        cut.low = std::min(cut.low, y);
        cut.high = std::max(cut.high, y);
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
        if (a.x == x) add(a.y);
        if ((a.x - x) * (b.x - x) < 0.0) add(a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y));
    }
    return cut;
}

// The ends of the rows along x of one plane, by their second coordinate in that plane.
using RowsAlongX = std::vector<Ends>;
std::vector<glm::dvec2> hullOf(const RowsAlongX& rows) {
    std::vector<glm::dvec2> points;
    for (std::size_t place = 0; place < rows.size(); ++place) {
        if (!rows[place].areThere()) continue;
        points.emplace_back(rows[place].low, place);
        points.emplace_back(rows[place].high, place);
    }
    return convexHull(std::move(points));
}

// The convex hull of `hull` and the ends of the plane's rows along its second coordinate, which is `axis` of
// the volume; `first` is the first voxel of the plane. A row is searched only up to the hull: an end inside
// the hull does not change it.
std::vector<glm::dvec2> widened(const std::vector<glm::dvec2>& hull, const Rows& rows,
                                const glm::ivec3& first, int axis, int columns) {
    std::vector<glm::dvec2> points = hull;
    for (int x = 0; x < columns; ++x) {
        const Ends known = cutAt(hull, x);
        const glm::ivec3 voxel(x, first.y, first.z);
        const std::optional<double> low = rows.end(voxel, axis, 1, known.low);
        if (!low && !known.areThere()) continue;  // nothing is visible in this row
        const std::optional<double> high = rows.end(voxel, axis, -1, known.high);
        if (low) points.emplace_back(x, *low);
        if (high) points.emplace_back(x, *high);
    }
    return convexHull(std::move(points));
}

}  // namespace

std::vector<glm::dvec3> visibleHullMm(const Volume& volume, const BrickGrid& grid, const Medium& medium,
                                      const Clip& clip, const MaskBits* mask, const Additions& additions) {
    MACULA_CHECK_EQ(medium.bounds.size(), grid.ranges.size());
    const Rows rows(volume, grid, medium, clip, mask, additions);
    const glm::ivec3 size = volume.size();
    // Slices give the rows along x, which are contiguous in memory, and those along y; planes of constant y
    // give those along z.
    std::vector<RowsAlongX> alongX(std::size_t(size.z), RowsAlongX(std::size_t(size.y)));
    std::vector<std::vector<glm::dvec3>> hulls(std::size_t(size.z) + std::size_t(size.y));
    const auto keep = [&](std::size_t plane, const glm::dvec3& voxel) {
        hulls[plane].push_back(transformPoint(volume.worldFromVoxel(), voxel));
    };
    parallelFor(std::size_t(size.z), [&](std::size_t z) {
        for (int y = 0; y < size.y; ++y) {
            const glm::ivec3 first(0, y, int(z));
            const std::optional<double> low = rows.end(first, 0, 1, std::numeric_limits<double>::infinity());
            if (!low) continue;
            const std::optional<double> high =
                rows.end(first, 0, -1, -std::numeric_limits<double>::infinity());
            if (high) alongX[z][std::size_t(y)] = {*low, *high};
        }
        for (const glm::dvec2& p : widened(hullOf(alongX[z]), rows, {0, 0, int(z)}, 1, size.x))
            keep(z, {p.x, p.y, double(z)});
    });
    parallelFor(std::size_t(size.y), [&](std::size_t y) {
        RowsAlongX ends;
        for (const RowsAlongX& slice : alongX) ends.push_back(slice[y]);
        for (const glm::dvec2& p : widened(hullOf(ends), rows, {0, int(y), 0}, 2, size.x))
            keep(std::size_t(size.z) + y, {p.x, double(y), p.y});
    });
    std::vector<glm::dvec3> points;
    for (const auto& hull : hulls) points.insert(points.end(), hull.begin(), hull.end());
    return points;
}

}  // namespace macula
