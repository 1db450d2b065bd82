#include "pipeline/volume/clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace macula {

namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isUnit(const glm::dvec3& v) {
    return isFinite(v) && std::abs(glm::length(v) - 1.0) < 1e-6;
}

Error notUsable(const char* what, const char* hint) {
    return {ErrorCode::usage, fmt::format("The clip is not usable: {}.", what), {}, hint};
}

bool isInside(const HalfSpace& side, const glm::dvec3& point) {
    return glm::dot(side.normal, point) >= side.offsetMm;
}

template <class Sides>
bool isInsideAll(const Sides& sides, const glm::dvec3& point) {
    return std::all_of(sides.begin(), sides.end(), [&](const HalfSpace& s) { return isInside(s, point); });
}

}  // namespace

std::array<HalfSpace, 6> sidesOf(const OrientedBox& box) {
    std::array<HalfSpace, 6> sides;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 normal = box.axes[axis];
        const double centre = glm::dot(normal, box.centreMm);
        sides[std::size_t(2 * axis)] = {normal, centre - box.halfSizeMm[axis]};
        sides[std::size_t(2 * axis + 1)] = {-normal, -centre - box.halfSizeMm[axis]};
    }
    return sides;
}

std::array<HalfSpace, 3> sidesOf(const Octant& octant) {
    std::array<HalfSpace, 3> sides;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = octant.towards[axis];
        sides[std::size_t(axis)] = {normal, glm::dot(normal, octant.pointMm)};
    }
    return sides;
}

Result<void> validate(const Clip& clip) {
    if (clip.planes.size() > Clip::kMostPlanes)
        return notUsable("there are more than six planes", "Give six planes at most.");
    if (clip.box) {
        const OrientedBox& box = *clip.box;
        const glm::dvec3 size = box.halfSizeMm;
        if (!isFinite(box.centreMm) || !isFinite(size) || std::min({size.x, size.y, size.z}) <= 0.0)
            return notUsable("the box has no size", "Give a centre and positive half sizes in mm.");
        const glm::dmat3 product = glm::transpose(box.axes) * box.axes;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) < 1e-6))
                    return notUsable("the axes of the box are not at right angles",
                                     "Give three unit vectors.");
            }
        }
    }
    for (const HalfSpace& plane : clip.planes) {
        if (!isUnit(plane.normal) || !std::isfinite(plane.offsetMm))
            return notUsable("a plane has no direction",
                             "Give its normal as a unit vector, and its distance in mm.");
    }
    if (clip.cut) {
        const glm::dvec3 towards = glm::abs(clip.cut->towards);
        if (!isFinite(clip.cut->pointMm) || towards != glm::dvec3(1.0))
            return notUsable("the corner has no direction", "Give three signs, such as L, A, S.");
    }
    if (clip.ball &&
        (!isFinite(clip.ball->centreMm) || !std::isfinite(clip.ball->radiusMm) || clip.ball->radiusMm <= 0.0))
        return notUsable("the ball has no size", "Give a centre and a positive radius in mm.");
    if (clip.greyFaces && !(std::isfinite(clip.greyFaces->center) && clip.greyFaces->width > 0.0 &&
                            std::isfinite(clip.greyFaces->width)))
        return notUsable("the window of its faces has no width", "Give a centre and a positive width.");
    return {};
}

bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame) {
    std::array<glm::dvec3, 8> corners;
    for (std::size_t c = 0; c < 8; ++c) {
        const glm::dvec3 corner((c & 1) ? boxInFrame.high.x : boxInFrame.low.x,
                                (c & 2) ? boxInFrame.high.y : boxInFrame.low.y,
                                (c & 4) ? boxInFrame.high.z : boxInFrame.low.z);
        corners[c] = transformPoint(worldFromFrame, corner);
    }
    // All corners beyond one side of a region are outside of it; all corners inside a convex one are in it.
    const auto isBeyond = [&](const HalfSpace& side) {
        return std::none_of(corners.begin(), corners.end(),
                            [&](const glm::dvec3& p) { return isInside(side, p); });
    };
    const auto isWithin = [&](const auto& sides) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const glm::dvec3& p) { return isInsideAll(sides, p); });
    };
    if (std::any_of(clip.planes.begin(), clip.planes.end(), isBeyond)) return true;
    if (clip.box) {
        const auto sides = sidesOf(*clip.box);
        if (clip.ofBox == Keep::inside ? std::any_of(sides.begin(), sides.end(), isBeyond) : isWithin(sides))
            return true;
    }
    if (clip.cut && isWithin(sidesOf(*clip.cut))) return true;
    if (!clip.ball) return false;
    const auto distance = [&](const glm::dvec3& p) { return glm::length(p - clip.ball->centreMm); };
    if (clip.ofBall == Keep::outside) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const glm::dvec3& p) { return distance(p) < clip.ball->radiusMm; });
    }
    // No point of a box is nearer than its centre less half its diagonal.
    glm::dvec3 centre(0.0);
    for (const glm::dvec3& p : corners) centre += p / 8.0;
    double reach = 0.0;
    for (const glm::dvec3& p : corners) reach = std::max(reach, glm::length(p - centre));
    return distance(centre) - reach > clip.ball->radiusMm;
}

bool shows(const Clip& clip, const glm::dvec3& pointMm) {
    if (!isInsideAll(clip.planes, pointMm)) return false;
    if (clip.box && isInsideAll(sidesOf(*clip.box), pointMm) != (clip.ofBox == Keep::inside)) return false;
    if (clip.cut && isInsideAll(sidesOf(*clip.cut), pointMm)) return false;
    if (!clip.ball) return true;
    return (glm::length(pointMm - clip.ball->centreMm) <= clip.ball->radiusMm) ==
           (clip.ofBall == Keep::inside);
}

}  // namespace macula
