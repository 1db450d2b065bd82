// Rays in the lanes of vectors: the walk through bricks and the tentative collisions of follow() in
// shaders/lib/path.glsl, for many rays at once. Where a ray ends, its path is decided in scalar code.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE.
#if defined(MACULA_FLIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_FLIGHTS_INL_H
#undef MACULA_FLIGHTS_INL_H
#else
#define MACULA_FLIGHTS_INL_H
#endif

#include <hwy/highway.h>
// After it.
#include <hwy/contrib/math/math-inl.h>

#include "pipeline/trace/lane_matter-inl.h"
#include "pipeline/trace/lane_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// Several vectors of lanes, so that the gathers of one overlap with the arithmetic of another.
constexpr std::size_t kFlights = 32;

// A ray that has had so many tentative collisions is given up.
constexpr int kMostCollisions = 1 << 24;

// The state of a lane.
enum Flying : std::int32_t {
    kIdle,    // has no ray
    kNewRay,  // has to draw the depth of its next tentative collision
    kMoving,  // on the way to it
    kMet,     // stands at it
    kEnded,   // the ray has ended
};

struct Vector3 {
    alignas(64) float x[kFlights];
    alignas(64) float y[kFlights];
    alignas(64) float z[kFlights];

    void set(std::size_t lane, const glm::vec3& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
};

// BrickWalk, Rng and the parts of Path that change along a ray, by lane.
struct Flights {
    Vector3 origin, direction, inverse, cell;
    alignas(64) float cutFrom[NativeHost::kCuts][kFlights];
    alignas(64) float cutTo[NativeHost::kCuts][kFlights];
    alignas(64) float distanceMm[kFlights];
    alignas(64) float endMm[kFlights];
    alignas(64) float segmentEndMm[kFlights];
    alignas(64) float majorant[kFlights];
    alignas(64) float looseness[kFlights];
    alignas(64) float depth[kFlights];  // optical depth left until the next tentative collision
    alignas(64) float transmittance[kFlights];
    alignas(64) float entry[kFlights];
    alignas(64) float steep[kFlights];
    alignas(64) std::uint32_t key0[kFlights];
    alignas(64) std::uint32_t key1[kFlights];
    alignas(64) std::uint32_t counter[kFlights];
    alignas(64) std::int32_t isShadow[kFlights];
    alignas(64) std::int32_t seesAll[kFlights];     // whatever the mask hides
    alignas(64) std::int32_t collisions[kFlights];  // tentative ones of the ray so far
    alignas(64) std::int32_t aboveBound[kFlights];
    alignas(64) std::int32_t state[kFlights];
};

// What the flights of a scene read.
struct FlightTables {
    const float* bounds;
    LaneMatter matter;
    bool hasClip;
};

// exponentialDepth() of rng.glsl.
HWY_INLINE FloatV exponentialDepth(Floats f, FloatV u) {
    const FloatV one = hn::Set(f, 1.0f);
    const FloatV near =
        hn::Mul(u, hn::MulAdd(u, hn::MulAdd(u, hn::Set(f, 1.0f / 3.0f), hn::Set(f, 0.5f)), one));
    return hn::IfThenElse(hn::Lt(u, hn::Set(f, 1e-3f)), near, hn::Neg(hn::Log(f, hn::Sub(one, u))));
}

// mixedBits() of rng.glsl.
HWY_INLINE UintV mixedBits(Uints u, UintV h, UintV key) {
    h = hn::Xor(h, hn::ShiftRight<16>(h));
    h = hn::Mul(h, hn::Set(u, 0x21f0aaadu));
    h = hn::Add(h, key);
    h = hn::Xor(h, hn::ShiftRight<15>(h));
    h = hn::Mul(h, hn::Set(u, 0x735a2d97u));
    return hn::Xor(h, hn::ShiftRight<15>(h));
}

// Whether no lane of a vector has a ray.
HWY_INLINE bool isIdle(const Flights& flights, std::size_t first) {
    const Ints i;
    return hn::AllTrue(i, hn::Eq(hn::Load(i, flights.state + first), hn::Set(i, kIdle)));
}

// The lanes of one vector during a round.
class Round {
  public:
    HWY_INLINE Round(Flights& flights, const FlightTables& tables, std::size_t first)
        : s_(flights), t_(tables), at_(first) {
        state_ = hn::Load(i_, s_.state + at_);
        walk_.distance = hn::Load(f_, s_.distanceMm + at_);
        walk_.end = hn::Load(f_, s_.endMm + at_);
        walk_.segmentEnd = hn::Load(f_, s_.segmentEndMm + at_);
        majorant_ = hn::Load(f_, s_.majorant + at_);
        looseness_ = hn::Load(f_, s_.looseness + at_);
        depth_ = hn::Load(f_, s_.depth + at_);
        counter_ = hn::Load(u_, s_.counter + at_);
        walk_.cell = load(s_.cell);
        walk_.origin = load(s_.origin);
        walk_.direction = load(s_.direction);
        walk_.inverse = load(s_.inverse);
    }

    // Draws the depth of the next tentative collision where a ray is new or has just had one.
    HWY_INLINE void drawDepths() {
        const auto fresh = is(kNewRay);
        if (hn::AllFalse(i_, fresh)) return;
        drawDepths(fresh);
        state_ = hn::IfThenElse(fresh, hn::Set(i_, kMoving), state_);
    }

    // Moves rays on by a segment each.
    HWY_INLINE void move() {
        auto moving = is(kMoving);
        FloatV inSegment = hn::Mul(majorant_, hn::Sub(walk_.segmentEnd, walk_.distance));
        auto meets = hn::And(asFloats(moving), hn::Lt(depth_, inSegment));
        walk_.distance =
            hn::IfThenElse(meets, hn::Add(walk_.distance, hn::Div(depth_, majorant_)), walk_.distance);
        if (t_.hasClip) leaveCuts(meets, inSegment);
        state_ = hn::IfThenElse(asInts(meets), hn::Set(i_, kMet), state_);

        const auto goes = hn::AndNot(meets, asFloats(moving));
        depth_ = hn::IfThenElse(goes, hn::Sub(depth_, inSegment), depth_);
        walk_.distance = hn::IfThenElse(goes, walk_.segmentEnd, walk_.distance);
        const auto inside = hn::And(goes, hn::Lt(walk_.distance, walk_.end));
        state_ = hn::IfThenElse(asInts(hn::AndNot(inside, goes)), hn::Set(i_, kEnded), state_);
        nextSegment(inside);
    }

    HWY_INLINE bool anyMoving() const { return !hn::AllFalse(i_, is(kMoving)); }
    HWY_INLINE std::size_t countMet() const { return hn::CountTrue(i_, is(kMet)); }

    // Decides the tentative collisions of rays with matter whose extinction LaneMatter computes.
    HWY_INLINE void collide() {
        const auto met = asFloats(is(kMet));
        const FloatV eight = hn::Set(f_, float(NativeHost::kBrickEdge));
        const FloatV shift = hn::Set(f_, NativeHost::kBrickShift);
        const auto position = [&](FloatV origin, FloatV direction) HWY_ATTR {
            return hn::MulSub(hn::MulAdd(direction, walk_.distance, origin), eight, shift);
        };
        const Lanes3 at{position(walk_.origin.x, walk_.direction.x),
                        position(walk_.origin.y, walk_.direction.y),
                        position(walk_.origin.z, walk_.direction.z)};
        const FloatV entry =
            t_.matter.isTrilinear ? t_.matter.voxels.trilinear(met, at) : stochasticEntry(met, at);
        hn::BlendedStore(entry, met, f_, s_.entry + at_);
        FloatV extinction = extinctionAt(met, at, entry);
        if (t_.matter.mask != nullptr) {
            const auto sees = asFloats(hn::Ne(hn::Load(i_, s_.seesAll + at_), hn::Zero(i_)));
            const auto hidden = hn::AndNot(sees, t_.matter.isMasked(met, at));
            extinction = hn::IfThenZeroElse(hidden, extinction);
        }
        collideWith(met, hn::Div(extinction, hn::IfThenElse(met, majorant_, hn::Set(f_, 1.0f))));
    }

    // The lanes whose ray has ended, as bits.
    HWY_INLINE std::uint32_t store() const {
        hn::Store(state_, i_, s_.state + at_);
        hn::Store(walk_.distance, f_, s_.distanceMm + at_);
        hn::Store(walk_.segmentEnd, f_, s_.segmentEndMm + at_);
        hn::Store(majorant_, f_, s_.majorant + at_);
        hn::Store(looseness_, f_, s_.looseness + at_);
        hn::Store(depth_, f_, s_.depth + at_);
        hn::Store(counter_, u_, s_.counter + at_);
        hn::Store(walk_.cell.x, f_, s_.cell.x + at_);
        hn::Store(walk_.cell.y, f_, s_.cell.y + at_);
        hn::Store(walk_.cell.z, f_, s_.cell.z + at_);
        return bitsOf(is(kEnded));
    }
    HWY_INLINE std::uint32_t metLanes() const { return bitsOf(is(kMet)); }

  private:
    HWY_INLINE Lanes3 load(const Vector3& v) const {
        return {hn::Load(f_, v.x + at_), hn::Load(f_, v.y + at_), hn::Load(f_, v.z + at_)};
    }
    HWY_INLINE IntMask is(Flying state) const { return hn::Eq(state_, hn::Set(i_, state)); }
    HWY_INLINE FloatMask asFloats(IntMask m) const { return hn::RebindMask(f_, m); }
    HWY_INLINE IntMask asInts(FloatMask m) const { return hn::RebindMask(i_, m); }
    // A random number for each of these lanes.
    HWY_INLINE UintV randomBits(FloatMask of) {
        const UintV bits =
            mixedBits(u_, hn::Add(hn::Mul(counter_, hn::Set(u_, 0x9e3779b9u)), hn::Load(u_, s_.key0 + at_)),
                      hn::Load(u_, s_.key1 + at_));
        counter_ = hn::IfThenElse(hn::RebindMask(u_, of), hn::Add(counter_, hn::Set(u_, 1u)), counter_);
        return bits;
    }
    // Of bits below 2^31.
    HWY_INLINE FloatV floatOf(UintV bits) const { return hn::ConvertTo(f_, hn::BitCast(i_, bits)); }
    HWY_INLINE FloatV random01(FloatMask of) {
        return hn::Mul(floatOf(hn::ShiftRight<8>(randomBits(of))), hn::Set(f_, 1.0f / 16777216.0f));
    }

    HWY_INLINE void drawDepths(IntMask of) {
        const FloatV drawn = exponentialDepth(f_, random01(asFloats(of)));
        depth_ = hn::IfThenElse(asFloats(of), drawn, depth_);
    }

    // Leaps over the clip's cut where a ray would collide within one, and draws another depth, as
    // nextTentative() does: these lanes no longer meet, and have no segment.
    HWY_INLINE void leaveCuts(FloatMask& meets, FloatV& inSegment) {
        if (hn::AllFalse(f_, meets)) return;
        FloatV cutEnd = hn::Set(f_, -1.0f);
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            const FloatV cutTo = hn::Load(f_, s_.cutTo[cut] + at_);
            const auto within = hn::And(hn::Le(hn::Load(f_, s_.cutFrom[cut] + at_), walk_.distance),
                                        hn::Lt(walk_.distance, cutTo));
            cutEnd = hn::IfThenElse(within, hn::Max(cutEnd, cutTo), cutEnd);
        }
        const auto leaps = hn::And(meets, hn::Ge(cutEnd, hn::Zero(f_)));
        if (hn::AllFalse(f_, leaps)) return;
        walk_.leap(leaps, cutEnd, t_.matter.voxels.grid);
        majorant_ = hn::IfThenZeroElse(leaps, majorant_);
        inSegment = hn::IfThenZeroElse(leaps, inSegment);
        drawDepths(asInts(leaps));
        meets = hn::AndNot(leaps, meets);
    }

    HWY_INLINE void nextSegment(FloatMask of) {
        const FloatV bound = walk_.nextSegment(of, t_.bounds, t_.matter.voxels.grid);
        const FloatV majorant = hn::Mul(hn::Max(bound, hn::Zero(f_)), looseness_);
        majorant_ = hn::IfThenElse(of, majorant, majorant_);
    }

    // One of the eight voxels around, drawn with its trilinear weight.
    struct Voxel {
        IntV x, y, z;
    };
    HWY_INLINE Voxel voxelByChance(FloatMask of, Lanes3 p) {
        const UintV bits = randomBits(of);
        const FloatV half = hn::Set(f_, 0.5f);
        const auto voxel = [&](FloatV at, UintV drawn, float scale, int count) HWY_ATTR {
            const FloatV moved =
                hn::MulAdd(hn::Add(floatOf(drawn), half), hn::Set(f_, scale), hn::Sub(at, half));
            const FloatV low = hn::Floor(hn::IfThenElseZero(of, moved));
            return hn::ConvertTo(i_, hn::Clamp(low, hn::Zero(f_), hn::Set(f_, float(count - 1))));
        };
        const glm::ivec3& size = t_.matter.voxels.size;
        const UintV eleven = hn::Set(u_, 2047u);
        return {voxel(p.x, hn::And(bits, eleven), 1.0f / 2048.0f, size.x),
                voxel(p.y, hn::And(hn::ShiftRight<11>(bits), eleven), 1.0f / 2048.0f, size.y),
                voxel(p.z, hn::ShiftRight<22>(bits), 1.0f / 1024.0f, size.z)};
    }

    HWY_INLINE FloatV stochasticEntry(FloatMask of, Lanes3 p) {
        const Voxel there = voxelByChance(of, p);
        return t_.matter.voxels.at(there.x, there.y, there.z);
    }

    // The extinction per mm at these points; it draws the steep part of the matter at random, as
    // steepByChance() of gradient.glsl does.
    HWY_INLINE FloatV extinctionAt(FloatMask met, Lanes3 at, FloatV entry) {
        const LaneMatter& matter = t_.matter;
        FloatV flat = matter.extinctionOfEntry(entry);
        FloatV dense = flat;
        FloatV part = hn::Zero(f_);
        if (matter.steep != nullptr) {
            dense = matter.steepExtinctionOfEntry(entry);
            const auto asks = hn::And(met, hn::Ne(dense, flat));
            if (!hn::AllFalse(f_, asks)) {
                const Voxel there = voxelByChance(asks, at);
                part = hn::IfThenElseZero(asks, matter.steepPart(there.x, there.y, there.z));
            }
            hn::BlendedStore(part, met, f_, s_.steep + at_);
        }
        const auto isMatter = hn::And(met, hn::Gt(hn::Max(flat, dense), hn::Zero(f_)));
        if (matter.gradientOpacity != nullptr && !hn::AllFalse(f_, isMatter)) {
            const FloatV opacity = matter.opacityByGradient(met, at);
            flat = matter.thinned(flat, opacity);
            dense = matter.steep == nullptr ? flat : matter.thinned(dense, opacity);
        }
        return matter.steep == nullptr ? flat : mixed(flat, dense, part);
    }

    // The rest of collide() in path.glsl, where a collision is real with this probability.
    HWY_INLINE void collideWith(FloatMask met, FloatV real) {
        const FloatV zero = hn::Zero(f_);
        const FloatV one = hn::Set(f_, 1.0f);
        const FloatV below = hn::Set(f_, NativeHost::kRouletteBelow);
        const auto above = hn::And(met, hn::Gt(real, hn::Set(f_, NativeHost::kRoundedBound)));
        if (!hn::AllFalse(f_, above)) {
            const IntV count = hn::Load(i_, s_.aboveBound + at_);
            hn::BlendedStore(hn::Add(count, hn::Set(i_, 1)), asInts(above), i_, s_.aboveBound + at_);
        }
        real = hn::Min(real, one);
        const FloatV chance = random01(met);
        const FloatV before = hn::Load(f_, s_.transmittance + at_);
        FloatV through = hn::Mul(before, hn::Sub(one, real));
        const FloatV survives = hn::IfThenElseZero(hn::Lt(hn::Mul(chance, below), through), below);
        through = hn::IfThenElse(hn::Lt(through, below), survives, through);
        const FloatV ofFlight = hn::IfThenZeroElse(hn::Lt(chance, real), one);
        const auto shadow = asFloats(hn::Ne(hn::Load(i_, s_.isShadow + at_), hn::Zero(i_)));
        const FloatV after = hn::IfThenElse(shadow, through, ofFlight);
        hn::BlendedStore(after, met, f_, s_.transmittance + at_);

        const auto ends = hn::And(met, hn::Eq(after, zero));
        state_ = hn::IfThenElse(asInts(met), hn::Set(i_, kNewRay), state_);
        state_ = hn::IfThenElse(asInts(ends), hn::Set(i_, kEnded), state_);
        tighten(met);
    }

    // After a stride of collisions, majorants become tight.
    HWY_INLINE void tighten(FloatMask met) {
        const IntV count = hn::Add(hn::Load(i_, s_.collisions + at_), hn::Set(i_, 1));
        hn::BlendedStore(count, asInts(met), i_, s_.collisions + at_);
        // A ray for which no collision is real, as with an infinite majorant, would never end.
        const auto gives = hn::And(met, asFloats(hn::Gt(count, hn::Set(i_, kMostCollisions))));
        state_ = hn::IfThenElse(asInts(gives), hn::Set(i_, kEnded), state_);
        const auto strides = hn::And(met, asFloats(hn::Eq(count, hn::Set(i_, NativeHost::kStride))));
        majorant_ = hn::IfThenElse(strides, hn::Div(majorant_, looseness_), majorant_);
        looseness_ = hn::IfThenElse(strides, hn::Set(f_, 1.0f), looseness_);
    }

    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr Uints u_{};

    Flights& s_;
    const FlightTables& t_;
    std::size_t at_;
    IntV state_;
    LaneWalk walk_;
    FloatV majorant_, looseness_, depth_;
    UintV counter_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
