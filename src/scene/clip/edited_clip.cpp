#include "scene/clip/edited_clip.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/is_finite.h"

namespace macula::scene {

namespace {

constexpr double kMostRadius = 10.0;  // the limit of the JSON, in shortest sides of the volume
// An open face lies this far beyond the volume, as a fraction of its size: on the border itself, rounding
// would decide about the outermost voxels.
constexpr double kBeyond = 0.5;
constexpr double kAtBorder = 1e-9;   // a face nearer to the border counts as open; a fraction of the size
constexpr double kSamePlace = 1e-6;  // in voxels: a face that is there already

Error error(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

Error notANumber() {
    return error(Text("The place of the clip is not a number."), Text("Give it in mm."));
}

Error nothingLeft() {
    return error(Text("Nothing of the volume would be left."),
                 Text("Choose another place, or begin without a clip."));
}

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

bool isWithin(const Box& box, const glm::dvec3& point) {
    return glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high));
}

glm::dvec3 fractionOf(const Volume& volume, const glm::dvec3& pointMm) {
    const Box all = volume.worldBox();
    return (pointMm - all.low) / (all.high - all.low);
}

// The last step of every edit.
Result<OptionalClip> own(ClipPreset next, const Volume& volume) {
    next.name = kOwnClipName;
    next.title = "Own clip";
    if (next == ClipPreset{.name = next.name, .title = next.title, .clip = {}, .planesAt = {}})
        return OptionalClip{};
    Clip clip = clipFor(next, volume);
    clip.greyFaces.reset();  // belongs to the series, not to the edit
    MACULA_TRY_VOID(validate(clip));
    const Box voxels{glm::dvec3(-0.5), glm::dvec3(volume.size()) - 0.5};
    if (removesAll(clip, volume.worldFromVoxel(), voxels)) return nothingLeft();
    return OptionalClip(std::move(next));
}

void removeFaces(ClipPreset& clip) {
    if (keepsBox(clip.clip)) clip.clip.box.reset();
    std::vector<HalfSpace> planes;
    std::vector<glm::dvec3> at;
    for (std::size_t i = 0; i < clip.clip.planes.size(); ++i) {
        if (isAlongAxis(clip.clip.planes[i])) continue;
        planes.push_back(clip.clip.planes[i]);
        at.push_back(clip.planesAt.at(i));
    }
    clip.clip.planes = std::move(planes);
    clip.planesAt = std::move(at);
}

bool isOpen(Face face, const Box& fractions) {
    const double at = faceMm(fractions, face);
    return isHigh(face) ? at >= 1.0 - kAtBorder : at <= kAtBorder;
}

// The box in fractions of the volume; its open faces lie beyond the volume.
OrientedBox boxOf(const Box& fractions) {
    Box box = fractions;
    for (const Face face : kFaces) {
        if (isOpen(face, fractions)) setFaceMm(box, face, isHigh(face) ? 1.0 + kBeyond : -kBeyond);
    }
    return {.centreMm = box.centre(), .halfSizeMm = 0.5 * (box.high - box.low)};
}

Box fractionsOf(const Box& boxMm, const Volume& volume) {
    return {fractionOf(volume, boxMm.low), fractionOf(volume, boxMm.high)};
}

Result<OptionalClip> withKept(ClipPreset next, const Box& keptMm, const Volume& volume) {
    removeFaces(next);
    const Box fractions = fractionsOf(keptMm, volume);
    std::vector<Face> cut;
    std::copy_if(kFaces.begin(), kFaces.end(), std::back_inserter(cut),
                 [&](Face face) { return !isOpen(face, fractions); });
    if (cut.empty()) return own(std::move(next), volume);
    if (!next.clip.box) {
        next.clip.box = boxOf(fractions);
        next.clip.ofBox = Keep::inside;
        return own(std::move(next), volume);
    }
    if (next.clip.planes.size() + cut.size() > Clip::kMostPlanes)
        return error(Text("A clip with a box of another kind has six planes and no more."),
                     Text("Open another face first, or begin without a clip."));
    for (const Face face : cut) {
        const int axis = axisOf(face);
        HalfSpace plane{.normal = glm::dvec3(0.0), .offsetMm = 0.0};
        plane.normal[axis] = isHigh(face) ? -1.0 : 1.0;
        glm::dvec3 at(0.5);
        at[axis] = faceMm(fractions, face);
        next.clip.planes.push_back(plane);
        next.planesAt.push_back(at);
    }
    return own(std::move(next), volume);
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
        return error(Text("Nothing is left to remove on the {} side.", textOf(side)),
                     Text("Move the cross-hair into what is shown."));
    const double leftMm = isHigh(side) ? atMm - kept.low[axis] : kept.high[axis] - atMm;
    if (leftMm < voxelMm) return nothingLeft();
    return withFace(clip, side, atMm, volume);
}

Result<OptionalClip> withSlabKept(const OptionalClip& clip, slices::Orientation orientation,
                                  const glm::dvec3& pointMm, double thicknessMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!std::isfinite(thicknessMm) || thicknessMm <= 0.0)
        return error(Text("The slab has no thickness."), Text("Give it in mm, more than 0."));
    MACULA_TRY(Box kept, keptBox(clip, volume));
    const Box all = volume.worldBox();
    const int axis = orientation == slices::Orientation::axial     ? 2
                     : orientation == slices::Orientation::coronal ? 1
                                                                   : 0;
    const double atMm = pointMm[axis];
    if (atMm < all.low[axis] || atMm > all.high[axis])
        return error(Text("The slab would be outside of the volume."),
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

Result<OptionalClip> withCornerRemoved(const OptionalClip& clip, const std::array<Face, 3>& sides,
                                       const glm::dvec3& pointMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!isWithin(volume.worldBox(), pointMm))
        return error(Text("The corner would be outside of the volume."),
                     Text("Move the cross-hair into the volume."));
    glm::dvec3 towards(0.0);
    for (const Face side : sides) towards[axisOf(side)] = isHigh(side) ? 1.0 : -1.0;
    ClipPreset next = clip.value_or(ClipPreset{});
    next.clip.cut = Octant{.pointMm = fractionOf(volume, pointMm), .towards = towards};
    return own(std::move(next), volume);
}

ValueRange ballRadiiMm(const Volume& volume) {
    const Box all = volume.worldBox();
    const glm::dvec3 size = all.high - all.low;
    const glm::dvec3 spacing = volume.spacingMm();
    const double most = std::min(kMostRadius * std::min({size.x, size.y, size.z}), all.diagonal());
    return {.low = std::min(0.5 * std::min({spacing.x, spacing.y, spacing.z}), most), .high = most};
}

Result<OptionalClip> withBallRemoved(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                     const Volume& volume) {
    if (!isFinite(centreMm)) return notANumber();
    const ValueRange radii = ballRadiiMm(volume);
    if (!(radii.low <= radiusMm && radiusMm <= radii.high))
        return error(Text("A ball of that size is not possible here."),
                     Text("Give a radius from {:.4g} to {:.4g} mm.", radii.low, radii.high));
    const Box all = volume.worldBox();
    if (!isWithin(all, centreMm))
        return error(Text("The ball would be outside of the volume."),
                     Text("Move the cross-hair into the volume."));
    const glm::dvec3 size = all.high - all.low;
    ClipPreset next = clip.value_or(ClipPreset{});
    next.clip.ball = Ball{.centreMm = fractionOf(volume, centreMm),
                          .radiusMm = std::min(radiusMm / std::min({size.x, size.y, size.z}), kMostRadius)};
    next.clip.ofBall = Keep::outside;
    return own(std::move(next), volume);
}

// The point lies on the diagonal that runs most along the normal: this is within the box wherever the plane
// meets the box. The point nearest to the middle would lie far outside a flat box.
glm::dvec3 fractionOnPlane(const glm::dvec3& normal, double fromMiddleMm, const Volume& volume) {
    const Box all = volume.worldBox();
    const double reach = glm::dot(0.5 * (all.high - all.low), glm::abs(normal));
    return 0.5 + 0.5 * std::clamp(fromMiddleMm / reach, -1.0, 1.0) * glm::sign(normal);
}

namespace {

Error notThere() {
    return error(Text("That part of the clip is not there any more."), Text("Take hold of another one."));
}

glm::dvec3 nearestIn(const Box& box, const glm::dvec3& point) {
    return glm::clamp(point, box.low, box.high);
}

}  // namespace

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

Result<OptionalClip> withCornerAt(const OptionalClip& clip, const glm::dvec3& pointMm, const Volume& volume) {
    if (!isFinite(pointMm)) return notANumber();
    if (!clip || !clip->clip.cut) return notThere();
    ClipPreset next = *clip;
    next.clip.cut->pointMm = fractionOf(volume, nearestIn(volume.worldBox(), pointMm));
    return own(std::move(next), volume);
}

Result<OptionalClip> withBallAt(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                const Volume& volume) {
    if (!isFinite(centreMm) || !std::isfinite(radiusMm)) return notANumber();
    if (!clip || !clip->clip.ball) return notThere();
    const ValueRange radii = ballRadiiMm(volume);
    const Box all = volume.worldBox();
    const glm::dvec3 size = all.high - all.low;
    ClipPreset next = *clip;
    next.clip.ball = Ball{
        .centreMm = fractionOf(volume, nearestIn(all, centreMm)),
        .radiusMm = std::min(std::clamp(radiusMm, radii.low, radii.high) / std::min({size.x, size.y, size.z}),
                             kMostRadius)};
    return own(std::move(next), volume);
}

namespace {

struct Parts {
    bool faces = false;
    std::ptrdiff_t obliquePlanes = 0;
    bool otherBox = false;  // removed, or turned
    bool corner = false;
    bool ball = false;

    std::ptrdiff_t count() const {
        return std::ptrdiff_t(faces) + obliquePlanes + std::ptrdiff_t(otherBox) + std::ptrdiff_t(corner) +
               std::ptrdiff_t(ball);
    }
};

Parts partsOf(const Clip& clip) {
    const std::ptrdiff_t alongAxes = std::count_if(clip.planes.begin(), clip.planes.end(), isAlongAxis);
    return {.faces = keepsBox(clip) || alongAxes > 0,
            .obliquePlanes = std::ptrdiff_t(clip.planes.size()) - alongAxes,
            .otherBox = clip.box.has_value() && !keepsBox(clip),
            .corner = clip.cut.has_value(),
            .ball = clip.ball.has_value()};
}

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

}  // namespace

Result<OptionalClip> turnedInsideOut(const OptionalClip& clip, const Volume& volume) {
    if (!clip || !clip->clip.hasShape())
        return error(Text("There is no clip to turn inside out."),
                     Text("Choose a clip, or cut something off."));
    const Parts parts = partsOf(clip->clip);
    if (parts.count() != 1)
        return error(Text("Only a clip of one part can be turned inside out."),
                     Text("This one has {}; begin without a clip.", parts.count()));
    ClipPreset next = *clip;
    if (parts.corner) return cornerKept(std::move(next), volume);
    if (parts.ball) {
        next.clip.ofBall = next.clip.ofBall == Keep::inside ? Keep::outside : Keep::inside;
    } else if (parts.obliquePlanes == 1) {
        next.clip.planes.front().normal *= -1.0;
    } else if (parts.faces) {
        MACULA_TRY(const Box kept, keptBox(clip, volume));
        removeFaces(next);
        next.clip.box = boxOf(fractionsOf(kept, volume));
        next.clip.ofBox = Keep::outside;
    } else {
        next.clip.ofBox = next.clip.ofBox == Keep::inside ? Keep::outside : Keep::inside;
        if (keepsBox(next.clip)) {
            MACULA_TRY(const Box kept, keptBox(next, volume));
            return withKept(std::move(next), kept, volume);
        }
    }
    return own(std::move(next), volume);
}

}  // namespace macula::scene
