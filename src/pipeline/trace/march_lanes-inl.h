// Marches along rays in the lanes of a vector: march() of shaders/lib/guides.glsl, and layerStep() of
// layers.glsl, which read copies of bricks.
//
// Included once for each instruction set by Highway, in macula::trace and its HWY_NAMESPACE; needs
// NativeHost.
#if defined(MACULA_MARCH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_MARCH_LANES_INL_H
#undef MACULA_MARCH_LANES_INL_H
#else
#define MACULA_MARCH_LANES_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/trace/brick_copies.h"
#include "pipeline/trace/cast_cells-inl.h"
#include "pipeline/trace/lane_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// The steep parts of the voxels in copies of bricks, at the same places.
class SteepCopies {
  public:
    // For so many copies at most.
    SteepCopies(const LaneMatter& matter, std::size_t copies)
        : matter_(matter),
          bricks_(copies, glm::ivec3(-1)),
          parts_(std::make_unique_for_overwrite<float[]>(copies * BrickCopies::kValues)) {}

    // Computes those of a brick's copy that begins there, unless they are still the same brick's.
    void hold(std::int32_t begin, const glm::ivec3& brick, const std::uint16_t* values) {
        glm::ivec3& held = bricks_[std::size_t(begin / BrickCopies::kValues)];
        if (held == brick) return;
        held = brick;
        compute(values + begin, parts_.get() + begin);
    }
    const float* parts() const { return parts_.get(); }

  private:
    void compute(const std::uint16_t* from, float* to) const {
        std::fill_n(to, BrickCopies::kValues, 0.0f);     // of the outermost voxels, which count 0 times
        constexpr int kVoxels = BrickCopies::kEdge - 2;  // along each axis: the others lack neighbours
        for (int z = 1; z <= kVoxels; ++z) {
            for (int y = 1; y <= kVoxels; ++y) {
                const int row = z * BrickCopies::kLayer + y * BrickCopies::kRow + 1;
                for (int x = 0; x < kVoxels; x += int(hn::Lanes(f_)))
                    hn::StoreU(steepPart(from + row + x), f_, to + row + x);
            }
        }
    }

    HWY_INLINE FloatV steepPart(const std::uint16_t* at) const {
        const hn::Rebind<std::uint16_t, Floats> halves;
        const hn::RebindToUnsigned<Floats> words;
        const auto difference = [&](int distance) HWY_ATTR {
            const auto value = [&](const std::uint16_t* there) HWY_ATTR {
                return hn::ConvertTo(f_, hn::BitCast(Ints(), hn::PromoteTo(words, hn::LoadU(halves, there))));
            };
            return hn::Mul(hn::Sub(value(at + distance), value(at - distance)), hn::Set(f_, 0.5f));
        };
        return matter_.steepPartOf(squareOf(matter_.worldGradient(
            {difference(1), difference(BrickCopies::kRow), difference(BrickCopies::kLayer)})));
    }

    static constexpr Floats f_{};

    const LaneMatter& matter_;
    std::vector<glm::ivec3> bricks_;  // by copy
    std::unique_ptr<float[]> parts_;
};

// What marches have found, by lane: see March.
struct Marches {
    static constexpr std::size_t kLanes = hn::MaxLanes(Floats());
    static constexpr int kLayers = NativeHost::kLayers;

    alignas(64) float opticalDepth[kLanes];
    alignas(64) float nearMm[kLanes];
    alignas(64) float halfMm[kLanes];
    alignas(64) float farMm[kLanes];
    alignas(64) float endMm[kLanes];
    alignas(64) float seen[kLanes];
    alignas(64) float seenMm[kLanes];
    alignas(64) float albedo[3][kLanes];
    alignas(64) float layerMm[kLayers][kLanes];

    NativeHost::March of(std::size_t lane) const {
        return {opticalDepth[lane], nearMm[lane],
                halfMm[lane],       farMm[lane],
                endMm[lane],        seen[lane],
                seenMm[lane],       {albedo[0][lane], albedo[1][lane], albedo[2][lane]}};
    }
};

// Used by one thread. For scenes without a second volume and without coloured segments.
class MarchLanes {
  public:
    MarchLanes(const HostTables<PooledVoxels>& tables, const NativeHost& host, const SceneKind& scene)
        : matter_(tables, host.params, scene.coarse, true),
          bounds_(tables.bounds),
          albedo_(&tables.albedo->x),
          steep_(tables.steep.empty() ? nullptr : &tables.steep.data()->x),
          hasClip_(host.useClip()),
          copies_(tables.voxels, host.params.volumeSize, 1),
          steepCopies_(matter_, steep_ == nullptr ? 0 : copies_.count()) {
        // Where opacity has risen to the middle of a layer, as in layerStep().
        for (int n = 0; n < Marches::kLayers; ++n)
            layerDepths_[n] = float(-std::log(1.0 - (2.0 * n + 1.0) / (2.0 * Marches::kLayers)));
    }

    // Marches along the lanes' walks; finds the layers too if wanted.
    void run(std::span<const NativeHost::BrickWalk> walks, bool findsLayers, Marches& found) {
        load(walks);
        auto active = hn::FirstN(f_, walks.size());
        auto seeking = active;
        for (rounds_ = 0; rounds_ < kMostRounds && !hn::AllFalse(f_, active); ++rounds_) {
            if (!hn::AllFalse(f_, seeking)) seek(seeking, active);
            const auto inside = hn::And(active, hn::Lt(hn::Add(from_, tiny_), walk_.segmentEnd));
            if (!hn::AllFalse(f_, inside)) step(inside, findsLayers, found);
            active = hn::And(active, hn::Lt(depth_, hn::Set(f_, NativeHost::kDepthOpaque)));
            seeking = hn::AndNot(hn::Lt(hn::Add(from_, tiny_), walk_.segmentEnd), active);
        }
        store(found);
    }

  private:
    static constexpr Floats f_{};
    static constexpr Ints i_{};
    static constexpr std::size_t kLanes = Marches::kLanes;
    static constexpr int kMostRounds = NativeHost::kMostRounds;

    struct Sample {
        FloatV extinction;
        FloatV entry;
        FloatV share;  // of the extinction due to steep matter
    };

    void load(std::span<const NativeHost::BrickWalk> walks);
    void store(Marches& found) const;
    HWY_INLINE void seek(FloatMask seeking, FloatMask& active);
    HWY_INLINE void enter(FloatMask of);
    HWY_INLINE void step(FloatMask of, bool findsLayers, Marches& found);
    HWY_INLINE Sample sampleAt(FloatMask of, FloatV atMm);
    HWY_INLINE void holdBricks(FloatMask of, FloatV atMm);
    HWY_INLINE Lanes3 positionAt(FloatV atMm) const;
    HWY_INLINE FloatMask isCut(FloatV atMm) const;
    HWY_INLINE void addAlbedo(const Sample& sample, FloatV seen);

    LaneMatter matter_;
    const float* bounds_;
    const float* albedo_;  // by entry, four numbers
    const float* steep_;   // likewise; null: there is no steep matter
    bool hasClip_;
    BrickCopies copies_;
    SteepCopies steepCopies_;
    float layerDepths_[Marches::kLayers];

    LaneWalk walk_;
    Lanes3 held_;  // the brick whose copy the lane reads
    alignas(64) std::int32_t copy_[kLanes];
    alignas(64) float cutFrom_[NativeHost::kCuts][kLanes];
    alignas(64) float cutTo_[NativeHost::kCuts][kLanes];
    int rounds_ = 0;
    FloatV coarse_, fine_, tiny_;  // steps, mm
    FloatV from_, step_, fineTo_, runTo_, last_, lastAdded_;
    FloatV depth_, near_, half_, far_, end_, seen_, seenMm_;
    Lanes3 colour_;
};

void MarchLanes::load(std::span<const NativeHost::BrickWalk> walks) {
    alignas(64) float numbers[14][kLanes] = {};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const NativeHost::BrickWalk& walk = walks[std::min(lane, walks.size() - 1)];
        for (int axis = 0; axis < 3; ++axis) {
            numbers[axis][lane] = walk.origin[axis];
            numbers[3 + axis][lane] = walk.direction[axis];
            numbers[6 + axis][lane] = walk.inverse[axis];
            numbers[9 + axis][lane] = walk.cell[axis];
        }
        numbers[12][lane] = walk.segmentEndMm;
        numbers[13][lane] = walk.endMm;
        for (int cut = 0; cut < NativeHost::kCuts; ++cut) {
            cutFrom_[cut][lane] = walk.cutFrom[cut];
            cutTo_[cut][lane] = walk.cutTo[cut];
        }
    }
    const auto three = [&](int n) HWY_ATTR {
        return Lanes3{hn::Load(f_, numbers[n]), hn::Load(f_, numbers[n + 1]), hn::Load(f_, numbers[n + 2])};
    };
    walk_ = {three(0),
             three(3),
             three(6),
             three(9),
             hn::Load(f_, numbers[12]),
             hn::Load(f_, numbers[13]),
             hn::Load(f_, numbers[12])};
    const FloatV none = hn::Set(f_, -1.0f);
    held_ = {none, none, none};
    for (std::int32_t& copy : copy_) copy = 0;
    const FloatV perMm =
        hn::Max(hn::Max(hn::Abs(walk_.direction.x), hn::Abs(walk_.direction.y)), hn::Abs(walk_.direction.z));
    coarse_ = hn::Div(hn::Set(f_, 1.0f), hn::Mul(perMm, hn::Set(f_, float(NativeHost::kBrickEdge))));
    fine_ = hn::Mul(coarse_, hn::Set(f_, 0.25f));
    tiny_ = hn::Mul(coarse_, hn::Set(f_, 1e-3f));
    step_ = coarse_;
    fineTo_ = runTo_ = near_ = half_ = far_ = none;
    from_ = last_ = lastAdded_ = depth_ = end_ = seen_ = seenMm_ = hn::Zero(f_);
    colour_ = {from_, from_, from_};
}

void MarchLanes::store(Marches& found) const {
    hn::Store(depth_, f_, found.opticalDepth);
    hn::Store(near_, f_, found.nearMm);
    hn::Store(half_, f_, found.halfMm);
    hn::Store(far_, f_, found.farMm);
    hn::Store(end_, f_, found.endMm);
    hn::Store(seen_, f_, found.seen);
    hn::Store(seenMm_, f_, found.seenMm);
    hn::Store(colour_.x, f_, found.albedo[0]);
    hn::Store(colour_.y, f_, found.albedo[1]);
    hn::Store(colour_.z, f_, found.albedo[2]);
}

// Moves seeking lanes on to their next segment with matter, as nextSegment() does; lanes at the end of their
// ray are no longer active.
HWY_INLINE void MarchLanes::seek(FloatMask seeking, FloatMask& active) {
    walk_.distance = hn::IfThenElse(seeking, walk_.segmentEnd, walk_.distance);
    auto goes = hn::And(seeking, hn::Lt(walk_.distance, walk_.end));
    auto found = hn::AndNot(seeking, seeking);
    for (; rounds_ < kMostRounds && !hn::AllFalse(f_, goes); ++rounds_) {
        const FloatV bound = walk_.nextSegment(goes, bounds_, matter_.voxels.grid);
        const auto here = hn::And(goes, hn::Gt(bound, hn::Zero(f_)));
        found = hn::Or(found, here);
        goes = hn::AndNot(here, goes);
        walk_.distance = hn::IfThenElse(goes, walk_.segmentEnd, walk_.distance);
        goes = hn::And(goes, hn::Lt(walk_.distance, walk_.end));
    }
    active = hn::AndNot(hn::AndNot(found, seeking), active);
    enter(found);
}

HWY_INLINE void MarchLanes::enter(FloatMask of) {
    from_ = hn::IfThenElse(of, walk_.distance, from_);
    const auto anew = hn::And(of, hn::Gt(from_, hn::Add(runTo_, tiny_)));
    last_ = hn::IfThenZeroElse(anew, last_);
    lastAdded_ = hn::IfThenZeroElse(anew, lastAdded_);
    runTo_ = hn::IfThenElse(of, walk_.segmentEnd, runTo_);
    fineTo_ = hn::IfThenElse(anew, hn::MulAdd(coarse_, hn::Set(f_, 0.5f), from_), fineTo_);
    step_ = hn::IfThenElse(anew, fine_, step_);
}

// The body of march()'s inner loop.
HWY_INLINE void MarchLanes::step(FloatMask of, bool findsLayers, Marches& found) {
    const FloatV half = hn::Set(f_, 0.5f);
    const FloatV step = hn::Min(step_, hn::Sub(walk_.segmentEnd, from_));
    const FloatV middle = hn::MulAdd(half, step, from_);
    const Sample sample = sampleAt(of, middle);
    const FloatV added = hn::Mul(sample.extinction, step);
    const FloatV muchDepth = hn::Set(f_, NativeHost::kFine);
    const auto again = hn::And(of, hn::And(hn::Gt(added, muchDepth), hn::Gt(step, fine_)));
    const FloatV before = hn::IfThenElse(again, hn::NegMulAdd(half, lastAdded_, depth_), depth_);
    const FloatV after = hn::IfThenElse(again, before, hn::Add(before, added));
    const FloatV perDepth = hn::Div(hn::Set(f_, 1.0f), hn::Max(sample.extinction, hn::Set(f_, 1e-20f)));
    const auto passes = [&](float depth, FloatV at) HWY_ATTR {
        const FloatV there = hn::Set(f_, depth);
        const auto crosses = hn::And(of, hn::And(hn::Lt(before, there), hn::Ge(after, there)));
        return hn::IfThenElse(crosses, hn::MulAdd(hn::Sub(there, before), perDepth, from_), at);
    };
    near_ = passes(NativeHost::kDepth3_4, near_);
    half_ = passes(NativeHost::kDepth1_2, half_);
    far_ = passes(NativeHost::kDepth1_4, far_);
    if (findsLayers)
        for (int n = 0; n < Marches::kLayers; ++n)
            hn::Store(passes(layerDepths_[n], hn::Load(f_, found.layerMm[n])), f_, found.layerMm[n]);
    const FloatV shown = hn::Min(after, hn::Set(f_, NativeHost::kDepth1_2));
    const FloatV seen = hn::IfThenElseZero(
        of, hn::Max(hn::Sub(hn::Exp(f_, hn::Neg(before)), hn::Exp(f_, hn::Neg(shown))), hn::Zero(f_)));
    seen_ = hn::Add(seen_, seen);
    seenMm_ = hn::MulAdd(seen, middle, seenMm_);
    if (!hn::AllFalse(f_, hn::Gt(seen, hn::Zero(f_)))) addAlbedo(sample, seen);
    const FloatV to = hn::Add(from_, step);
    end_ = hn::IfThenElse(hn::And(of, hn::Gt(after, before)), to, end_);
    depth_ = hn::IfThenElse(of, after, depth_);
    fineTo_ = hn::IfThenElse(again, to, fineTo_);
    from_ = hn::IfThenElse(again, hn::NegMulAdd(half, last_, from_), hn::IfThenElse(of, to, from_));
    last_ = hn::IfThenElse(of, hn::IfThenZeroElse(again, step), last_);
    lastAdded_ = hn::IfThenElse(of, hn::IfThenZeroElse(again, added), lastAdded_);
    const auto fine =
        hn::Or(hn::Lt(hn::Add(from_, tiny_), fineTo_), hn::Gt(added, hn::Mul(muchDepth, hn::Set(f_, 0.25f))));
    step_ = hn::IfThenElse(of, hn::IfThenElse(fine, fine_, coarse_), step_);
}

// Lets lanes hold copies of the bricks in which they are.
HWY_INLINE void MarchLanes::holdBricks(FloatMask of, FloatV atMm) {
    const glm::ivec3& grid = matter_.voxels.grid;
    const auto brickAt = [&](FloatV origin, FloatV direction, int count) HWY_ATTR {
        const FloatV at = hn::Floor(hn::MulAdd(direction, atMm, origin));
        return hn::Clamp(at, hn::Zero(f_), hn::Set(f_, float(count - 1)));
    };
    const Lanes3 brick{brickAt(walk_.origin.x, walk_.direction.x, grid.x),
                       brickAt(walk_.origin.y, walk_.direction.y, grid.y),
                       brickAt(walk_.origin.z, walk_.direction.z, grid.z)};
    const auto holds =
        hn::And(hn::Eq(brick.x, held_.x), hn::And(hn::Eq(brick.y, held_.y), hn::Eq(brick.z, held_.z)));
    const auto other = hn::AndNot(holds, of);
    if (hn::AllFalse(f_, other)) return;
    held_ = {hn::IfThenElse(other, brick.x, held_.x), hn::IfThenElse(other, brick.y, held_.y),
             hn::IfThenElse(other, brick.z, held_.z)};
    alignas(64) float x[kLanes], y[kLanes], z[kLanes];
    hn::Store(held_.x, f_, x);
    hn::Store(held_.y, f_, y);
    hn::Store(held_.z, f_, z);
    for (std::uint32_t lanes = bitsOf(hn::RebindMask(i_, other)); lanes != 0; lanes &= lanes - 1) {
        const auto lane = std::size_t(std::countr_zero(lanes));
        const glm::ivec3 there(x[lane], y[lane], z[lane]);
        copy_[lane] = copies_.hold(lane, there);
        if (steep_ != nullptr) steepCopies_.hold(copy_[lane], there, copies_.values());
    }
}

HWY_INLINE MarchLanes::Sample MarchLanes::sampleAt(FloatMask of, FloatV atMm) {
    holdBricks(of, atMm);
    const FloatV eight = hn::Set(f_, float(NativeHost::kBrickEdge));
    struct Between {
        FloatV within, part;  // the low voxel in the copy, and the position between it and the next
    };
    const auto between = [&](FloatV origin, FloatV direction, FloatV brick, int count) HWY_ATTR {
        const FloatV at = hn::MulSub(hn::MulAdd(direction, atMm, origin), eight,
                                     hn::Set(f_, NativeHost::kBrickShift + 0.5f));
        const FloatV q = hn::IfThenElseZero(of, hn::Clamp(at, hn::Zero(f_), hn::Set(f_, float(count - 1))));
        // The copy begins two voxels before the brick's own block; its last voxel has none behind it.
        const FloatV first = hn::MulSub(brick, eight, hn::Set(f_, 2.0f));
        const FloatV low =
            hn::Clamp(hn::Floor(hn::Sub(q, first)), hn::Zero(f_), hn::Set(f_, float(BrickCopies::kEdge - 2)));
        const FloatV part = hn::Sub(hn::Sub(q, first), low);
        return Between{low, hn::Clamp(part, hn::Zero(f_), hn::Set(f_, 1.0f))};
    };
    const glm::ivec3& size = matter_.voxels.size;
    const Between x = between(walk_.origin.x, walk_.direction.x, held_.x, size.x);
    const Between y = between(walk_.origin.y, walk_.direction.y, held_.y, size.y);
    const Between z = between(walk_.origin.z, walk_.direction.z, held_.z, size.z);
    const Lanes3 fraction{x.part, y.part, z.part};
    const IntV within =
        hn::ConvertTo(i_, hn::MulAdd(z.within, hn::Set(f_, float(BrickCopies::kLayer)),
                                     hn::MulAdd(y.within, hn::Set(f_, float(BrickCopies::kRow)), x.within)));
    const IntV place = hn::Add(hn::Load(i_, copy_), within);
    const LaneCorners values = LaneCells::corners(CopiedVoxels{copies_.values()}, hn::Add(place, place));

    Sample sample;
    sample.entry = interpolated(values, fraction);
    FloatV flat = matter_.extinctionOfEntry(sample.entry);
    FloatV dense = flat;
    FloatV part = hn::Zero(f_);
    if (steep_ != nullptr) {
        LaneCorners parts;
        for (int n = 0; n < 8; ++n) {
            const int distance = (n & 1) + (n >> 1 & 1) * BrickCopies::kRow + (n >> 2) * BrickCopies::kLayer;
            parts.at[n] = hn::GatherIndex(f_, steepCopies_.parts() + distance, place);
        }
        part = hn::Min(interpolated(parts, fraction), hn::Set(f_, 1.0f));
    }
    if (matter_.steep != nullptr) dense = matter_.steepExtinctionOfEntry(sample.entry);
    const auto isMatter = hn::And(of, hn::Gt(hn::Max(flat, dense), hn::Zero(f_)));
    if (matter_.gradientOpacity != nullptr && !hn::AllFalse(f_, isMatter)) {
        const FloatV opacity = matter_.opacityByGradient(of, positionAt(atMm));
        flat = matter_.thinned(flat, opacity);
        dense = matter_.thinned(dense, opacity);
    }
    sample.extinction = matter_.steep != nullptr ? mixed(flat, dense, part) : flat;
    sample.share = part;
    if (matter_.steep != nullptr)
        sample.share = hn::Div(hn::Mul(dense, part), hn::Max(sample.extinction, hn::Set(f_, 1e-20f)));
    if (matter_.mask != nullptr)
        sample.extinction = hn::IfThenZeroElse(matter_.isMasked(of, positionAt(atMm)), sample.extinction);
    if (hasClip_) sample.extinction = hn::IfThenZeroElse(isCut(atMm), sample.extinction);
    return sample;
}

// walkPositionAt().
HWY_INLINE Lanes3 MarchLanes::positionAt(FloatV atMm) const {
    const auto position = [&](FloatV origin, FloatV direction) HWY_ATTR {
        return hn::MulSub(hn::MulAdd(direction, atMm, origin), hn::Set(f_, float(NativeHost::kBrickEdge)),
                          hn::Set(f_, NativeHost::kBrickShift));
    };
    return {position(walk_.origin.x, walk_.direction.x), position(walk_.origin.y, walk_.direction.y),
            position(walk_.origin.z, walk_.direction.z)};
}

// Whether the clip removes what is there, as endOfCut().
HWY_INLINE FloatMask MarchLanes::isCut(FloatV atMm) const {
    auto is = hn::Lt(atMm, atMm);
    for (int cut = 0; cut < NativeHost::kCuts; ++cut)
        is = hn::Or(
            is, hn::And(hn::Le(hn::Load(f_, cutFrom_[cut]), atMm), hn::Lt(atMm, hn::Load(f_, cutTo_[cut]))));
    return is;
}

// Adds the albedo of samples, as albedoAt() has it, weighted by the opacity that they add.
HWY_INLINE void MarchLanes::addAlbedo(const Sample& sample, FloatV seen) {
    const IntV nearest = hn::ConvertTo(i_, hn::Add(sample.entry, hn::Set(f_, 0.5f)));
    const IntV first = hn::ShiftLeft<2>(nearest);
    const auto channel = [&](int n) HWY_ATTR {
        const FloatV flat = hn::GatherIndex(f_, albedo_ + n, first);
        return steep_ == nullptr ? flat : mixed(flat, hn::GatherIndex(f_, steep_ + n, first), sample.share);
    };
    colour_.x = hn::MulAdd(channel(0), seen, colour_.x);
    colour_.y = hn::MulAdd(channel(1), seen, colour_.y);
    colour_.z = hn::MulAdd(channel(2), seen, colour_.z);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
