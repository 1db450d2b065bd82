#include "pipeline/volume/visible_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/check.h"
#include "base/parallel.h"

namespace macula {

namespace {

constexpr double kLeastDepth = 0.1;  // optical; less is no outline
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

    // Where along an axis the row through `voxel` begins to be seen, from its low end (`step` 1) or its high
    // end (-1).
    std::optional<double> end(glm::ivec3 voxel, int axis, int step) const {
        const int count = volume_.size()[axis];
        const double stepMm = glm::length(glm::dvec3(volume_.worldFromVoxel()[axis]));
        double depth = 0.0;
        std::optional<double> begin;
        for (int i = step > 0 ? 0 : count - 1; i >= 0 && i < count; i += step) {
            voxel[axis] = i;
            if (!maySee(voxel)) {
                const int brick = (i + 1) / kBrickVoxels;
                i = brick * kBrickVoxels +
                    (step > 0 ? kBrickVoxels - 2 : -1);  // the last one of it on the way
                begin.reset();
                depth = 0.0;
                continue;
            }
            const double extinction = extinctionAt(voxel);
            if (extinction < leastPerMm_) {
                begin.reset();
                depth = 0.0;
                continue;
            }
            if (!begin) begin = borderBefore(voxel, axis, step);
            depth += extinction * stepMm;
            if (depth >= kLeastDepth) return begin;
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
    // The extinction per mm, linear between the entries.
    double extinctionOf(double entry) const {
        if (entry > opaqueFrom_) return 1e9;
        const auto low = static_cast<std::size_t>(entry);
        const double part = entry - double(low);
        return double(medium_.extinctionPerMm[low]) * (1.0 - part) +
               double(medium_.extinctionPerMm[low + 1]) * part;
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
        const double extinction = extinctionOf(entryOf(voxel)) + secondAt(glm::dvec3(voxel));
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
        double hidden = 0.0;
        double seen = 1.0;
        for (int i = 0; i < kBisections; ++i) {
            const double part = 0.5 * (hidden + seen);
            glm::dvec3 at(before);
            at[axis] += part * step;
            const double extinction = extinctionOf(from + (to - from) * part) + secondAt(at);
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

// Adds the ends of all rows along `axis` in the plane `normal` = index.
void addEnds(const Rows& rows, const glm::ivec3& size, int axis, int normal, int index,
             std::vector<glm::dvec2>& ends) {
    const int other = 3 - axis - normal;
    for (int i = 0; i < size[other]; ++i) {
        glm::ivec3 voxel(0);
        voxel[normal] = index;
        voxel[other] = i;
        for (const int step : {1, -1}) {
            const std::optional<double> at = rows.end(voxel, axis, step);
            if (!at) break;
            glm::dvec3 point(voxel);
            point[axis] = *at;
            ends.emplace_back(point[normal == 0 ? 1 : 0], point[normal == 2 ? 1 : 2]);
        }
    }
}

}  // namespace

std::vector<glm::dvec3> visibleHullMm(const Volume& volume, const BrickGrid& grid, const Medium& medium,
                                      const Clip& clip, const MaskBits* mask, const Additions& additions) {
    MACULA_CHECK_EQ(medium.bounds.size(), grid.ranges.size());
    const Rows rows(volume, grid, medium, clip, mask, additions);
    const glm::ivec3 size = volume.size();
    // Slices hold the rows of two axes, the planes across j those of the third.
    std::vector<std::vector<glm::dvec3>> hulls(std::size_t(size.z) + std::size_t(size.y));
    parallelFor(hulls.size(), [&](std::size_t plane) {
        const bool isSlice = plane < std::size_t(size.z);
        const int index = static_cast<int>(isSlice ? plane : plane - std::size_t(size.z));
        std::vector<glm::dvec2> ends;
        if (isSlice) {
            addEnds(rows, size, 0, 2, index, ends);
            addEnds(rows, size, 1, 2, index, ends);
        } else {
            addEnds(rows, size, 2, 1, index, ends);
        }
        for (const glm::dvec2& p : convexHull(std::move(ends)))
            hulls[plane].push_back(
                transformPoint(volume.worldFromVoxel(),
                               isSlice ? glm::dvec3(p.x, p.y, index) : glm::dvec3(p.x, index, p.y)));
    });
    std::vector<glm::dvec3> points;
    for (const auto& hull : hulls) points.insert(points.end(), hull.begin(), hull.end());
    return points;
}

}  // namespace macula
