// Converts places in a picture to the rays of its camera, and points in space to places. World frame: patient
// LPS, mm.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"

namespace macula::scene {

struct PictureRay {
    glm::dvec3 originMm{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};  // unit
    // True for an eye; a parallel ray also shows what is behind its origin.
    bool beginsThere = true;

    glm::dvec3 at(double mm) const { return originMm + mm * direction; }
};

// Places are relative to the middle of the picture, right and up positive, from -1 to 1 on both sides unless
// a comment says half heights.
class PictureRays {
  public:
    // Nothing for an invalid camera (basis()) or an aspect that is not finite and above 0.
    static std::optional<PictureRays> of(const Camera& camera, double aspectWidthOverHeight);

    PictureRay through(const glm::dvec2& place) const;
    // Nothing for a point that is not in front of the eye. Parallel rays have no eye and show every point.
    std::optional<glm::dvec2> placeOf(const glm::dvec3& mm) const;

    // x / z and y / z are the place in half heights; z is above 0 only in front of the eye, or everywhere
    // with parallel rays. Linear in the point: homogeneous(a + b) is homogeneous(a) + homogeneousStep(b).
    glm::dvec3 homogeneous(const glm::dvec3& mm) const;
    glm::dvec3 homogeneousStep(const glm::dvec3& byMm) const;

    glm::dvec2 halfHeights(const glm::dvec2& place) const { return {place.x * aspect_, place.y}; }
    const CameraBasis& axes() const { return axes_; }

  private:
    PictureRays(const Camera& camera, const CameraBasis& axes, double aspect);

    glm::dvec3 originMm_;  // the eye
    CameraBasis axes_;
    bool isParallel_;
    double halfHeight_;  // of the picture at a distance of 1; with parallel rays in mm at any depth
    double aspect_;
};

// The point of a line nearest to a ray, in units of `direction` from `pointMm`. Nothing if they are nearly
// parallel, or if the nearest point of the ray lies before its beginning.
std::optional<double> nearestOnLine(const PictureRay& ray, const glm::dvec3& pointMm,
                                    const glm::dvec3& direction);

// Where the ray meets the plane through `pointMm`. Nothing if it misses or grazes the plane.
std::optional<glm::dvec3> meets(const PictureRay& ray, const glm::dvec3& pointMm, const glm::dvec3& normal);

}  // namespace macula::scene
