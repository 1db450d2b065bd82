// The walk of shaders/lib/brick_walk.glsl by lanes of vectors.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE.
#if defined(MACULA_LANE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_LANE_WALK_INL_H
#undef MACULA_LANE_WALK_INL_H
#else
#define MACULA_LANE_WALK_INL_H
#endif

#include <hwy/highway.h>

#include "pipeline/trace/lane_voxels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// As BrickWalk.
struct LaneWalk {
    Lanes3 origin, direction, inverse, cell;
    FloatV distance, end, segmentEnd;

    // One round of the loop of nextSegment() in these lanes: a segment from `distance` to `segmentEnd`.
    // Returns the bound of its brick, in idle lanes any.
    HWY_INLINE FloatV nextSegment(FloatMask of, const float* bounds, const glm::ivec3& grid) {
        const FloatV zero = hn::Zero(f_);
        const FloatV one = hn::Set(f_, 1.0f);
        const IntV inPlane =
            hn::ConvertTo(i_, hn::IfThenElseZero(of, hn::MulAdd(cell.y, hn::Set(f_, float(grid.x)), cell.x)));
        const IntV plane = hn::ConvertTo(i_, hn::IfThenElseZero(of, cell.z));
        const IntV brick = hn::Clamp(hn::Add(inPlane, hn::Mul(plane, hn::Set(i_, grid.x * grid.y))),
                                     hn::Zero(i_), hn::Set(i_, grid.x * grid.y * grid.z - 1));
        const FloatV bound = hn::GatherIndex(f_, bounds, brick);
        const FloatV reach = hn::Max(hn::Neg(bound), one);
        const FloatV margin = hn::Sub(reach, one);

        struct Axis {
            FloatV toFace, step;
        };
        const auto axisOf = [&](FloatV from, FloatV along, FloatV inverted, FloatV at) HWY_ATTR {
            const FloatV forward = hn::IfThenZeroElse(hn::Lt(along, zero), one);
            const FloatV step = hn::Sub(hn::Add(forward, forward), one);
            const FloatV face = hn::MulAdd(step, margin, hn::Add(at, forward));
            return Axis{hn::Mul(hn::Sub(face, from), inverted), step};
        };
        const Axis x = axisOf(origin.x, direction.x, inverse.x, cell.x);
        const Axis y = axisOf(origin.y, direction.y, inverse.y, cell.y);
        const Axis z = axisOf(origin.z, direction.z, inverse.z, cell.z);
        const FloatV exit = hn::Min(hn::Min(x.toFace, y.toFace), z.toFace);
        const auto cross = [&](const Axis& axis, FloatV from, FloatV along, FloatV at) HWY_ATTR {
            const FloatV there = hn::Floor(hn::MulAdd(along, exit, from));
            const FloatV beside = hn::Clamp(there, hn::Sub(at, margin), hn::Add(at, margin));
            const FloatV across = hn::MulAdd(axis.step, reach, at);
            return hn::IfThenElse(of, hn::IfThenElse(hn::Le(axis.toFace, exit), across, beside), at);
        };
        cell.x = cross(x, origin.x, direction.x, cell.x);
        cell.y = cross(y, origin.y, direction.y, cell.y);
        cell.z = cross(z, origin.z, direction.z, cell.z);
        // A ray that is not a number ends, as in the scalar code.
        const FloatV to = hn::IfThenElse(hn::Eq(exit, exit), hn::Min(hn::Max(exit, distance), end), end);
        segmentEnd = hn::IfThenElse(of, to, segmentEnd);
        return bound;
    }

    // Moves the walk along the ray in these lanes, as leap().
    HWY_INLINE void leap(FloatMask of, FloatV distanceMm, const glm::ivec3& grid) {
        distance = hn::IfThenElse(of, distanceMm, distance);
        segmentEnd = hn::IfThenElse(of, distanceMm, segmentEnd);
        const auto cellAt = [&](FloatV from, FloatV along, FloatV at, int count) HWY_ATTR {
            const FloatV there = hn::Floor(hn::MulAdd(along, distance, from));
            return hn::IfThenElse(of, hn::Clamp(there, hn::Zero(f_), hn::Set(f_, float(count - 1))), at);
        };
        cell.x = cellAt(origin.x, direction.x, cell.x, grid.x);
        cell.y = cellAt(origin.y, direction.y, cell.y, grid.y);
        cell.z = cellAt(origin.z, direction.z, cell.z, grid.z);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
