#include "scene/clip/clip_outline.h"

#include <cmath>

#include "base/is_finite.h"

namespace macula::scene {

namespace {

using Polygon = std::vector<glm::dvec3>;

constexpr double kSamePoint = 1e-9;  // in diagonals of the box
constexpr double kNoArea = 1e-12;    // in squared diagonals

// One step of Sutherland-Hodgman clipping: the part of the polygon on the inner side of one face.
Polygon within(const Polygon& polygon, const Box& box, Face face) {
    const int axis = axisOf(face);
    const double faceAt = faceMm(box, face);
    const auto depth = [&](const glm::dvec3& p) {
        return isHigh(face) ? faceAt - p[axis] : p[axis] - faceAt;
    };
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double depthA = depth(a);
        const double depthB = depth(b);
        if (depthA >= 0.0) kept.push_back(a);
        if ((depthA >= 0.0) == (depthB >= 0.0)) continue;
        glm::dvec3 crossing = a + (depthA / (depthA - depthB)) * (b - a);
        crossing[axis] = faceAt;
        kept.push_back(crossing);
    }
    return kept;
}

Polygon withoutRepeats(const Polygon& polygon, double nearMm) {
    Polygon kept;
    for (const glm::dvec3& p : polygon) {
        if (kept.empty() || glm::length(p - kept.back()) > nearMm) kept.push_back(p);
    }
    while (kept.size() > 1 && glm::length(kept.front() - kept.back()) <= nearMm) kept.pop_back();
    return kept;
}

double areaOf(const Polygon& polygon) {
    glm::dvec3 twice(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * glm::length(twice);
}

}  // namespace

std::vector<glm::dvec3> outlineMm(const Box& box, const slices::SlicePlane& plane) {
    const double diagonal = box.diagonal();
    if (!std::isfinite(diagonal) || !isFinite(plane.centreMm) || !isFinite(plane.right) ||
        !isFinite(plane.down) || !glm::all(glm::lessThan(box.low, box.high)))
        return {};
    // A square in the plane, large enough to cover the box.
    const glm::dvec3 toBox = box.centre() - plane.centreMm;
    const glm::dvec3 centre = plane.centreMm + glm::dot(toBox, plane.right) * plane.right +
                              glm::dot(toBox, plane.down) * plane.down;
    const glm::dvec3 right = diagonal * plane.right;
    const glm::dvec3 down = diagonal * plane.down;
    Polygon polygon{centre - right - down, centre + right - down, centre + right + down,
                    centre - right + down};
    for (const Face face : kFaces) polygon = within(polygon, box, face);
    polygon = withoutRepeats(polygon, kSamePoint * diagonal);
    if (!(areaOf(polygon) > kNoArea * diagonal * diagonal)) return {};
    return polygon;
}

std::vector<glm::dvec3> keptOutlineMm(const OptionalClip& clip, const Volume& volume,
                                      const slices::SlicePlane& plane) {
    const Result<Box> kept = keptBox(clip, volume);
    const Box all = volume.worldBox();
    if (!kept || (kept->low == all.low && kept->high == all.high)) return {};
    return outlineMm(*kept, plane);
}

}  // namespace macula::scene
