#include "base/frames.h"

#include <algorithm>
#include <cmath>

#include "base/is_finite.h"

namespace macula {

std::array<glm::dvec3, 8> cornersOf(const Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = {(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                      (i & 4) != 0 ? box.high.z : box.low.z};
    }
    return corners;
}

glm::dmat4 affine(const glm::dvec3& columnI, const glm::dvec3& columnJ, const glm::dvec3& columnK,
                  const glm::dvec3& origin) {
    return {glm::dvec4(columnI, 0.0), glm::dvec4(columnJ, 0.0), glm::dvec4(columnK, 0.0),
            glm::dvec4(origin, 1.0)};
}

bool isInvertibleAffine(const glm::dmat4& transform) {
    if (!isFinite(transform)) return false;
    const glm::dvec3 lengths{glm::length(glm::dvec3(transform[0])), glm::length(glm::dvec3(transform[1])),
                             glm::length(glm::dvec3(transform[2]))};
    if (!(lengths.x > 0.0 && lengths.y > 0.0 && lengths.z > 0.0)) return false;
    // Scale-free: the volume spanned by the three directions, 1 when they are orthogonal.
    const glm::dmat3 directions{glm::dvec3(transform[0]) / lengths.x, glm::dvec3(transform[1]) / lengths.y,
                                glm::dvec3(transform[2]) / lengths.z};
    return std::abs(glm::determinant(directions)) > 1e-6;
}

std::string orientationLetters(const glm::dvec3& directionLps) {
    constexpr double kNegligible = 1e-4;
    struct Part {
        double size;
        char letter;
    };
    std::array<Part, 3> parts{{{std::abs(directionLps.x), directionLps.x > 0 ? 'L' : 'R'},
                               {std::abs(directionLps.y), directionLps.y > 0 ? 'P' : 'A'},
                               {std::abs(directionLps.z), directionLps.z > 0 ? 'S' : 'I'}}};
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.size > b.size; });
    std::string letters;
    for (const Part& part : parts) {
        if (part.size > kNegligible) letters += part.letter;
    }
    return letters;
}

}  // namespace macula
