#include "pipeline/splat/draw/raster_view.h"

#include <cmath>

#include "base/is_finite.h"

namespace macula::splat {

namespace {

Error notUsable(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

// Whether the matrix is a rotation, up to the rounding of a file with six digits; no scale and no mirror.
bool isRotation(const glm::dmat3& m) {
    const glm::dmat3 product = m * glm::transpose(m);
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(product[i][k] - (i == k ? 1.0 : 0.0)));
    }
    return worst < 1e-4 && glm::determinant(m) > 0.0;
}

// Splats farther outside the picture than this, in sides of the picture, get the size and shape that they
// would have there (J is taken there): with their own they might fill the picture, although they are far from
// it in space.
constexpr double kBeyondPicture = 0.15;

glm::dvec2 wholeSize(const RasterView& view) {
    return view.wholePx.x > 0 ? view.wholePx : view.sizePx;
}

Result<void> checkPicture(const glm::ivec2& sizePx, double nearMm) {
    if (sizePx.x < 1 || sizePx.y < 1 || sizePx.x > kMaxRasterSide || sizePx.y > kMaxRasterSide)
        return notUsable(Text("A picture of {} x {} pixels cannot be made.", sizePx.x, sizePx.y),
                         Text("Choose a size from 1 to {} on each side.", kMaxRasterSide));
    if (!(nearMm >= 1e-3 && nearMm <= 1e6))
        return notUsable(Text("The camera's near plane is not usable."),
                         Text("Choose a distance from 0.001 to 1000000 mm."));
    return {};
}

}  // namespace

Result<RasterView> rasterView(const Camera& camera, const glm::ivec2& sizePx, const glm::dvec3& originMm,
                              double nearMm) {
    MACULA_TRY(const CameraBasis eye, basis(camera));
    MACULA_TRY_VOID(checkPicture(sizePx, nearMm));
    const double focal = isParallel(camera)
                             ? sizePx.y / camera.parallelHeightMm
                             : 0.5 * sizePx.y / std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    return RasterView{
        .cameraFromWorld = glm::transpose(glm::dmat3(eye.right, -eye.up, eye.forward)),
        .eyeMm = camera.positionMm - originMm,
        .focalPx = glm::dvec2(focal),
        .principalPx = 0.5 * glm::dvec2(sizePx),
        .sizePx = sizePx,
        .nearMm = nearMm,
        .isParallel = isParallel(camera),
    };
}

RasterView partOf(const RasterView& whole, const glm::ivec2& atPx, const glm::ivec2& sizePx) {
    RasterView part = whole;
    part.principalPx -= glm::dvec2(atPx);
    part.sizePx = sizePx;
    part.wholePx = whole.sizePx;
    part.atPx = atPx;
    return part;
}

glm::dvec2 lowestSlope(const RasterView& view) {
    const glm::dvec2 principalPx = view.principalPx + glm::dvec2(view.atPx);
    return -(principalPx + kBeyondPicture * wholeSize(view)) / view.focalPx;
}

glm::dvec2 highestSlope(const RasterView& view) {
    const glm::dvec2 principalPx = view.principalPx + glm::dvec2(view.atPx);
    return ((1.0 + kBeyondPicture) * wholeSize(view) - principalPx) / view.focalPx;
}

Result<void> validate(const RasterView& view) {
    MACULA_TRY_VOID(checkPicture(view.sizePx, view.nearMm));
    if (!isRotation(view.cameraFromWorld))
        return notUsable(Text("The camera's orientation is not a rotation."),
                         Text("Give three perpendicular unit axes that are not mirrored."));
    const glm::dvec3& eye = view.eyeMm;
    if (!isFinite(eye) || !(glm::length(eye) < 1e9))
        return notUsable(Text("The camera's position is not usable."),
                         Text("Give a position within 1000 km of the model."));
    for (int i = 0; i < 2; ++i) {
        const double least = view.isParallel ? 1e-6 : 1e-2;  // focalPx is in pixels per mm, which may be few
        if (!(view.focalPx[i] >= least && view.focalPx[i] <= 1e8))
            return notUsable(Text("The camera's focal length is not usable."),
                             Text("Choose 0.01 to 100000000 pixels."));
        if (!(std::abs(view.principalPx[i]) <= 1e6))
            return notUsable(Text("The camera's principal point is not usable."),
                             Text("Choose a point within 1000000 pixels of the picture."));
    }
    return {};
}

Blending blendingOf(LowPass lowPass) {
    if (lowPass == LowPass::adaptive) return {};
    const double lowPassPx2 = lowPass == LowPass::mip ? 0.1 : 0.3;
    return {.compensated = lowPass != LowPass::classic,
            .lowPassPx2 = lowPassPx2,
            .lowPassLeastPx2 = lowPassPx2,
            .fringe = 1e6};
}

Result<void> validate(const Blending& blending) {
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    if (within(blending.lowPassPx2, 1e-2, 100.0) &&
        within(blending.lowPassLeastPx2, 1e-2, blending.lowPassPx2) &&
        within(blending.maxAlpha, 0.01, 0.9999) && within(blending.minAlpha, 1e-9, 0.009) &&
        within(blending.fringe, 1.1, 1e6) && within(blending.minTransmittance, 0.0, 0.1))
        return {};
    return notUsable(
        Text("The way in which splats blend is not usable."),
        Text(
            "Choose a low-pass of 0.01 to 100 square pixels, the least of it no more, a most opaque splat of "
            "0.01 to 0.9999, a "
            "faintest of 1e-9 to 0.009, a fringe of 1.1 to 1000000, and a least transmittance of 0 to 0.1."));
}

shared::SplatView splatView(const RasterView& view, const Blending& blending) {
    const glm::dmat3 axes = glm::transpose(view.cameraFromWorld);
    return {
        .right = axes[0],
        .down = axes[1],
        .forward = axes[2],
        .eyeMm = view.eyeMm,
        .focalPx = view.focalPx,
        .principalPx = view.principalPx,
        .sizePx = view.sizePx,
        .lowestSlope = lowestSlope(view),
        .highestSlope = highestSlope(view),
        .nearMm = static_cast<float>(view.nearMm),
        .lowPassPx2 = static_cast<float>(blending.lowPassPx2),
        .lowPassLeastPx2 = static_cast<float>(blending.lowPassLeastPx2),
        .compensated = blending.compensated ? 1 : 0,
        .parallel = view.isParallel ? 1 : 0,
        .maxAlpha = static_cast<float>(blending.maxAlpha),
        .minAlpha = static_cast<float>(blending.minAlpha),
        .fringe = static_cast<float>(blending.fringe),
        .minTransmittance = static_cast<float>(blending.minTransmittance),
    };
}

}  // namespace macula::splat
