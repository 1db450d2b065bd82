#include "slices/interpolated.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <variant>

namespace macula::slices {

namespace {

// A linear function of a place in the picture: at + along · px.
struct Linear {
    double at = 0.0;
    glm::dvec2 along{0.0};

    double operator()(const glm::dvec2& px) const { return at + glm::dot(along, px); }
};

// The voxel coordinates of places in the picture.
std::array<Linear, 3> voxelFromPicture(const Volume& volume, const SliceFrame& frame) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const auto at = [&](const glm::dvec2& px) {
        return transformPoint(voxelFromWorld, frame.worldFromPicture(px));
    };
    const glm::dvec3 corner = at({0.0, 0.0});
    const glm::dvec3 right = at({1.0, 0.0}) - corner;
    const glm::dvec3 down = at({0.0, 1.0}) - corner;
    std::array<Linear, 3> axes;
    for (int axis = 0; axis < 3; ++axis) axes[std::size_t(axis)] = {corner[axis], {right[axis], down[axis]}};
    return axes;
}

// Cuts `line` to the part where the function is within the bounds; false if nothing is left.
bool clip(PictureLine& line, const Linear& function, double low, double high) {
    const double from = function(line.from);
    const double to = function(line.to);
    double first = 0.0;
    double last = 1.0;
    if (from == to) return from >= low && from <= high;
    const double a = (low - from) / (to - from);
    const double b = (high - from) / (to - from);
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
    if (!(first < last)) return false;
    const glm::dvec2 along = line.to - line.from;
    line = {line.from + first * along, line.from + last * along};
    return true;
}

std::optional<PictureLine> lineAt(double slice, const std::array<Linear, 3>& voxel, const glm::ivec3& size,
                                  const glm::ivec2& sizePx) {
    const Linear& k = voxel[2];
    const double steepness = glm::dot(k.along, k.along);
    // From the line's point nearest to the middle of the picture, far enough to both sides to cross the
    // picture.
    const glm::dvec2 middle = glm::dvec2(sizePx) / 2.0;
    const glm::dvec2 on = middle + k.along * ((slice - k(middle)) / steepness);
    const glm::dvec2 direction = glm::dvec2(-k.along.y, k.along.x) / std::sqrt(steepness);
    const double reach = glm::length(glm::dvec2(sizePx));
    PictureLine line{on - reach * direction, on + reach * direction};
    const bool isSeen = clip(line, {0.0, {1.0, 0.0}}, 0.0, sizePx.x) &&
                        clip(line, {0.0, {0.0, 1.0}}, 0.0, sizePx.y) &&
                        clip(line, voxel[0], -0.5, size.x - 0.5) && clip(line, voxel[1], -0.5, size.y - 0.5);
    return isSeen ? std::optional(line) : std::nullopt;
}

}  // namespace

bool isInterpolated(const Volume& volume, int slice) {
    return std::ranges::any_of(volume.provenance().interpolatedSlices, [slice](const SliceRange& range) {
        return range.first <= slice && slice <= range.last;
    });
}

std::vector<SliceRange> interpolatedIn(const Volume& volume, const SliceFrame& frame, const Slab& slab) {
    std::vector<SliceRange> met;
    if (volume.provenance().interpolatedSlices.empty() || !frame.isUsable()) return met;
    const Linear k = voxelFromPicture(volume, frame)[2];
    const glm::dvec2 size(frame.sizePx);
    double low = k({0.0, 0.0});
    double high = low;
    for (const glm::dvec2& corner : {glm::dvec2(size.x, 0.0), glm::dvec2(0.0, size.y), size}) {
        low = std::min(low, k(corner));
        high = std::max(high, k(corner));
    }
    if (slab.thicknessMm > 0.0) {
        const glm::dvec3 along = glm::inverse(volume.worldFromVoxel()) *
                                 glm::dvec4(frame.plane.normal() * (0.5 * slab.thicknessMm), 0.0);
        low -= std::abs(along.z);
        high += std::abs(along.z);
    }
    constexpr double kRounding = 1e-6;  // a plane between two slices is in both
    std::ranges::copy_if(
        volume.provenance().interpolatedSlices, std::back_inserter(met), [&](const SliceRange& range) {
            return range.first - 0.5 <= high + kRounding && low - kRounding <= range.last + 0.5;
        });
    return met;
}

std::vector<PictureLine> edgesOf(const SliceRange& slices, const Volume& volume, const SliceFrame& frame) {
    std::vector<PictureLine> edges;
    if (!frame.isUsable()) return edges;
    const std::array<Linear, 3> voxel = voxelFromPicture(volume, frame);
    constexpr double kLeastSlicesAcross = 1e-3;  // over the whole picture; below this it is parallel
    if (glm::length(voxel[2].along) * glm::length(glm::dvec2(frame.sizePx)) < kLeastSlicesAcross)
        return edges;
    for (const double at : {slices.first - 0.5, slices.last + 0.5}) {
        if (const auto line = lineAt(at, voxel, volume.size(), frame.sizePx)) edges.push_back(*line);
    }
    return edges;
}

double interpolatedShare(const Measurement& measurement, const Volume& volume) {
    if (volume.provenance().interpolatedSlices.empty()) return 0.0;
    if (hasArea(measurement)) {
        const auto values = valuesIn(measurement, volume);
        return values ? double(values->interpolated) / double(values->voxels) : 0.0;
    }
    const std::vector<glm::dvec3> points = pointsOf(measurement);
    if (points.empty()) return 0.0;
    const auto within = std::ranges::count_if(points, [&](const glm::dvec3& mm) {
        const auto there = probe(volume, mm);
        return there && there->isInterpolated;
    });
    return double(within) / double(points.size());
}

}  // namespace macula::slices
