// A corner, which is removed.
#include <algorithm>
#include <cmath>

#include "base/is_finite.h"
#include "scene/clip/edit_steps.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/handles_on_slice.h"

namespace macula::scene {

Result<OptionalClip> withCornerRemoved(const OptionalClip& clip, const std::array<Face, 3>& sides,
                                       const glm::dvec3& pointMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!isWithin(volume.worldBox(), pointMm))
        return refused(Text("The corner would be outside of the volume."),
                       Text("Move the cross-hair into the volume."));
    glm::dvec3 towards(0.0);
    for (const Face side : sides) towards[axisOf(side)] = isHigh(side) ? 1.0 : -1.0;
    ClipPreset next = clip.value_or(ClipPreset{});
    next.clip.cut = Octant{.pointMm = fractionOf(volume, pointMm), .towards = towards};
    return own(std::move(next), volume);
}

Result<OptionalClip> withCornerAt(const OptionalClip& clip, const glm::dvec3& pointMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!clip || !clip->clip.cut) return notThere();
    const Box all = volume.worldBox();
    ClipPreset next = *clip;
    next.clip.cut->pointMm = fractionOf(volume, glm::clamp(pointMm, all.low, all.high));
    return own(std::move(next), volume);
}

namespace {

// Keeps what the corner removes, as a box.
Result<OptionalClip> cornerKept(ClipPreset next, const Volume& volume) {
    const Octant corner = *clipFor(next, volume).cut;
    next.clip.cut.reset();
    Box kept = volume.worldBox();
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::clamp(corner.pointMm[axis], kept.low[axis], kept.high[axis]);
        (corner.towards[axis] > 0.0 ? kept.low : kept.high)[axis] = at;
    }
    if (!glm::all(glm::greaterThanEqual(kept.high - kept.low, voxelExtentMm(volume)))) return nothingLeft();
    return withKept(std::move(next), kept, volume);
}

class ShownCorner : public ShownShape {
  public:
    ShownCorner(const Octant& corner, Keep keep) : corner_(corner), keep_(keep) {}

    Text remark() const override { return Text("A corner is removed."); }
    std::vector<Contour> removedOn(const slices::SliceFrame& frame) const override {
        return removedBySides(sidesOf(corner_), keep_, frame);
    }
    Contour lineOn(const slices::SliceFrame& frame, const Contour& volumeOutline) const override {
        return closedLine(withinAll(volumeOutline, sidesOf(corner_), frame));
    }
    std::vector<PlacedHandle> handles(const Box&) const override {
        return {{.handle = {.kind = ClipHandle::Kind::corner}, .atMm = corner_.pointMm, .along = {}}};
    }
    void addHandles(HandlesOnSlice& slice) const override {
        const slices::SliceFrame& frame = slice.frame();
        const double offMm = frame.distanceMm(corner_.pointMm);
        const glm::dvec3 at = corner_.pointMm - offMm * frame.plane.normal();
        // Whether the slice passes through the part that the corner removes.
        const glm::dvec3 inside = at + slice.volumeMm().diagonal() * kOnFace * corner_.towards;
        const bool meets = std::ranges::all_of(sidesOf(corner_), [&](const HalfSpace& side) {
            const bool isAlong = std::abs(glm::dot(side.normal, frame.plane.normal())) < kAcross;
            return isAlong || side.contains(inside);
        });
        if (meets) slice.addPoint({.kind = ClipHandle::Kind::corner}, at, glm::dvec3(0.0));
    }
    Result<OptionalClip> withHandleAt(const OptionalClip& clip, const ClipHandle&, const glm::dvec3& mm,
                                      const Volume& volume) const override {
        return withCornerAt(clip, mm, volume);
    }
    Result<OptionalClip> turnedInsideOut(ClipPreset clip, const Volume& volume) const override {
        return cornerKept(std::move(clip), volume);
    }

  private:
    Octant corner_;
    Keep keep_;
};

}  // namespace

ShownShapePtr shown(const Octant& corner, Keep keep, std::size_t) {
    return std::make_unique<ShownCorner>(corner, keep);
}

}  // namespace macula::scene
