// The cells between eight voxel centres that cast rays cross: shaders/lib/cell_walk.glsl by lanes of vectors,
// which read copies of bricks.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
#if defined(MACULA_CAST_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_CAST_CELLS_INL_H
#undef MACULA_CAST_CELLS_INL_H
#else
#define MACULA_CAST_CELLS_INL_H
#endif

#include <hwy/highway.h>

#include "pipeline/trace/cast_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// More cells than a ray can cross in a brick.
constexpr int kMostCells = 64;

// By corner of a cell: x + 2 y + 4 z.
struct LaneCorners {
    FloatV at[8];
};

HWY_INLINE FloatV interpolated(const LaneCorners& c, const Lanes3& fraction) {
    const auto layer = [&](int first) HWY_ATTR {
        return mixed(mixed(c.at[first], c.at[first + 1], fraction.x),
                     mixed(c.at[first + 2], c.at[first + 3], fraction.x), fraction.y);
    };
    return mixed(layer(0), layer(4), fraction.z);
}

// Two neighbours along x.
struct LanePair {
    FloatV low, high;
};

// The values in copies of bricks.
struct CopiedVoxels {
    const std::uint16_t* values;

    // `first` counts bytes, `distance` values.
    HWY_INLINE LanePair pair(IntV first, int distance) const {
        const Floats f;
        const Ints i;
        const Uints u;
        const UintV both = hn::BitCast(u, wordAt(first, distance));
        return {hn::ConvertTo(f, hn::BitCast(i, hn::And(both, hn::Set(u, 0xffffu)))),
                hn::ConvertTo(f, hn::BitCast(i, hn::ShiftRight<16>(both)))};
    }

    HWY_INLINE FloatV low(IntV first, int distance) const {
        const Ints i;
        return hn::ConvertTo(Floats(), hn::And(wordAt(first, distance), hn::Set(i, 0xffff)));
    }

  private:
    HWY_INLINE IntV wordAt(IntV first, int distance) const {
        const Ints i;
        const IntV at = hn::Add(first, hn::Set(i, 2 * distance));
#if HWY_TARGET == HWY_SCALAR
        std::int32_t word = 0;
        std::memcpy(&word, values + hn::GetLane(at) / 2, sizeof(word));
        return hn::Set(i, word);
#else
        return hn::GatherOffset(i, reinterpret_cast<const std::int32_t*>(values), at);
#endif
    }
};

// The cells in which the lanes are.
class LaneCells {
  public:
    HWY_INLINE explicit LaneCells(CastRays& rays)
        : r_(rays),
          origin_(rays.voxelOrigin.load()),
          direction_(rays.voxelDirection.load()),
          inverse_(rays.voxelInverse.load()),
          cell_(rays.cell.load()),
          firstCell_(rays.firstCell.load()),
          distance_(hn::Load(f_, rays.distanceMm)),
          end_(hn::Load(f_, rays.pieceEndMm)),
          from_(hn::Load(f_, rays.fromMm)),
          to_(hn::Load(f_, rays.toMm)),
          cells_(hn::Load(i_, rays.cells)) {}

    HWY_INLINE void store() const {
        r_.cell.store(cell_);
        hn::Store(distance_, f_, r_.distanceMm);
        hn::Store(from_, f_, r_.fromMm);
        hn::Store(to_, f_, r_.toMm);
        hn::Store(cells_, i_, r_.cells);
    }

    // Enters the first cell of a piece; the brick is that of BrickCopies.
    HWY_INLINE void enter(FloatMask of) {
        from_ = hn::IfThenElse(of, distance_, from_);
        const auto cellAt = [&](FloatV origin, FloatV direction, FloatV cell) HWY_ATTR {
            const FloatV at = hn::MulAdd(direction, from_, origin);
            // At a face, the cell ahead.
            const FloatV there = hn::IfThenElse(hn::Lt(direction, hn::Zero(f_)),
                                                hn::Sub(hn::Ceil(at), hn::Set(f_, 1.0f)), hn::Floor(at));
            return hn::IfThenElse(of, there, cell);
        };
        cell_.x = cellAt(origin_.x, direction_.x, cell_.x);
        cell_.y = cellAt(origin_.y, direction_.y, cell_.y);
        cell_.z = cellAt(origin_.z, direction_.z, cell_.z);
        cells_ = hn::IfThenZeroElse(intMask(of), cells_);
        leaveAt(of, faces());
    }

    // nextCell() of cell_walk.glsl for leaving lanes: these then cross their next cell or, at the end of
    // their piece, seek another. Returns the states.
    HWY_INLINE IntV advance(IntV state) {
        const auto leaving = lanesIn(state, kLeaving);
        const auto of = floatMask(leaving);
        // Rounding must not keep a ray in a brick for ever.
        const auto goes =
            hn::And(hn::And(of, hn::Lt(to_, end_)), floatMask(hn::Lt(cells_, hn::Set(i_, kMostCells))));
        const Lanes3 face = faces();
        const auto x = hn::And(goes, hn::Le(face.x, hn::Min(face.y, face.z)));
        const auto y = hn::AndNot(x, hn::And(goes, hn::Le(face.y, face.z)));
        const auto z = hn::AndNot(hn::Or(x, y), goes);
        cell_.x = hn::IfThenElse(x, hn::Add(cell_.x, stepOf(direction_.x)), cell_.x);
        cell_.y = hn::IfThenElse(y, hn::Add(cell_.y, stepOf(direction_.y)), cell_.y);
        cell_.z = hn::IfThenElse(z, hn::Add(cell_.z, stepOf(direction_.z)), cell_.z);
        cells_ = hn::IfThenElse(intMask(of), hn::Add(cells_, hn::Set(i_, 1)), cells_);
        from_ = hn::IfThenElse(goes, to_, from_);
        leaveAt(goes, faces());
        const auto ended = hn::AndNot(goes, of);
        distance_ = hn::IfThenElse(ended, end_, distance_);
        return moved(moved(state, leaving, kCrossing), intMask(ended), kSeeking);
    }

    // The low corner, within the brick: rounding may carry a cell across the brick's face.
    HWY_INLINE Lanes3 low() const {
        const FloatV seven = hn::Set(f_, 7.0f);
        const auto within = [&](FloatV cell, FloatV first)
                                HWY_ATTR { return hn::Clamp(cell, first, hn::Add(first, seven)); };
        return {within(cell_.x, firstCell_.x), within(cell_.y, firstCell_.y), within(cell_.z, firstCell_.z)};
    }

    // Where the voxel at the low corner lies in the copies, in bytes.
    HWY_INLINE IntV placeOf(const Lanes3& low) const {
        const FloatV place =
            hn::MulAdd(hn::Sub(low.z, firstCell_.z), hn::Set(f_, float(2 * BrickCopies::kLayer)),
                       hn::MulAdd(hn::Sub(low.y, firstCell_.y), hn::Set(f_, float(2 * BrickCopies::kRow)),
                                  hn::Add(hn::Sub(low.x, firstCell_.x), hn::Sub(low.x, firstCell_.x))));
        const IntV first = hn::Add(hn::Load(i_, r_.copy), hn::Set(i_, BrickCopies::kFirstCell));
        return hn::Add(hn::ConvertTo(i_, place), hn::Add(first, first));
    }

    HWY_INLINE Lanes3 fractionAt(const Lanes3& low, FloatV atMm) const {
        const auto fraction = [&](FloatV origin, FloatV direction, FloatV from) HWY_ATTR {
            return hn::Clamp(hn::Sub(hn::MulAdd(direction, atMm, origin), from), hn::Zero(f_),
                             hn::Set(f_, 1.0f));
        };
        return {fraction(origin_.x, direction_.x, low.x), fraction(origin_.y, direction_.y, low.y),
                fraction(origin_.z, direction_.z, low.z)};
    }

    HWY_INLINE FloatV from() const { return from_; }
    HWY_INLINE FloatV to() const { return to_; }

    static HWY_INLINE LaneCorners corners(const CopiedVoxels& voxels, IntV place) {
        const LanePair a = voxels.pair(place, 0);
        const LanePair b = voxels.pair(place, BrickCopies::kRow);
        const LanePair c = voxels.pair(place, BrickCopies::kLayer);
        const LanePair d = voxels.pair(place, BrickCopies::kLayer + BrickCopies::kRow);
        return {{a.low, a.high, b.low, b.high, c.low, c.high, d.low, d.high}};
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};

    HWY_INLINE FloatV stepOf(FloatV direction) const {
        const FloatV one = hn::Set(f_, 1.0f);
        return hn::IfThenElse(hn::Lt(direction, hn::Zero(f_)), hn::Neg(one), one);
    }

    // Where the ray meets the faces through which it can leave its cell.
    HWY_INLINE Lanes3 faces() const {
        const auto face = [&](FloatV origin, FloatV direction, FloatV inverse, FloatV cell) HWY_ATTR {
            const FloatV ahead = hn::IfThenZeroElse(hn::Lt(direction, hn::Zero(f_)), hn::Set(f_, 1.0f));
            return hn::Mul(hn::Sub(hn::Add(cell, ahead), origin), inverse);
        };
        return {face(origin_.x, direction_.x, inverse_.x, cell_.x),
                face(origin_.y, direction_.y, inverse_.y, cell_.y),
                face(origin_.z, direction_.z, inverse_.z, cell_.z)};
    }

    HWY_INLINE void leaveAt(FloatMask of, const Lanes3& face) {
        const FloatV exit = hn::Min(hn::Min(face.x, face.y), face.z);
        // A ray that is not a number leaves its brick, too.
        const FloatV to = hn::IfThenElse(hn::Eq(exit, exit), hn::Min(hn::Max(exit, from_), end_), end_);
        to_ = hn::IfThenElse(of, to, to_);
    }

    CastRays& r_;
    Lanes3 origin_, direction_, inverse_, cell_, firstCell_;
    FloatV distance_;  // from which the search for another piece goes on
    FloatV end_, from_, to_;
    IntV cells_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
