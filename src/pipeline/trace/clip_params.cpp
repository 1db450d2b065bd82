#include "pipeline/trace/clip_params.h"

#include <tuple>

#include "pipeline/volume/window.h"

namespace macula::trace {

namespace {

// Voxel coordinates have integers at faces: centres are half a voxel on.
glm::vec4 planeInVoxels(const HalfSpace& side, const glm::dmat4& worldFromVoxel) {
    const glm::dvec3 origin = transformPoint(worldFromVoxel, glm::dvec3(-0.5));
    return glm::dvec4(glm::transpose(glm::dmat3(worldFromVoxel)) * side.normal,
                      glm::dot(side.normal, origin) - side.offsetMm);
}

int howKept(Keep keep) {
    return keep == Keep::inside ? shared::kClipKeeps : shared::kClipCuts;
}

}  // namespace

void writeClip(const Clip& clip, const Volume& volume, shared::TraceParams& params) {
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    int next = 0;
    const auto add = [&](const auto& sides) {
        for (const HalfSpace& side : sides) params.clipPlanes[next++] = planeInVoxels(side, worldFromVoxel);
        return static_cast<int>(sides.size());
    };
    params.clipKeepCount = add(clip.planes);
    if (clip.box && clip.ofBox == Keep::inside) params.clipKeepCount += add(sidesOf(*clip.box));
    if (clip.box && clip.ofBox == Keep::outside) params.clipBoxCount = add(sidesOf(*clip.box));
    if (clip.cut) params.clipCornerCount = add(sidesOf(*clip.cut));
    if (clip.ball) {
        params.clipBall = howKept(clip.ofBall);
        params.clipBallCentre = transformPoint(glm::inverse(worldFromVoxel), clip.ball->centreMm) + 0.5;
        params.clipBallX = glm::dvec3(worldFromVoxel[0]) / clip.ball->radiusMm;
        params.clipBallY = glm::dvec3(worldFromVoxel[1]) / clip.ball->radiusMm;
        params.clipBallZ = glm::dvec3(worldFromVoxel[2]) / clip.ball->radiusMm;
    }
    params.clipShadows = clip.removedCastsShadow ? 1 : 0;
    if (!clip.greyFaces || clip.isNothing()) return;
    params.greyFaces = clip.facesBelowWindowAreBlack ? 2 : 1;
    std::tie(params.greyLow, params.greyHigh) = entriesOf(*clip.greyFaces, volume);
}

bool isClipped(const shared::TraceParams& params) {
    return params.clipKeepCount + params.clipBoxCount + params.clipCornerCount > 0 ||
           params.clipBall != shared::kClipWithout;
}

}  // namespace macula::trace
