// Polygons in the picture of a slice, and what half-spaces cut off them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "pipeline/volume/clip.h"
#include "slices/slice_plane.h"

namespace macula::scene {

using Contour = std::vector<glm::dvec2>;  // closed; in pixels

// The signed distance of a half-space as a linear function of the pixel: positive where the half-space keeps.
class SideInPicture {
  public:
    SideInPicture(const HalfSpace& side, const slices::SliceFrame& frame)
        : atOrigin_(glm::dot(side.normal, frame.worldFromPicture({0.0, 0.0})) - side.offsetMm),
          perPixel_(
              glm::dvec2(glm::dot(side.normal, frame.plane.right), glm::dot(side.normal, frame.plane.down)) *
              frame.mmPerPixel) {}

    double operator()(const glm::dvec2& px) const { return atOrigin_ + glm::dot(perPixel_, px); }

  private:
    double atOrigin_;
    glm::dvec2 perPixel_;
};

// One step of Sutherland-Hodgman clipping: the part of the polygon where `inside` is not below 0.
template <class Point, class Inside>
std::vector<Point> within(const std::vector<Point>& polygon, const Inside& inside) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const double atA = inside(a);
        const double atB = inside(b);
        if (atA >= 0.0) kept.push_back(a);
        if ((atA >= 0.0) != (atB >= 0.0)) kept.push_back(a + (atA / (atA - atB)) * (b - a));
    }
    return kept;
}

Contour pictureOf(const slices::SliceFrame& frame);

// The part of the polygon that all half-spaces keep.
Contour withinAll(Contour polygon, std::span<const HalfSpace> sides, const slices::SliceFrame& frame);

// What is removed of the picture if the inside, or the outside, of their intersection is kept.
std::vector<Contour> removedBySides(std::span<const HalfSpace> sides, Keep keep,
                                    const slices::SliceFrame& frame);

// The polygon as a line that ends where it begins; empty if it is none.
Contour closedLine(Contour polygon);

}  // namespace macula::scene
