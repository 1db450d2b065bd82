#include "viewer/output/picture_overlays.h"

#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSize>
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "base/frames.h"
#include "scene/camera/orbit_camera.h"
#include "viewer/language/harmless_text.h"
#include "viewer/overlay/cube_and_scale.h"

namespace macula::viewer {

namespace {

constexpr double kLetterOfHeight = 1.0 / 36.0;
constexpr int kLeastLetterPx = 8;
const QColor kInk(235, 235, 235);
const QColor kPaper(12, 12, 12);

pictures::Stamp painted(const QString& words, const QFont& font, int widthPx) {
    const QFontMetrics metrics(font);
    const int padding = std::max(1, metrics.height() / 4);
    const QString shown = metrics.elidedText(words, Qt::ElideRight, std::max(widthPx - 2 * padding, 1));
    QImage image(std::max(1, metrics.horizontalAdvance(shown) + 2 * padding), metrics.height(),
                 QImage::Format_RGBA8888);
    image.fill(kPaper);
    QPainter painter(&image);
    painter.setFont(font);
    painter.setPen(kInk);
    painter.drawText(QPoint(padding, metrics.ascent()), shown);
    painter.end();
    pictures::Stamp stamp{.atPx = {}, .sizePx = {image.width(), image.height()}, .rgba = {}};
    const std::size_t rowBytes = std::size_t(image.width()) * 4;
    stamp.rgba.resize(rowBytes * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y)
        std::memcpy(stamp.rgba.data() + rowBytes * std::size_t(y), image.constScanLine(y), rowBytes);
    return stamp;
}

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

std::vector<pictures::Stamp> stampsOf(const std::vector<std::string>& lines,
                                      const scene::EdgeLetters& letters, const glm::ivec2& sizePx) {
    QFont font = QGuiApplication::font();
    const int letterPx = std::max(kLeastLetterPx, int(sizePx.y * kLetterOfHeight));
    font.setPixelSize(letterPx);
    const int margin = letterPx / 2;
    std::vector<pictures::Stamp> stamps;
    int top = margin;
    for (const std::string& line : lines) {
        const QString words = harmless(QString::fromStdString(line));
        if (words.isEmpty()) continue;
        pictures::Stamp stamp = painted(words, font, sizePx.x - 2 * margin);
        stamp.atPx = {margin, top};
        top += stamp.sizePx.y;
        stamps.push_back(std::move(stamp));
    }
    font.setBold(true);
    const auto add = [&](const std::string& letter, const glm::dvec2& share) {
        if (letter.empty()) return;
        pictures::Stamp stamp = painted(QString::fromStdString(letter), font, sizePx.x);
        const glm::ivec2 room = sizePx - stamp.sizePx - 2 * margin;
        stamp.atPx = margin + glm::ivec2(glm::dvec2(room) * share);
        stamps.push_back(std::move(stamp));
    };
    add(letters.left, {0.0, 0.5});
    add(letters.right, {1.0, 0.5});
    add(letters.top, {0.5, 0.0});
    add(letters.bottom, {0.5, 1.0});
    return stamps;
}

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
