#include "pipeline/volume/clip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/is_finite.h"

namespace macula {

namespace {

bool isUnitVector(const glm::dvec3& v) {
    return isFinite(v) && std::abs(glm::length(v) - 1.0) < 1e-6;
}

Error notUsable(const Text& what, Text hint) {
    return {ErrorCode::usage, Text("The clip is not usable: {}.", what), {}, std::move(hint)};
}

bool isInside(const HalfSpace& side, const glm::dvec3& point) {
    return glm::dot(side.normal, point) >= side.offsetMm;
}

template <class Sides>
bool isInsideAll(const Sides& sides, const glm::dvec3& point) {
    return std::all_of(sides.begin(), sides.end(), [&](const HalfSpace& s) { return isInside(s, point); });
}

// The corners of a box, in the world. If all lie beyond one side of a region, the box is outside it; if all
// lie inside a convex region, the box is inside it.
class Corners {
  public:
    Corners(const glm::dmat4& worldFromFrame, const Box& box) {
        for (std::size_t c = 0; c < points_.size(); ++c) {
            const glm::dvec3 corner((c & 1) ? box.high.x : box.low.x, (c & 2) ? box.high.y : box.low.y,
                                    (c & 4) ? box.high.z : box.low.z);
            points_[c] = transformPoint(worldFromFrame, corner);
        }
    }

    bool areBeyond(const HalfSpace& side) const {
        return std::none_of(points_.begin(), points_.end(),
                            [&](const glm::dvec3& p) { return isInside(side, p); });
    }
    template <class Sides>
    bool areWithin(const Sides& sides) const {
        return std::all_of(points_.begin(), points_.end(),
                           [&](const glm::dvec3& p) { return isInsideAll(sides, p); });
    }
    // No point of a box is nearer than its centre, minus half its diagonal.
    bool areBeyond(const Ball& ball) const {
        glm::dvec3 centre(0.0);
        for (const glm::dvec3& p : points_) centre += p / double(points_.size());
        double reach = 0.0;
        for (const glm::dvec3& p : points_) reach = std::max(reach, glm::length(p - centre));
        return glm::length(centre - ball.centreMm) - reach > ball.radiusMm;
    }
    bool areWithin(const Ball& ball) const {
        return std::all_of(points_.begin(), points_.end(), [&](const glm::dvec3& p) {
            return glm::length(p - ball.centreMm) < ball.radiusMm;
        });
    }

  private:
    std::array<glm::dvec3, 8> points_;
};

}  // namespace

std::array<HalfSpace, 6> sidesOf(const OrientedBox& box) {
    std::array<HalfSpace, 6> sides;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 normal = box.axes[axis];
        const double centre = glm::dot(normal, box.centreMm);
        sides[2 * std::size_t(axis)] = {normal, centre - box.halfSizeMm[axis]};
        sides[2 * std::size_t(axis) + 1] = {-normal, -centre - box.halfSizeMm[axis]};
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
        return notUsable(Text("there are more than six planes"), Text("Give six planes at most."));
    if (clip.box) {
        const OrientedBox& box = *clip.box;
        const glm::dvec3 size = box.halfSizeMm;
        if (!isFinite(box.centreMm) || !isFinite(size) || std::min({size.x, size.y, size.z}) <= 0.0)
            return notUsable(Text("the box has no size"),
                             Text("Give a centre and positive half sizes in mm."));
        const glm::dmat3 product = glm::transpose(box.axes) * box.axes;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) < 1e-6))
                    return notUsable(Text("the axes of the box are not at right angles"),
                                     Text("Give three unit vectors."));
            }
        }
    }
    for (const HalfSpace& plane : clip.planes) {
        if (!isUnitVector(plane.normal) || !std::isfinite(plane.offsetMm))
            return notUsable(Text("a plane has no direction"),
                             Text("Give its normal as a unit vector, and its distance in mm."));
    }
    if (clip.cut) {
        const glm::dvec3 towards = glm::abs(clip.cut->towards);
        if (!isFinite(clip.cut->pointMm) || towards != glm::dvec3(1.0))
            return notUsable(Text("the corner has no direction"), Text("Give three signs, such as L, A, S."));
    }
    if (clip.ball &&
        (!isFinite(clip.ball->centreMm) || !std::isfinite(clip.ball->radiusMm) || clip.ball->radiusMm <= 0.0))
        return notUsable(Text("the ball has no size"), Text("Give a centre and a positive radius in mm."));
    if (clip.mask && clip.mask->labels == nullptr && clip.mask->bits == nullptr)
        return notUsable(Text("there is no segmentation to mask with"), Text("Give one."));
    if (clip.greyFaces && !(std::isfinite(clip.greyFaces->center) && clip.greyFaces->width > 0.0 &&
                            std::isfinite(clip.greyFaces->width)))
        return notUsable(Text("the window of its faces has no width"),
                         Text("Give a centre and a positive width."));
    return {};
}

bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame) {
    const Corners corners(worldFromFrame, boxInFrame);
    const auto isBeyond = [&](const HalfSpace& side) { return corners.areBeyond(side); };
    if (std::any_of(clip.planes.begin(), clip.planes.end(), isBeyond)) return true;
    if (clip.box) {
        const auto sides = sidesOf(*clip.box);
        const bool all = clip.ofBox == Keep::inside ? std::any_of(sides.begin(), sides.end(), isBeyond)
                                                    : corners.areWithin(sides);
        if (all) return true;
    }
    if (clip.cut && corners.areWithin(sidesOf(*clip.cut))) return true;
    if (!clip.ball) return false;
    return clip.ofBall == Keep::inside ? corners.areBeyond(*clip.ball) : corners.areWithin(*clip.ball);
}

bool removesNothing(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame) {
    const Corners corners(worldFromFrame, boxInFrame);
    const auto isBeyond = [&](const HalfSpace& side) { return corners.areBeyond(side); };
    if (!corners.areWithin(clip.planes)) return false;
    if (clip.box) {
        const auto sides = sidesOf(*clip.box);
        const bool all = clip.ofBox == Keep::inside ? corners.areWithin(sides)
                                                    : std::any_of(sides.begin(), sides.end(), isBeyond);
        if (!all) return false;
    }
    if (clip.cut) {
        const auto sides = sidesOf(*clip.cut);
        if (std::none_of(sides.begin(), sides.end(), isBeyond)) return false;
    }
    if (!clip.ball) return true;
    return clip.ofBall == Keep::inside ? corners.areWithin(*clip.ball) : corners.areBeyond(*clip.ball);
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
