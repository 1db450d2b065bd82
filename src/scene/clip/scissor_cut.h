// What an outline over a picture cuts out of a volume. World frame: patient LPS, mm.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "scene/camera/picture_rays.h"
#include "scene/clip/cuts.h"

namespace macula::scene {

// usage for an invalid camera, fewer than three or more than kMostOutlinePoints points, numbers that are not
// finite, and an outline without width or height.
Result<void> validate(const ScissorCut& cut);

// The outline simplified by Douglas-Peucker to within `offHalfHeights` of what was drawn; the tolerance
// doubles until at most kMostOutlinePoints are left.
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& outline, double offHalfHeights);

// A cut prepared for tests of many points. A point is within the outline by the nonzero winding rule: a loop
// drawn twice still encloses its inside.
class ScissorBlades {
  public:
    // The cut must be valid.
    explicit ScissorBlades(const ScissorCut& cut);

    // Takes PictureRays::homogeneous of the point. A point not in front of the eye is not within the outline.
    bool removes(const glm::dvec3& homogeneous) const;
    bool removesPoint(const glm::dvec3& mm) const { return removes(rays_.homogeneous(mm)); }

    // If true, the outline encloses no point of the straight line between the two; if false, it may still
    // enclose none, because this tests bounding boxes.
    bool isClearOf(const glm::dvec3& fromHomogeneous, const glm::dvec3& toHomogeneous) const;

    const PictureRays& rays() const { return rays_; }
    bool removesOutside() const { return removesOutside_; }

  private:
    struct Edge {
        glm::dvec2 a;
        glm::dvec2 b;
    };
    bool isWithin(const glm::dvec2& place) const;

    PictureRays rays_;
    bool removesOutside_;
    glm::dvec2 low_{0.0};  // bounding box of the outline
    glm::dvec2 high_{0.0};
    std::vector<std::vector<Edge>> rows_;  // the edges in each horizontal strip of the outline
};

}  // namespace macula::scene
