// The part of an eye's picture that the lens hides, and that need not be drawn. Knows no OpenXR.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "xr/eyes.h"

namespace macula::xr {

// Hidden triangles at distance 1 from the eye, as tangents: right and up are positive.
class VisibilityMask {
  public:
    VisibilityMask() = default;  // nothing is hidden
    // Each three of `indices` name a hidden triangle. If they are invalid, or a corner is not finite, hides
    // nothing: too much is drawn, but nothing is missing.
    VisibilityMask(std::vector<glm::dvec2> corners, std::span<const std::uint32_t> indices);

    bool isEmpty() const { return triangles_.empty(); }

    // The eye with its sides moved in to the visible field; unchanged if nothing would be visible.
    Eye visiblePartOf(const Eye& eye) const;

    // The visible part of each row in a picture of that size of the eye's field: from the first pixel to one
    // past the last whose centre is visible; {0, 0} if there is none.
    struct Run {
        int first = 0;
        int end = 0;
        bool operator==(const Run&) const = default;
    };
    std::vector<Run> rowsOf(const Eye& eye, const glm::ivec2& sizePx) const;

  private:
    struct Triangle {
        glm::dvec2 a, b, c;
    };
    std::vector<Triangle> triangles_;
};

// Parts of a picture that cover all visible pixels. The rows of a band have one width, so that a copy has few
// regions.
struct VisiblePart {
    glm::ivec2 firstPx{0};
    glm::ivec2 sizePx{0};
    bool operator==(const VisiblePart&) const = default;
};
std::vector<VisiblePart> bandsOf(std::span<const VisibilityMask::Run> rows, int rowsOfBand = 8);

}  // namespace macula::xr
