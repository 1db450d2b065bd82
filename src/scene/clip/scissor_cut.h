// What an outline over a picture cuts out of a volume. World frame: patient LPS, mm.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "scene/camera/picture_rays.h"
#include "scene/clip/cuts.h"

namespace macula::app {

// usage for a camera that is none, for fewer than three points or too many, numbers that are not finite, and
// an outline that encloses nothing.
Result<void> validate(const ScissorCut& cut);

// The outline with as few points as keep it within `offHalfHeights` of what was drawn, and at most
// kMostOutlinePoints.
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& outline, double offHalfHeights);

// A cut, ready to be asked for many points. A point is within the outline where it winds around it, however
// often: a loop drawn twice encloses what it encloses.
class ScissorBlades {
  public:
    // The cut must be valid.
    explicit ScissorBlades(const ScissorCut& cut);

    // By PictureRays::homogeneous of the point: what is not in front of the eye is not within the outline.
    bool removes(const glm::dvec3& homogeneous) const;
    bool removesPoint(const glm::dvec3& mm) const { return removes(rays_.homogeneous(mm)); }

    // Of a straight way from one to the other: nothing of it is within the outline, for certain.
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
    glm::dvec2 low_{0.0};  // around the outline
    glm::dvec2 high_{0.0};
    std::vector<std::vector<Edge>> rows_;  // the edges that each strip of the outline's height meets
};

}  // namespace macula::app
