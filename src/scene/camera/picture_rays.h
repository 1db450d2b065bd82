// From places in a picture to the rays of its camera, and back. Who needs one or the other asks here. World
// frame: patient LPS, mm.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"

namespace macula::app {

struct PictureRay {
    glm::dvec3 originMm{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};  // unit
    bool beginsThere = true;  // at an eye; one of parallel rays shows what is behind its origin, too

    glm::dvec3 at(double mm) const { return originMm + mm * direction; }
};

// Places are measured from the middle of the picture, right and up positive: in half heights where it says
// so, and else from -1 to 1 on both sides, as the window tells them.
class PictureRays {
  public:
    // Nothing for a camera that is none (basis()) or an aspect that is not above 0.
    static std::optional<PictureRays> of(const Camera& camera, double aspectWidthOverHeight);

    PictureRay through(const glm::dvec2& place) const;
    // Nothing of what is not in front of the eye; parallel rays have none.
    std::optional<glm::dvec2> placeOf(const glm::dvec3& mm) const;

    // In half heights after division by z, which is above 0 in front of the eye alone, and everywhere of
    // parallel rays. Linear in the point, so that who walks along a line may add `homogeneousStep` of the
    // way.
    glm::dvec3 homogeneous(const glm::dvec3& mm) const;
    glm::dvec3 homogeneousStep(const glm::dvec3& byMm) const;

    glm::dvec2 halfHeights(const glm::dvec2& place) const { return {place.x * aspect_, place.y}; }
    const CameraBasis& axes() const { return axes_; }

  private:
    PictureRays(const Camera& camera, const CameraBasis& axes, double aspect);

    glm::dvec3 originMm_;  // the eye
    CameraBasis axes_;
    bool isParallel_;
    double halfHeight_;  // of the picture, at a distance of 1; of parallel rays in mm, everywhere
    double aspect_;
};

// The point of a line that is nearest to a ray, in units of `direction` from `pointMm`. Nothing where they
// are as good as parallel, or the nearest point lies before the ray begins.
std::optional<double> nearestOnLine(const PictureRay& ray, const glm::dvec3& pointMm,
                                    const glm::dvec3& direction);

// Where the ray meets the plane through that point. Nothing where it does not, or grazes it.
std::optional<glm::dvec3> meets(const PictureRay& ray, const glm::dvec3& pointMm, const glm::dvec3& normal);

}  // namespace macula::app
