#include "viewer/output/picture_overlays.h"

#include <QSize>
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "base/frames.h"
#include "scene/camera/orbit_camera.h"
#include "viewer/output/movie_stamps.h"
#include "viewer/overlay/cube_and_scale.h"

namespace macula::viewer {

namespace {

constexpr double kUsualScreenPx = 720.0;  // a picture with this shorter side has marks in screen size

scene::EdgeLetters lettersOf(const CameraBasis& axes) {
    return {.left = orientationLetters(-axes.right),
            .right = orientationLetters(axes.right),
            .top = orientationLetters(axes.up),
            .bottom = orientationLetters(-axes.up)};
}

// One box of the marks, at its position in the picture.
pictures::Stamp stampOf(const live::PictureText& marks, std::size_t index) {
    const VkRect2D& box = marks.boxes[index];
    pictures::Stamp stamp{.atPx = {marks.places[index].x, marks.places[index].y},
                          .sizePx = {int(box.extent.width), int(box.extent.height)},
                          .rgba = {}};
    const std::size_t rowBytes = std::size_t(stamp.sizePx.x) * 4;
    stamp.rgba.resize(rowBytes * std::size_t(stamp.sizePx.y));
    for (int y = 0; y < stamp.sizePx.y; ++y) {
        const std::size_t from = std::size_t(box.offset.y + y) * marks.size.width + std::size_t(box.offset.x);
        std::memcpy(&stamp.rgba[rowBytes * std::size_t(y)], &marks.rgba[4 * from], rowBytes);
    }
    return stamp;
}

}  // namespace

std::vector<pictures::Stamp> overlaysOf(const Camera& camera, const glm::ivec2& sizePx, bool isCalibrated) {
    const auto axes = basis(camera);
    if (!axes || sizePx.x < 1 || sizePx.y < 1) return {};
    std::vector<pictures::Stamp> stamps = stampsOf({}, lettersOf(*axes), sizePx);
    const double ratio = std::max(1.0, std::min(sizePx.x, sizePx.y) / kUsualScreenPx);
    const auto marks = paintCubeAndScale({.camera = camera,
                                          .pixels = QSize(sizePx.x, sizePx.y),
                                          .pixelRatio = ratio,
                                          .isCalibrated = isCalibrated});
    if (marks == nullptr) return stamps;
    for (std::size_t i = 0; i < marks->boxes.size(); ++i) stamps.push_back(stampOf(*marks, i));
    return stamps;
}

}  // namespace macula::viewer
