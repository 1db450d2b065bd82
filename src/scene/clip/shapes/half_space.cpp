// A plane: along the patient's axes it is a face of keptBox, else it is oblique.
#include <algorithm>

#include "base/is_finite.h"
#include "scene/clip/clip_outline.h"
#include "scene/clip/edit_steps.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/handles_on_slice.h"

namespace macula::scene {

// The point lies on the diagonal that runs most along the normal: this is within the box wherever the plane
// meets the box. The point nearest to the middle would lie far outside a flat box.
glm::dvec3 fractionOnPlane(const glm::dvec3& normal, double fromMiddleMm, const Volume& volume) {
    const Box all = volume.worldBox();
    const double reach = glm::dot(0.5 * (all.high - all.low), glm::abs(normal));
    return 0.5 + 0.5 * std::clamp(fromMiddleMm / reach, -1.0, 1.0) * glm::sign(normal);
}

Result<OptionalClip> withPlaneThrough(const OptionalClip& clip, std::size_t plane, const glm::dvec3& pointMm,
                                      const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!clip || plane >= clip->clip.planes.size()) return notThere();
    const Box all = volume.worldBox();
    const glm::dvec3 normal = clip->clip.planes[plane].normal;
    const double reach = glm::dot(0.5 * (all.high - all.low), glm::abs(normal));
    const double voxel = glm::dot(voxelExtentMm(volume), glm::abs(normal));
    const double fromMiddle =
        std::clamp(glm::dot(normal, pointMm - all.centre()), -reach, std::max(reach - voxel, -reach));
    ClipPreset next = *clip;
    next.planesAt.at(plane) = fractionOnPlane(normal, fromMiddle, volume);
    return own(std::move(next), volume);
}

namespace {

class ShownPlane : public ShownShape {
  public:
    ShownPlane(const HalfSpace& plane, Keep keep, std::size_t number)
        : plane_(plane), keep_(keep), number_(number) {}

    bool isFace() const override { return isAlongAxis(plane_); }
    std::vector<Contour> removedOn(const slices::SliceFrame& frame) const override {
        return removedBySides({&plane_, 1}, keep_, frame);
    }
    // Where it crosses the outline of the volume.
    Contour lineOn(const slices::SliceFrame& frame, const Contour& volumeOutline) const override {
        if (isFace()) return {};
        const SideInPicture side(plane_, frame);
        Contour ends;
        for (std::size_t i = 0; i < volumeOutline.size(); ++i) {
            const glm::dvec2& p = volumeOutline[i];
            const glm::dvec2& q = volumeOutline[(i + 1) % volumeOutline.size()];
            const double a = side(p);
            const double b = side(q);
            if ((a >= 0.0) != (b >= 0.0)) ends.push_back(p + (a / (a - b)) * (q - p));
        }
        return ends.size() == 2 ? ends : Contour();
    }
    std::vector<glm::dvec3> dots(const PictureRays&, const Box& volumeMm) const override {
        return isFace() ? std::vector<glm::dvec3>() : dotsOfPlane(plane_, volumeMm);
    }
    std::vector<PlacedHandle> handles(const Box& volumeMm) const override {
        if (isFace()) return {};
        return {handleOfPlane(handle(), plane_, volumeMm)};
    }
    void addHandles(HandlesOnSlice& slice) const override {
        if (!isFace()) slice.addPlane(handle(), plane_);
    }
    Result<OptionalClip> withHandleAt(const OptionalClip& clip, const ClipHandle&, const glm::dvec3& mm,
                                      const Volume& volume) const override {
        return withPlaneThrough(clip, number_, mm, volume);
    }
    Result<OptionalClip> turnedInsideOut(ClipPreset clip, const Volume& volume) const override {
        clip.clip.planes.at(number_).normal *= -1.0;
        return own(std::move(clip), volume);
    }

  private:
    ClipHandle handle() const { return {.kind = ClipHandle::Kind::plane, .plane = number_}; }

    HalfSpace plane_;
    Keep keep_;
    std::size_t number_;
};

}  // namespace

ShownShapePtr shown(const HalfSpace& plane, Keep keep, std::size_t number) {
    return std::make_unique<ShownPlane>(plane, keep, number);
}

}  // namespace macula::scene
