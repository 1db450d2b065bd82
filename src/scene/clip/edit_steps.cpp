#include "scene/clip/edit_steps.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "scene/clip/edited_clip.h"

namespace macula::scene {

namespace {

// An open face lies this far beyond the volume, as a fraction of its size: on the border itself, rounding
// would decide about the outermost voxels.
constexpr double kBeyond = 0.5;
constexpr double kAtBorder = 1e-9;  // a face nearer to the border counts as open; a fraction of the size

bool isOpen(Face face, const Box& fractions) {
    const double at = faceMm(fractions, face);
    return isHigh(face) ? at >= 1.0 - kAtBorder : at <= kAtBorder;
}

}  // namespace

Error refused(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

Error notANumber() {
    return refused(Text("The place of the clip is not a number."), Text("Give it in mm."));
}

Error nothingLeft() {
    return refused(Text("Nothing of the volume would be left."),
                   Text("Choose another place, or begin without a clip."));
}

Error notThere() {
    return refused(Text("That part of the clip is not there any more."), Text("Take hold of another one."));
}

bool isWithin(const Box& box, const glm::dvec3& point) {
    return glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high));
}

glm::dvec3 fractionOf(const Volume& volume, const glm::dvec3& pointMm) {
    const Box all = volume.worldBox();
    return (pointMm - all.low) / (all.high - all.low);
}

Box fractionsOf(const Box& boxMm, const Volume& volume) {
    return {fractionOf(volume, boxMm.low), fractionOf(volume, boxMm.high)};
}

OrientedBox boxOf(const Box& fractions) {
    Box box = fractions;
    for (const Face face : kFaces) {
        if (isOpen(face, fractions)) setFaceMm(box, face, isHigh(face) ? 1.0 + kBeyond : -kBeyond);
    }
    return {.centreMm = box.centre(), .halfSizeMm = 0.5 * (box.high - box.low)};
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
        return refused(Text("A clip with a box of another kind has six planes and no more."),
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

}  // namespace macula::scene
