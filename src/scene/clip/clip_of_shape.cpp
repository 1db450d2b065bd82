#include "scene/clip/clip_of_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/clip/edited_clip.h"

namespace macula::scene {

namespace {

constexpr double kTurned = 1e-9;

Error notKept() {
    return {ErrorCode::usage,
            Text("This clip cannot be kept with the study."),
            {},
            Text("Reset the clips, and cut again.")};
}

bool isAlongPatient(const OrientedBox& box) {
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row)
            if (std::abs(box.axes[axis][row] - (axis == row ? 1.0 : 0.0)) > kTurned) return false;
    return true;
}

}  // namespace

Result<OptionalClip> clipOfShape(const Clip& shapeMm, const OptionalClip& before, const Volume& volume) {
    MACULA_TRY_VOID(validate(shapeMm));
    const Box all = volume.worldBox();
    ClipPreset next = before.value_or(ClipPreset{});
    const Clip kept = next.clip;
    next.clip = shapeMm;
    next.clip.mask.reset();
    next.clip.greyFaces = next.greyFacesOfSeries ? kept.greyFaces : shapeMm.greyFaces;
    next.planesAt.clear();
    shapesToFractions(next.clip, all);
    if (next.clip.box) {
        if (!isAlongPatient(*next.clip.box)) return notKept();
        next.clip.box->axes = glm::dmat3(1.0);
    }
    for (HalfSpace& plane : next.clip.planes) {
        const double fromMiddleMm = plane.offsetMm - glm::dot(plane.normal, all.centre());
        next.planesAt.push_back(fractionOnPlane(plane.normal, fromMiddleMm, volume));
        plane.offsetMm = 0.0;
    }
    if (!next.clip.hasShape()) return OptionalClip{};
    next.name = kOwnClipName;
    next.title = "Own clip";
    // A clip that cannot be read again would make the whole saved state unreadable.
    const Result<ClipPreset> read = clipPresetFromJson(toJson(next), {});
    if (!read) return notKept();
    return OptionalClip(*read);
}

}  // namespace macula::scene
