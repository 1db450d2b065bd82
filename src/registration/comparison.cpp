#include "registration/comparison.h"

#include <glm/gtc/matrix_transform.hpp>

namespace macula::registration {

namespace {

constexpr double kLeverMm = 100.0;  // rotations are measured in mm at this radius

}  // namespace

glm::dmat4 transformOf(const Parameters& p, const glm::dvec3& middleMm) {
    const glm::dvec3 turn = glm::dvec3(p[0], p[1], p[2]) / kLeverMm;
    const double angle = glm::length(turn);
    glm::dmat4 movingFromFixed = glm::translate(glm::dmat4(1.0), middleMm + glm::dvec3(p[3], p[4], p[5]));
    if (angle > 0.0) movingFromFixed = glm::rotate(movingFromFixed, angle, turn / angle);
    return glm::translate(movingFromFixed, -middleMm);
}

}  // namespace macula::registration
