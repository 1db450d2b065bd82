#include "scene/slices/shapes_of_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/is_finite.h"
#include "scene/state/measurements_json.h"
#include "slices/outline.h"

namespace macula::scene {

namespace {

using slices::Measurement;
using Made = std::variant<Measurement, WhyLeftOut>;

constexpr double kFarthestMm = 1e6;
constexpr double kSameMm = 1e-3;

bool areUsable(const std::vector<glm::dvec3>& pointsMm) {
    return std::ranges::all_of(pointsMm, [](const glm::dvec3& mm) {
        return isFinite(mm) && std::abs(mm.x) <= kFarthestMm && std::abs(mm.y) <= kFarthestMm &&
               std::abs(mm.z) <= kFarthestMm;
    });
}

bool areApart(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) > kSameMm;
}

// Of the plane with a line in space that is nearest to one that people look at.
glm::dvec3 normalBeside(const glm::dvec3& line, const DrawnShape& drawn) {
    const glm::dvec3 along = glm::normalize(line);
    const auto nearest = std::ranges::min_element(
        drawn.usualNormals, {}, [&](const glm::dvec3& normal) { return std::abs(glm::dot(normal, along)); });
    return glm::normalize(*nearest - glm::dot(*nearest, along) * along);
}

// Of the image, else of the plane of both directions.
glm::dvec3 normalOf(const glm::dvec3& a, const glm::dvec3& b, const DrawnShape& drawn) {
    if (drawn.normal) return *drawn.normal;
    const glm::dvec3 across = glm::cross(a, b);
    return glm::length(across) > kSameMm ? glm::normalize(across) : normalBeside(a, drawn);
}

Made circle(Measurement made, const std::vector<glm::dvec3>& mm, const glm::dvec3& normal) {
    const double radiusMm = glm::length(mm[1] - mm[0]);
    if (!(radiusMm > kSameMm)) return WhyLeftOut::notRead;
    const glm::dvec3 right = (mm[1] - mm[0]) / radiusMm;
    made.shape = slices::Ellipse{.plane = {mm[0], right, glm::normalize(glm::cross(normal, right))},
                                 .radiiMm = glm::dvec2(radiusMm)};
    made.normal = normal;
    return made;
}

// Both ends of one axis, then of the other (PS3.3 C.18.6.1.2).
Made ellipse(Measurement made, const std::vector<glm::dvec3>& mm, const std::optional<glm::dvec3>& normal) {
    const glm::dvec3 first = 0.5 * (mm[1] - mm[0]);
    const glm::dvec3 second = 0.5 * (mm[3] - mm[2]);
    const glm::dvec2 radiiMm{glm::length(first), glm::length(second)};
    if (!(radiiMm.x > kSameMm && radiiMm.y > kSameMm)) return WhyLeftOut::notRead;
    const glm::dvec3 centre = 0.5 * (mm[0] + mm[1]);
    constexpr double kSquare = 0.02;
    const double apartMm = glm::length(centre - 0.5 * (mm[2] + mm[3]));
    const glm::dvec3 right = first / radiiMm.x;
    if (apartMm > kSquare * std::max(radiiMm.x, radiiMm.y) ||
        std::abs(glm::dot(right, second / radiiMm.y)) > kSquare)
        return WhyLeftOut::notRead;
    glm::dvec3 down = glm::normalize(second - glm::dot(second, right) * right);
    if (normal && glm::dot(glm::cross(right, down), *normal) < 0.0) down = -down;
    made.shape = slices::Ellipse{.plane = {centre, right, down}, .radiiMm = radiiMm};
    made.normal = glm::cross(right, down);
    return made;
}

Made distance(Measurement made, const DrawnShape& drawn) {
    const auto& mm = drawn.pointsMm;
    if (!areApart(mm[0], mm[1])) return WhyLeftOut::notRead;
    made.normal = drawn.normal ? *drawn.normal : normalBeside(mm[1] - mm[0], drawn);
    if (drawn.shortAxisMm.size() != 2) {
        made.shape = slices::Distance{{mm[0], mm[1]}};
        return made;
    }
    const auto& other = drawn.shortAxisMm;
    if (!areUsable(other) || !areApart(other[0], other[1])) return WhyLeftOut::notRead;
    made.shape = slices::Bidirectional{.firstMm = {mm[0], mm[1]}, .secondMm = {other[0], other[1]}};
    made.normal = normalOf(mm[1] - mm[0], other[1] - other[0], drawn);
    return made;
}

Made angle(Measurement made, const DrawnShape& drawn) {
    const auto& mm = drawn.pointsMm;
    if (!areApart(mm[0], mm[1]) || !areApart(mm[2], mm[1])) return WhyLeftOut::notRead;
    made.shape = slices::Angle{{mm[0], mm[1], mm[2]}};
    made.normal = normalOf(mm[0] - mm[1], mm[2] - mm[1], drawn);
    return made;
}

Made cobbAngle(Measurement made, const DrawnShape& drawn) {
    const auto& mm = drawn.pointsMm;
    if (!areApart(mm[0], mm[1]) || !areApart(mm[2], mm[3])) return WhyLeftOut::notRead;
    made.shape = slices::CobbAngle{{mm[0], mm[1], mm[2], mm[3]}};
    made.normal = normalOf(mm[1] - mm[0], mm[3] - mm[2], drawn);
    return made;
}

// No more points than a state keeps.
std::vector<glm::dvec3> fewEnough(std::vector<glm::dvec3> pointsMm) {
    for (double toleranceMm = kSameMm; pointsMm.size() > kMostDrawnPoints; toleranceMm *= 2.0)
        pointsMm = slices::simplified(pointsMm, toleranceMm);
    return pointsMm;
}

Made outline(Measurement made, const DrawnShape& drawn) {
    slices::Outline shape{fewEnough({drawn.pointsMm.begin(), drawn.pointsMm.end() - 1})};
    const auto flat = slices::flatOutline(shape);
    if (!flat) return WhyLeftOut::notRead;
    made.normal = drawn.normal ? *drawn.normal : flat->plane.normal();
    made.shape = std::move(shape);
    return made;
}

Made line(Measurement made, const DrawnShape& drawn) {
    slices::OpenLine shape{fewEnough(drawn.pointsMm)};
    if (!(slices::lengthMm(shape) > kSameMm)) return WhyLeftOut::notRead;
    const auto flat = slices::flatOutline(slices::Outline{shape.pointsMm});
    if (drawn.normal) {
        made.normal = *drawn.normal;
    } else if (flat) {
        made.normal = flat->plane.normal();
    } else {
        const auto far = std::ranges::max_element(shape.pointsMm, {}, [&](const glm::dvec3& mm) {
            return glm::length(mm - shape.pointsMm.front());
        });
        made.normal = normalBeside(*far - shape.pointsMm.front(), drawn);
    }
    made.shape = std::move(shape);
    return made;
}

// Whichever of its axes is called right.
bool isSame(const slices::Ellipse& a, const slices::Ellipse& b) {
    const auto along = [](const glm::dvec3& p, const glm::dvec3& q) {
        return glm::length(p - q) <= kSameMm || glm::length(p + q) <= kSameMm;
    };
    const glm::dvec3 a0 = a.radiiMm.x * a.plane.right, a1 = a.radiiMm.y * a.plane.down;
    const glm::dvec3 b0 = b.radiiMm.x * b.plane.right, b1 = b.radiiMm.y * b.plane.down;
    return glm::length(a.plane.centreMm - b.plane.centreMm) <= kSameMm &&
           ((along(a0, b0) && along(a1, b1)) || (along(a0, b1) && along(a1, b0)));
}

}  // namespace

Made measurementOf(const DrawnShape& drawn) {
    const std::vector<glm::dvec3>& mm = drawn.pointsMm;
    if (!areUsable(mm)) return WhyLeftOut::notRead;
    Measurement made{.shape = slices::Distance{}};
    if (drawn.type == "CIRCLE" && mm.size() == 2 && drawn.normal)
        return circle(std::move(made), mm, *drawn.normal);
    if (drawn.type == "ELLIPSE" && mm.size() == 4) return ellipse(std::move(made), mm, drawn.normal);
    const bool isClosed = mm.size() > slices::kFewestOutlinePoints && !areApart(mm.front(), mm.back());
    if (drawn.type == "POLYGON" && isClosed) return outline(std::move(made), drawn);
    if (drawn.type != "POLYLINE" || mm.size() < 2) return WhyLeftOut::otherShape;
    if (mm.size() == 2) return distance(std::move(made), drawn);
    if (mm.size() == 3 && drawn.hasAngle) return angle(std::move(made), drawn);
    if (mm.size() == 4 && drawn.isCobb) return cobbAngle(std::move(made), drawn);
    if (drawn.hasAngle) return WhyLeftOut::otherShape;
    if (isClosed) return outline(std::move(made), drawn);
    return drawn.hasLength ? line(std::move(made), drawn) : Made(WhyLeftOut::otherShape);
}

bool isSame(const Measurement& a, const Measurement& b) {
    std::vector<glm::dvec3> mine = slices::pointsOf(a);
    const std::vector<glm::dvec3> others = slices::pointsOf(b);
    if (a.shape.index() != b.shape.index() || mine.size() != others.size()) return false;
    if (const auto* ellipse = std::get_if<slices::Ellipse>(&a.shape))
        return isSame(*ellipse, std::get<slices::Ellipse>(b.shape));
    const auto areSame = [&] {
        return std::ranges::equal(mine, others, [](const glm::dvec3& p, const glm::dvec3& q) {
            return glm::length(p - q) <= kSameMm;
        });
    };
    if (areSame()) return true;
    if (!std::holds_alternative<slices::Bidirectional>(a.shape)) return false;
    std::rotate(mine.begin(), mine.begin() + 2, mine.end());  // the other axis first
    return areSame();
}

}  // namespace macula::scene
