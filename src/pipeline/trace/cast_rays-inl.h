// Cast rays in the lanes of a vector, and their search for the next brick that they have to cross:
// nextPiece() of shaders/lib/cast.glsl.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
#if defined(MACULA_CAST_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_CAST_RAYS_INL_H
#undef MACULA_CAST_RAYS_INL_H
#else
#define MACULA_CAST_RAYS_INL_H
#endif

#include <hwy/highway.h>

#include "pipeline/trace/brick_copies.h"
#include "pipeline/trace/lane_matter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t kRays = BrickCopies::kHolders;  // as many lanes as the longest vector has

// What a lane waits for.
enum Casting : std::int32_t {
    kNoRay,     // has nothing to do
    kSeeking,   // its next brick
    kFound,     // to enter this brick
    kCrossing,  // to read the cell in which it is
    kStepping,  // its steps through this cell
    kLeaving,   // to leave it
    kDone,      // the end of its ray
};

struct RayVector {
    alignas(64) float x[kRays];
    alignas(64) float y[kRays];
    alignas(64) float z[kRays];

    void set(std::size_t lane, const glm::vec3& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
    HWY_INLINE Lanes3 load() const {
        const Floats f;
        return {hn::Load(f, x), hn::Load(f, y), hn::Load(f, z)};
    }
    HWY_INLINE void store(const Lanes3& v) {
        const Floats f;
        hn::Store(v.x, f, x);
        hn::Store(v.y, f, y);
        hn::Store(v.z, f, z);
    }
};

// BrickWalk and CellWalk of the shaders, and what their visitors keep, by lane. Unlike there, cells are not
// mirrored where a ray descends.
struct CastRays {
    alignas(64) std::int32_t state[kRays];
    RayVector origin, direction, inverse, brick;  // of BrickWalk; `brick` is its cell
    alignas(64) float cutFrom[NativeHost::kCuts][kRays];
    alignas(64) float cutTo[NativeHost::kCuts][kRays];
    alignas(64) float distanceMm[kRays];
    alignas(64) float endMm[kRays];
    alignas(64) float segmentEndMm[kRays];
    alignas(64) float majorant[kRays];
    alignas(64) std::int32_t segments[kRays];  // so far

    RayVector voxelOrigin, voxelDirection, voxelInverse;  // in voxels, with integers at voxel centres
    alignas(64) float pieceEndMm[kRays];                  // where the ray leaves its brick, or a cut begins
    RayVector cell;                                       // its low corner
    RayVector firstCell;                                  // of the brick
    alignas(64) float fromMm[kRays];                      // where the ray enters the cell
    alignas(64) float toMm[kRays];                        // where it leaves the cell
    alignas(64) std::int32_t cells[kRays];                // so far in this brick
    alignas(64) std::int32_t copy[kRays];                 // where the copy of the brick begins

    // castMatter().
    RayVector worldDirection, colour;
    alignas(64) float transmittance[kRays];
    alignas(64) float phase[kRays];
    alignas(64) float face[kRays];
    alignas(64) float step[kRays];   // number of the next step through the cell
    alignas(64) float steps[kRays];  // where that is not the first one

    // castValues().
    alignas(64) float best[kRays];
    alignas(64) float sum[kRays];
    alignas(64) float lengthMm[kRays];
};

// What all rays of a picture read.
struct CastTables {
    const float* bounds;
    LaneMatter matter;
    bool hasClip;
    int look;  // of trace_params.h
    int entryCount;
};

HWY_INLINE FloatMask floatMask(IntMask m) {
    return hn::RebindMask(Floats(), m);
}
HWY_INLINE IntMask intMask(FloatMask m) {
    return hn::RebindMask(Ints(), m);
}
HWY_INLINE IntMask lanesIn(IntV states, Casting state) {
    return hn::Eq(states, hn::Set(Ints(), state));
}
HWY_INLINE std::size_t countIn(IntV states, Casting state) {
    return hn::CountTrue(Ints(), lanesIn(states, state));
}
HWY_INLINE IntV moved(IntV states, IntMask lanes, Casting state) {
    return hn::IfThenElse(lanes, hn::Set(Ints(), state), states);
}

// Moves seeking rays on through the grid of bricks.
class BrickSearch {
  public:
    HWY_INLINE BrickSearch(CastRays& rays, const CastTables& tables)
        : r_(rays),
          t_(tables),
          state_(hn::Load(i_, rays.state)),
          segments_(hn::Load(i_, rays.segments)),
          distance_(hn::Load(f_, rays.distanceMm)),
          end_(hn::Load(f_, rays.endMm)),
          segmentEnd_(hn::Load(f_, rays.segmentEndMm)),
          majorant_(hn::Load(f_, rays.majorant)),
          pieceEnd_(hn::Load(f_, rays.pieceEndMm)),
          origin_(rays.origin.load()),
          direction_(rays.direction.load()),
          inverse_(rays.inverse.load()),
          brick_(rays.brick.load()) {}

    // Searches until fewer than `enough` lanes do.
    HWY_INLINE void run(std::size_t enough) {
        const FloatV least = leastBound();
        const glm::ivec3& grid = t_.matter.voxels.grid;
        const IntV most = hn::Set(i_, 8 * (grid.x + grid.y + grid.z) + 64);
        auto seeking = floatMask(lanesIn(state_, kSeeking));
        do {
            if (t_.hasClip) leaveCuts(seeking);
            const auto finds =
                hn::And(seeking, hn::And(hn::Gt(majorant_, least), hn::Lt(distance_, segmentEnd_)));
            pieceEnd_ = hn::IfThenElse(finds, t_.hasClip ? nextCut() : segmentEnd_, pieceEnd_);
            state_ = moved(state_, intMask(finds), kFound);
            seeking = hn::AndNot(finds, seeking);
            if (t_.hasClip) leap(hn::And(seeking, hn::Gt(distance_, segmentEnd_)));
            distance_ = hn::IfThenElse(seeking, segmentEnd_, distance_);
            segments_ = hn::IfThenElse(intMask(seeking), hn::Add(segments_, hn::Set(i_, 1)), segments_);
            // A ray so far away that rounding stalls it ends too.
            const auto goes =
                hn::And(hn::And(seeking, hn::Lt(distance_, end_)), floatMask(hn::Lt(segments_, most)));
            state_ = moved(state_, intMask(hn::AndNot(goes, seeking)), kDone);
            seeking = goes;
            nextSegment(seeking);
        } while (hn::CountTrue(f_, seeking) >= enough);
        store();
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};

    HWY_INLINE void store() const {
        hn::Store(state_, i_, r_.state);
        hn::Store(segments_, i_, r_.segments);
        hn::Store(distance_, f_, r_.distanceMm);
        hn::Store(segmentEnd_, f_, r_.segmentEndMm);
        hn::Store(majorant_, f_, r_.majorant);
        hn::Store(pieceEnd_, f_, r_.pieceEndMm);
        r_.brick.store(brick_);
    }

    // leastBound() of cast.glsl.
    HWY_INLINE FloatV leastBound() const {
        const FloatV zero = hn::Zero(f_);
        const FloatV best = hn::Load(f_, r_.best);
        const FloatV half = hn::Set(f_, 0.5f);
        if (t_.look == shared::kCastMaximum) return hn::Max(hn::Add(best, half), zero);
        if (t_.look == shared::kCastMinimum)
            return hn::Max(hn::Sub(hn::Add(best, hn::Set(f_, float(t_.entryCount))), half), zero);
        return zero;
    }

    // One cut may end inside another.
    HWY_INLINE void leaveCuts(FloatMask of) {
        for (int i = 0; i < NativeHost::kCuts; ++i) {
            FloatV cutEnd = distance_;
            for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
                const FloatV to = hn::Load(f_, r_.cutTo[cut]);
                const auto within =
                    hn::And(hn::Le(hn::Load(f_, r_.cutFrom[cut]), distance_), hn::Lt(distance_, to));
                cutEnd = hn::IfThenElse(within, hn::Max(cutEnd, to), cutEnd);
            }
            distance_ = hn::IfThenElse(of, cutEnd, distance_);
        }
    }

    // nextCut() of clip.glsl, at the latest the end of the segment.
    HWY_INLINE FloatV nextCut() const {
        FloatV at = segmentEnd_;
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            const FloatV from = hn::Load(f_, r_.cutFrom[cut]);
            const auto is = hn::And(hn::Lt(from, hn::Load(f_, r_.cutTo[cut])), hn::Gt(from, distance_));
            at = hn::IfThenElse(is, hn::Min(at, from), at);
        }
        return at;
    }

    HWY_INLINE void leap(FloatMask of) {
        if (hn::AllFalse(f_, of)) return;
        segmentEnd_ = hn::IfThenElse(of, distance_, segmentEnd_);
        majorant_ = hn::IfThenZeroElse(of, majorant_);
        const auto brickAt = [&](FloatV origin, FloatV direction, FloatV brick, int count) HWY_ATTR {
            const FloatV there = hn::Floor(hn::MulAdd(direction, distance_, origin));
            return hn::IfThenElse(of, hn::Clamp(there, hn::Zero(f_), hn::Set(f_, float(count - 1))), brick);
        };
        brick_.x = brickAt(origin_.x, direction_.x, brick_.x, t_.matter.voxels.grid.x);
        brick_.y = brickAt(origin_.y, direction_.y, brick_.y, t_.matter.voxels.grid.y);
        brick_.z = brickAt(origin_.z, direction_.z, brick_.z, t_.matter.voxels.grid.z);
    }

    // One round of the loop of nextSegment() in brick_walk.glsl.
    HWY_INLINE void nextSegment(FloatMask of) {
        const FloatV zero = hn::Zero(f_);
        const FloatV one = hn::Set(f_, 1.0f);
        const glm::ivec3& grid = t_.matter.voxels.grid;
        const IntV inPlane = hn::ConvertTo(
            i_, hn::IfThenElseZero(of, hn::MulAdd(brick_.y, hn::Set(f_, float(grid.x)), brick_.x)));
        const IntV plane = hn::ConvertTo(i_, hn::IfThenElseZero(of, brick_.z));
        const IntV index = hn::Clamp(hn::Add(inPlane, hn::Mul(plane, hn::Set(i_, grid.x * grid.y))),
                                     hn::Zero(i_), hn::Set(i_, grid.x * grid.y * grid.z - 1));
        const FloatV bound = hn::GatherIndex(f_, t_.bounds, index);
        const FloatV reach = hn::Max(hn::Neg(bound), one);
        const FloatV margin = hn::Sub(reach, one);

        struct Axis {
            FloatV toFace, step;
        };
        const auto axisOf = [&](FloatV origin, FloatV direction, FloatV inverse, FloatV brick) HWY_ATTR {
            const FloatV forward = hn::IfThenZeroElse(hn::Lt(direction, zero), one);
            const FloatV step = hn::Sub(hn::Add(forward, forward), one);
            const FloatV face = hn::MulAdd(step, margin, hn::Add(brick, forward));
            return Axis{hn::Mul(hn::Sub(face, origin), inverse), step};
        };
        const Axis x = axisOf(origin_.x, direction_.x, inverse_.x, brick_.x);
        const Axis y = axisOf(origin_.y, direction_.y, inverse_.y, brick_.y);
        const Axis z = axisOf(origin_.z, direction_.z, inverse_.z, brick_.z);
        const FloatV exit = hn::Min(hn::Min(x.toFace, y.toFace), z.toFace);
        const auto cross = [&](const Axis& axis, FloatV origin, FloatV direction, FloatV brick) HWY_ATTR {
            const FloatV there = hn::Floor(hn::MulAdd(direction, exit, origin));
            const FloatV beside = hn::Clamp(there, hn::Sub(brick, margin), hn::Add(brick, margin));
            const FloatV across = hn::MulAdd(axis.step, reach, brick);
            return hn::IfThenElse(of, hn::IfThenElse(hn::Le(axis.toFace, exit), across, beside), brick);
        };
        brick_.x = cross(x, origin_.x, direction_.x, brick_.x);
        brick_.y = cross(y, origin_.y, direction_.y, brick_.y);
        brick_.z = cross(z, origin_.z, direction_.z, brick_.z);
        // A ray that is not a number ends, as in the scalar code.
        const FloatV to = hn::IfThenElse(hn::Eq(exit, exit), hn::Min(hn::Max(exit, distance_), end_), end_);
        segmentEnd_ = hn::IfThenElse(of, to, segmentEnd_);
        majorant_ = hn::IfThenElse(of, hn::Max(bound, zero), majorant_);
    }

    CastRays& r_;
    const CastTables& t_;
    IntV state_, segments_;
    FloatV distance_, end_, segmentEnd_, majorant_, pieceEnd_;
    Lanes3 origin_, direction_, inverse_, brick_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
