// A box: kept along the patient's axes it is the faces of keptBox, else it is removed, or turned.
#include <algorithm>
#include <cmath>

#include "scene/clip/clip_outline.h"
#include "scene/clip/edit_steps.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/handles_on_slice.h"

namespace macula::scene {

Result<OptionalClip> withRemovedFace(const OptionalClip& clip, Face face, double atMm, const Volume& volume) {
    if (!std::isfinite(atMm)) return notANumber();
    if (!clip || !clip->clip.box || clip->clip.ofBox != Keep::outside ||
        clip->clip.box->axes != glm::dmat3(1.0))
        return notThere();
    const OrientedBox now = *clipFor(*clip, volume).box;
    Box removed{now.centreMm - now.halfSizeMm, now.centreMm + now.halfSizeMm};
    const Box all = volume.worldBox();
    const int axis = axisOf(face);
    const double voxelMm = voxelExtentMm(volume)[axis];
    const double at = std::clamp(atMm, all.low[axis], all.high[axis]);
    setFaceMm(removed, face,
              isHigh(face) ? std::max(at, removed.low[axis] + voxelMm)
                           : std::min(at, removed.high[axis] - voxelMm));
    ClipPreset next = *clip;
    next.clip.box = boxOf(fractionsOf(removed, volume));
    return own(std::move(next), volume);
}

namespace {

class ShownBox : public ShownShape {
  public:
    ShownBox(const OrientedBox& box, Keep keep) : box_(box), keep_(keep) {}

    bool isFace() const override { return keep_ == Keep::inside && isAlongPatient(); }
    Text remark() const override {
        if (isFace()) return {};
        return keep_ == Keep::outside ? Text("A box is removed.") : Text("Only a turned box is kept.");
    }
    std::vector<Contour> removedOn(const slices::SliceFrame& frame) const override {
        return removedBySides(sidesOf(box_), keep_, frame);
    }
    Contour lineOn(const slices::SliceFrame& frame, const Contour& volumeOutline) const override {
        return isFace() ? Contour() : closedLine(withinAll(volumeOutline, sidesOf(box_), frame));
    }
    std::vector<glm::dvec3> dots(const PictureRays&, const Box& volumeMm) const override {
        return hasFaces() ? dotsOfBox(common(corners(), volumeMm)) : std::vector<glm::dvec3>();
    }
    std::vector<PlacedHandle> handles(const Box& volumeMm) const override {
        if (!hasFaces()) return {};
        return handlesOfFaces(ClipHandle::Kind::removedFace, common(corners(), volumeMm));
    }
    void addHandles(HandlesOnSlice& slice) const override {
        if (hasFaces()) slice.addFaces(ClipHandle::Kind::removedFace, common(corners(), slice.volumeMm()));
    }
    Result<OptionalClip> withHandleAt(const OptionalClip& clip, const ClipHandle& handle,
                                      const glm::dvec3& mm, const Volume& volume) const override {
        return withRemovedFace(clip, handle.face, mm[axisOf(handle.face)], volume);
    }
    Result<OptionalClip> turnedInsideOut(ClipPreset clip, const Volume& volume) const override {
        clip.clip.ofBox = keep_ == Keep::inside ? Keep::outside : Keep::inside;
        if (!keepsBox(clip.clip)) return own(std::move(clip), volume);
        MACULA_TRY(const Box kept, keptBox(clip, volume));
        return withKept(std::move(clip), kept, volume);
    }
    std::optional<HandTool> handTool() const override {
        // Along the patient's axes, however the hand is turned: only such a box can be stored with the study.
        const auto remove = [](Clip& clip, const glm::dvec3& centreMm, double halfMm) {
            clip.box =
                OrientedBox{.centreMm = centreMm, .axes = glm::dmat3(1.0), .halfSizeMm = glm::dvec3(halfMm)};
            clip.ofBox = Keep::outside;
        };
        return HandTool{.key = OrientedBox::kKey, .name = Text("box"), .place = 2, .remove = remove};
    }

  private:
    bool isAlongPatient() const { return box_.axes == glm::dmat3(1.0); }
    bool hasFaces() const { return keep_ == Keep::outside && isAlongPatient(); }  // that a hand can move
    Box corners() const { return {box_.centreMm - box_.halfSizeMm, box_.centreMm + box_.halfSizeMm}; }

    OrientedBox box_;
    Keep keep_;
};

}  // namespace

ShownShapePtr shown(const OrientedBox& box, Keep keep, std::size_t) {
    return std::make_unique<ShownBox>(box, keep);
}

}  // namespace macula::scene
