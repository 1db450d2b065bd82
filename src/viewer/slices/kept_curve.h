// The curve through points, made anew only when they change.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "slices/curve.h"

namespace macula::viewer {

class KeptCurve {
  public:
    // `pointsMm` in patient LPS. Valid until the next call.
    const slices::Curve& through(const std::vector<glm::dvec3>& pointsMm) {
        if (pointsMm != pointsMm_) {
            pointsMm_ = pointsMm;
            curve_ = slices::Curve(pointsMm);
        }
        return curve_;
    }

  private:
    std::vector<glm::dvec3> pointsMm_;
    slices::Curve curve_{{}};
};

}  // namespace macula::viewer
