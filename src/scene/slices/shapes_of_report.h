// The shapes that reports draw, as measurements on slices. Only for measurements_of_report.cpp.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "slices/measurement.h"

namespace macula::scene {

// Why a shape is left out.
enum class WhyLeftOut { elsewhere, notPlaced, notRead, otherShape };

struct DrawnShape {
    std::string type;                      // Graphic Type, such as "POLYLINE"
    std::vector<glm::dvec3> pointsMm;      // patient LPS
    std::vector<glm::dvec3> shortAxisMm;   // where the points are the long axis of a lesion; else none
    std::optional<glm::dvec3> normal;      // of the image that they lie on, if they lie on one
    bool hasAngle = false;                 // one of its numbers is an angle
    bool isCobb = false;                   // and called a Cobb angle
    bool hasLength = false;                // one of its numbers is a length
    std::vector<glm::dvec3> usualNormals;  // of planes that people look at, the likeliest first; at least one
};

// Without a label. Points that are not finite, farther than a km, or that enclose nothing are `notRead`.
std::variant<slices::Measurement, WhyLeftOut> measurementOf(const DrawnShape& drawn);

// Whether both have the same shape and points, to a micrometre; an ellipse, whichever of its axes is called
// right.
bool isSame(const slices::Measurement& a, const slices::Measurement& b);

}  // namespace macula::scene
