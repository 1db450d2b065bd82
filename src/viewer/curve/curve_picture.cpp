#include "viewer/curve/curve_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <utility>

#include "slices/grey.h"

namespace macula::viewer {

namespace {

constexpr double kSectionMm = 40.0;

QImage greyOf(const slices::SampledSlice& slice, const CurveRequest& request) {
    const std::vector<std::uint8_t> grey = slices::toGrey(slice.values, request.window, request.isInverted);
    QImage image(slice.sizePx.x, slice.sizePx.y, QImage::Format_Grayscale8);
    if (image.isNull()) throw std::bad_alloc();
    for (int y = 0; y < slice.sizePx.y; ++y)
        std::memcpy(image.scanLine(y), grey.data() + std::size_t(y) * std::size_t(slice.sizePx.x),
                    std::size_t(slice.sizePx.x));
    return image;
}

// Seen from the feet, or from the front, as slices are, whichever way the curve was drawn.
slices::SlicePlane sectionAt(const slices::CurvePlace& place) {
    slices::SlicePlane plane = place.section();
    const glm::dvec3 usual = std::abs(place.along.z) > std::abs(place.along.y) ? glm::dvec3(0.0, 0.0, 1.0)
                                                                               : glm::dvec3(0.0, 1.0, 0.0);
    if (glm::dot(plane.normal(), usual) < 0.0) plane.down = -plane.down;
    return plane;
}

}  // namespace

// Pixels are as small as the width allows, but not smaller than a quarter of a voxel, which would show no
// more.
Result<CurvePicture> makeCurvePicture(const CurveRequest& request, const CancelToken& token) {
    slices::Curve curve(request.pointsMm);
    MACULA_CHECK(curve.isUsable());
    const glm::dvec3 spacingMm = request.volume->spacingMm();
    const double mmPerPixel = std::max(curve.lengthMm() / std::max(request.widthPx, 1),
                                       0.25 * std::min({spacingMm.x, spacingMm.y, spacingMm.z}));
    CurvePicture picture{.of = request, .sectionFrame = {}};
    picture.sectionFrame = {.plane = sectionAt(curve.at(request.sectionAtMm)),
                            .mmPerPixel = kSectionMm / std::max(request.sectionPx, 1),
                            .sizePx = glm::ivec2(std::max(request.sectionPx, 1))};
    picture.frame = std::make_shared<const slices::CurvedFrame>(
        std::move(curve), request.look.kind, request.look.turnDeg, request.look.heightMm, mmPerPixel);
    const auto cancelled = [&] { return token.cancelled(); };
    const slices::SampledSlice curved =
        slices::sampleCurved(*request.volume, *picture.frame, request.slab, cancelled);
    const slices::SampledSlice section = slices::sampleSlice(*request.volume, picture.sectionFrame,
                                                             request.slab, slices::Filter::linear, cancelled);
    if (cancelled()) return Error{ErrorCode::cancelled, Text("The curved plane was cancelled."), {}, {}};
    picture.curved = greyOf(curved, request);
    picture.section = greyOf(section, request);
    return picture;
}

}  // namespace macula::viewer
