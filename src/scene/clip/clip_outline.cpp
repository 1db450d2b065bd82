#include "scene/clip/clip_outline.h"

#include <array>
#include <cmath>

#include "base/camera.h"
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

constexpr int kDotsOfEdge = 5;  // between its ends

// Without a dot at `b`, where the next edge begins.
void addEdge(std::vector<glm::dvec3>& dots, const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i <= kDotsOfEdge; ++i) dots.push_back(a + double(i) / (kDotsOfEdge + 1) * (b - a));
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

std::vector<glm::dvec3> dotsOfBox(const Box& box) {
    std::vector<glm::dvec3> dots;
    const std::array<glm::dvec3, 8> corners = cornersOf(box);
    for (std::size_t a = 0; a < corners.size(); ++a) {
        for (std::size_t b = a + 1; b < corners.size(); ++b) {
            const glm::dvec3 apart = corners[b] - corners[a];
            if (int(apart.x != 0.0) + int(apart.y != 0.0) + int(apart.z != 0.0) == 1)
                addEdge(dots, corners[a], corners[b]);
        }
    }
    dots.push_back(box.high);
    return dots;
}

std::vector<glm::dvec3> dotsOfPlane(const HalfSpace& plane, const Box& box) {
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 other = std::abs(n.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, n));
    const std::vector<glm::dvec3> outline =
        outlineMm(box, {.centreMm = plane.offsetMm * n, .right = right, .down = glm::cross(n, right)});
    std::vector<glm::dvec3> dots;
    for (std::size_t i = 0; i < outline.size(); ++i)
        addEdge(dots, outline[i], outline[(i + 1) % outline.size()]);
    return dots;
}

}  // namespace macula::scene
