#include "pipeline/volume/clip.h"

#include <cmath>

#include "pipeline/volume/clip_shape_parts.h"

namespace macula {

namespace {

BoxCorners cornersInWorld(const glm::dmat4& worldFromFrame, const Box& box) {
    BoxCorners corners;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const glm::dvec3 corner((c & 1) ? box.high.x : box.low.x, (c & 2) ? box.high.y : box.low.y,
                                (c & 4) ? box.high.z : box.low.z);
        corners[c] = transformPoint(worldFromFrame, corner);
    }
    return corners;
}

}  // namespace

bool Clip::hasShape() const {
    bool hasAny = false;
    forEachShape(*this, [&](const ClipShape auto&, Keep) { hasAny = true; });
    return hasAny;
}

Result<void> validate(const Clip& clip) {
    if (clip.planes.size() > Clip::kMostPlanes)
        return clipNotUsable(Text("there are more than six planes"), Text("Give six planes at most."));
    Result<void> usable;
    forEachShape(clip, [&](const ClipShape auto& shape, Keep) {
        if (usable) usable = shape.check();
    });
    MACULA_TRY_VOID(usable);
    if (clip.mask && clip.mask->labels == nullptr && clip.mask->bits == nullptr)
        return clipNotUsable(Text("there is no segmentation to mask with"), Text("Give one."));
    if (clip.greyFaces && !(std::isfinite(clip.greyFaces->center) && clip.greyFaces->width > 0.0 &&
                            std::isfinite(clip.greyFaces->width)))
        return clipNotUsable(Text("the window of its faces has no width"),
                             Text("Give a centre and a positive width."));
    return {};
}

bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame) {
    const BoxCorners corners = cornersInWorld(worldFromFrame, boxInFrame);
    bool isRemoved = false;
    forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
        isRemoved =
            isRemoved || (keep == Keep::inside ? containsNone(shape, corners) : containsAll(shape, corners));
    });
    return isRemoved;
}

bool removesNothing(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame) {
    const BoxCorners corners = cornersInWorld(worldFromFrame, boxInFrame);
    bool isKept = true;
    forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
        isKept =
            isKept && (keep == Keep::inside ? containsAll(shape, corners) : containsNone(shape, corners));
    });
    return isKept;
}

bool shows(const Clip& clip, const glm::dvec3& pointMm) {
    bool isShown = true;
    forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
        isShown = isShown && contains(shape, pointMm) == (keep == Keep::inside);
    });
    return isShown;
}

void shapesToMm(Clip& clip, const Box& volume) {
    forEachShape(clip, [&](auto& shape, Keep) {
        if constexpr (requires { shape.toMm(volume); }) shape.toMm(volume);
    });
}

void shapesToFractions(Clip& clip, const Box& volume) {
    forEachShape(clip, [&](auto& shape, Keep) {
        if constexpr (requires { shape.toFractions(volume); }) shape.toFractions(volume);
    });
}

}  // namespace macula
