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
#include "pipeline/trace/lane_walk-inl.h"

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
          walk_{rays.origin.load(),
                rays.direction.load(),
                rays.inverse.load(),
                rays.brick.load(),
                hn::Load(f_, rays.distanceMm),
                hn::Load(f_, rays.endMm),
                hn::Load(f_, rays.segmentEndMm)},
          majorant_(hn::Load(f_, rays.majorant)),
          pieceEnd_(hn::Load(f_, rays.pieceEndMm)) {}

    // Searches until fewer than `enough` lanes do.
    HWY_INLINE void run(std::size_t enough) {
        const FloatV least = leastBound();
        const glm::ivec3& grid = t_.matter.voxels.grid;
        const IntV most = hn::Set(i_, 8 * (grid.x + grid.y + grid.z) + 64);
        auto seeking = floatMask(lanesIn(state_, kSeeking));
        do {
            if (t_.hasClip) leaveCuts(seeking);
            const auto finds =
                hn::And(seeking, hn::And(hn::Gt(majorant_, least), hn::Lt(walk_.distance, walk_.segmentEnd)));
            pieceEnd_ = hn::IfThenElse(finds, t_.hasClip ? nextCut() : walk_.segmentEnd, pieceEnd_);
            state_ = moved(state_, intMask(finds), kFound);
            seeking = hn::AndNot(finds, seeking);
            if (t_.hasClip) leap(hn::And(seeking, hn::Gt(walk_.distance, walk_.segmentEnd)));
            walk_.distance = hn::IfThenElse(seeking, walk_.segmentEnd, walk_.distance);
            segments_ = hn::IfThenElse(intMask(seeking), hn::Add(segments_, hn::Set(i_, 1)), segments_);
            // A ray so far away that rounding stalls it ends too.
            const auto goes = hn::And(hn::And(seeking, hn::Lt(walk_.distance, walk_.end)),
                                      floatMask(hn::Lt(segments_, most)));
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
        hn::Store(walk_.distance, f_, r_.distanceMm);
        hn::Store(walk_.segmentEnd, f_, r_.segmentEndMm);
        hn::Store(majorant_, f_, r_.majorant);
        hn::Store(pieceEnd_, f_, r_.pieceEndMm);
        r_.brick.store(walk_.cell);
    }

    // The bound that a brick must exceed to change the result, as leastBound() of cast.glsl has it.
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
            FloatV cutEnd = walk_.distance;
            for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
                const FloatV to = hn::Load(f_, r_.cutTo[cut]);
                const auto within = hn::And(hn::Le(hn::Load(f_, r_.cutFrom[cut]), walk_.distance),
                                            hn::Lt(walk_.distance, to));
                cutEnd = hn::IfThenElse(within, hn::Max(cutEnd, to), cutEnd);
            }
            walk_.distance = hn::IfThenElse(of, cutEnd, walk_.distance);
        }
    }

    // Returns where the next cut begins, as nextCut() of clip.glsl does; at the latest the end of the
    // segment.
    HWY_INLINE FloatV nextCut() const {
        FloatV at = walk_.segmentEnd;
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            const FloatV from = hn::Load(f_, r_.cutFrom[cut]);
            const auto is = hn::And(hn::Lt(from, hn::Load(f_, r_.cutTo[cut])), hn::Gt(from, walk_.distance));
            at = hn::IfThenElse(is, hn::Min(at, from), at);
        }
        return at;
    }

    HWY_INLINE void leap(FloatMask of) {
        if (hn::AllFalse(f_, of)) return;
        walk_.leap(of, walk_.distance, t_.matter.voxels.grid);
        majorant_ = hn::IfThenZeroElse(of, majorant_);
    }

    HWY_INLINE void nextSegment(FloatMask of) {
        const FloatV bound = walk_.nextSegment(of, t_.bounds, t_.matter.voxels.grid);
        majorant_ = hn::IfThenElse(of, hn::Max(bound, hn::Zero(f_)), majorant_);
    }

    CastRays& r_;
    const CastTables& t_;
    IntV state_, segments_;
    LaneWalk walk_;
    FloatV majorant_, pieceEnd_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
