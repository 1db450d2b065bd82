#include "scene/clip/edited_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/is_finite.h"
#include "scene/clip/clip_shapes.h"
#include "scene/clip/edit_steps.h"

namespace macula::scene {

namespace {

constexpr double kSamePlace = 1e-6;  // in voxels: a face that is there already

Text textOf(Face side) {
    switch (side) {
        case Face::right:
            return Text("right");
        case Face::left:
            return Text("left");
        case Face::anterior:
            return Text("anterior");
        case Face::posterior:
            return Text("posterior");
        case Face::inferior:
            return Text("inferior");
        case Face::superior:
            return Text("superior");
    }
    return {};
}

}  // namespace

Result<OptionalClip> withFace(const OptionalClip& clip, Face face, double atMm, const Volume& volume) {
    if (!std::isfinite(atMm)) return notANumber();
    MACULA_TRY(Box kept, keptBox(clip, volume));
    const Box all = volume.worldBox();
    const int axis = axisOf(face);
    const double voxelMm = voxelExtentMm(volume)[axis];
    double& low = kept.low[axis];
    double& high = kept.high[axis];
    if (isHigh(face)) {
        high = std::clamp(atMm, std::min(low + voxelMm, all.high[axis]), all.high[axis]);
        low = std::min(low, std::max(high - voxelMm, all.low[axis]));
    } else {
        low = std::clamp(atMm, all.low[axis], std::max(high - voxelMm, all.low[axis]));
        high = std::max(high, std::min(low + voxelMm, all.high[axis]));
    }
    return withKept(clip.value_or(ClipPreset{}), kept, volume);
}

Result<OptionalClip> withFaceOpen(const OptionalClip& clip, Face face, const Volume& volume) {
    return withFace(clip, face, faceMm(volume.worldBox(), face), volume);
}

Result<OptionalClip> withSideRemoved(const OptionalClip& clip, Face side, const glm::dvec3& pointMm,
                                     const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    MACULA_TRY(const Box kept, keptBox(clip, volume));
    const int axis = axisOf(side);
    const double atMm = pointMm[axis];
    const double voxelMm = voxelExtentMm(volume)[axis];
    const double removedMm = isHigh(side) ? kept.high[axis] - atMm : atMm - kept.low[axis];
    if (removedMm < kSamePlace * voxelMm)
        return refused(Text("Nothing is left to remove on the {} side.", textOf(side)),
                       Text("Move the cross-hair into what is shown."));
    const double leftMm = isHigh(side) ? atMm - kept.low[axis] : kept.high[axis] - atMm;
    if (leftMm < voxelMm) return nothingLeft();
    return withFace(clip, side, atMm, volume);
}

Result<OptionalClip> withSlabKept(const OptionalClip& clip, slices::Orientation orientation,
                                  const glm::dvec3& pointMm, double thicknessMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!std::isfinite(thicknessMm) || thicknessMm <= 0.0)
        return refused(Text("The slab has no thickness."), Text("Give it in mm, more than 0."));
    MACULA_TRY(Box kept, keptBox(clip, volume));
    const Box all = volume.worldBox();
    const int axis = orientation == slices::Orientation::axial     ? 2
                     : orientation == slices::Orientation::coronal ? 1
                                                                   : 0;
    const double atMm = pointMm[axis];
    if (atMm < all.low[axis] || atMm > all.high[axis])
        return refused(Text("The slab would be outside of the volume."),
                       Text("Move the cross-hair into the volume."));
    const double voxelMm = voxelExtentMm(volume)[axis];
    const double halfMm = 0.5 * std::max(thicknessMm, voxelMm);
    double& low = kept.low[axis];
    double& high = kept.high[axis];
    low = std::max(all.low[axis], atMm - halfMm);
    high = std::min(all.high[axis], atMm + halfMm);
    high = std::max(high, std::min(low + voxelMm, all.high[axis]));
    low = std::min(low, std::max(high - voxelMm, all.low[axis]));
    return withKept(clip.value_or(ClipPreset{}), kept, volume);
}

Result<OptionalClip> turnedInsideOut(const OptionalClip& clip, const Volume& volume) {
    if (!clip || !clip->clip.hasShape())
        return refused(Text("There is no clip to turn inside out."),
                       Text("Choose a clip, or cut something off."));
    const std::vector<ShownShapePtr> shapes = shownShapes(clipFor(*clip, volume));
    const std::ptrdiff_t faces =
        std::ranges::count_if(shapes, [](const ShownShapePtr& shape) { return shape->isFace(); });
    const std::ptrdiff_t parts = std::ptrdiff_t(shapes.size()) - faces + (faces > 0 ? 1 : 0);
    if (parts != 1)
        return refused(Text("Only a clip of one part can be turned inside out."),
                       Text("This one has {}; begin without a clip.", parts));
    if (faces == 0) return shapes.front()->turnedInsideOut(*clip, volume);
    MACULA_TRY(const Box kept, keptBox(clip, volume));
    ClipPreset next = *clip;
    removeFaces(next);
    next.clip.box = boxOf(fractionsOf(kept, volume));
    next.clip.ofBox = Keep::outside;
    return own(std::move(next), volume);
}

}  // namespace macula::scene
