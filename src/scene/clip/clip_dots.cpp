#include "scene/clip/clip_dots.h"

#include <array>
#include <cmath>

#include "base/camera.h"
#include "scene/clip/clip_outline.h"

namespace macula::scene {

namespace {

constexpr int kDotsOfEdge = 5;  // between its ends

// Without a dot at `b`, where the next edge begins.
void addEdge(std::vector<glm::dvec3>& dots, const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i <= kDotsOfEdge; ++i) dots.push_back(a + double(i) / (kDotsOfEdge + 1) * (b - a));
}

}  // namespace

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
