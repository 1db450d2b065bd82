// What of an eye's picture cannot be seen through the lens, and so need not be drawn. Knows no OpenXR.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "xr/eyes.h"

namespace macula::xr {

// Triangles at distance 1 from the eye, as tangents: right and up are positive.
class VisibilityMask {
  public:
    VisibilityMask() = default;  // all can be seen
    // Each three of `indices` name a triangle that cannot be seen. Where these are not triangles, or a corner
    // is no place, all can be seen: too much is drawn, and nothing missed.
    VisibilityMask(std::vector<glm::dvec2> corners, std::span<const std::uint32_t> indices);

    bool isEmpty() const { return triangles_.empty(); }

    // The eye with its sides moved in to what can be seen; as it is where nothing can.
    Eye visiblePartOf(const Eye& eye) const;

    // Of a picture of what the eye sees, of that size: of each row, from the first pixel to behind the last
    // whose middle can be seen; {0, 0} where none can.
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

// Parts of a picture, with nothing but what is outside of them hidden: rows of a band have one width. Few, so
// that a copy has few pieces.
struct VisiblePart {
    glm::ivec2 firstPx{0};
    glm::ivec2 sizePx{0};
    bool operator==(const VisiblePart&) const = default;
};
std::vector<VisiblePart> bandsOf(std::span<const VisibilityMask::Run> rows, int rowsOfBand = 8);

}  // namespace macula::xr
