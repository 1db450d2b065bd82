#include "viewer/overlay/painted_text.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <span>

#include "viewer/language/harmless_text.h"
#include "viewer/overlay/haloed_drawing.h"
#include "viewer/overlay/mark_atlas.h"
#include "viewer/overlay/overlay_layout.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;  // logical, as all below
constexpr double kLeastRoomPx = 20.0;
constexpr double kHaloPx = 3.0;
constexpr int kClosePx = 3;
const QColor kInk(235, 235, 235);
const QColor kNoteInk(255, 190, 90);

QStringList harmlessOf(const std::vector<std::string>& lines) {
    QStringList shown;
    for (const std::string& line : lines)
        if (const QString text = harmless(QString::fromStdString(line)); !text.isEmpty()) shown << text;
    return shown;
}

// Places lines from the upper left corner down; a line that would reach the middle letter goes below it.
std::vector<PlacedText> place(const LinesOver& lines, const QSize& size) {
    const QFont font = overlayFont(QGuiApplication::font(), size, fontScaleOverPictures());
    const QFontMetricsF metrics(font);
    const double roomPx = size.width() - 2.0 * kMarginPx;
    if (roomPx < kLeastRoomPx) return {};
    // The widest label that the top can have: three letters.
    const auto letter = placeSides({.left = "R", .right = "L", .top = "SAR", .bottom = "I"}, size, font,
                                   fontScaleOverPictures())
                            .top;
    double top = kMarginPx;
    std::vector<PlacedText> placed;
    const auto put = [&](const QString& text, const QColor& ink) {
        const bool meets = letter && letter->box().bottom() > top &&
                           kMarginPx + metrics.horizontalAdvance(text) > letter->box().left();
        if (meets) top = letter->box().bottom();
        placed.push_back({.at = {kMarginPx, top + metrics.ascent()}, .text = text, .ink = ink, .font = font});
        top += metrics.height();
    };
    const QStringList names = harmlessOf(lines.names);
    for (const QString& name : names.first(namesIn(size, font, names.size())))
        put(metrics.elidedText(name, Qt::ElideMiddle, roomPx), kInk);
    for (const QString& note : wrapped(harmlessOf(lines.notes), font, roomPx)) put(note, kNoteInk);
    return placed;
}

// The texts on a transparent ground of that size in device pixels, whose upper left corner is at `corner`.
QImage painted(std::span<const PlacedText> texts, const QPoint& corner, const QSize& pixels,
               double pixelRatio) {
    QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixelRatio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlacedText& text : texts) {
        painter.setFont(text.font);
        drawHaloedText(painter, text.at - corner, text.text, text.ink);
    }
    return image;
}

}  // namespace

std::shared_ptr<const live::PictureText> paintText(const LinesOver& lines, QSize pixels, double pixelRatio) {
    if (pixels.isEmpty() || !(pixelRatio > 0.0) || !std::isfinite(pixelRatio)) return nullptr;
    const std::vector<PlacedText> placed = place(lines, (QSizeF(pixels) / pixelRatio).toSize());
    if (placed.empty()) return nullptr;
    QRectF all;
    for (const PlacedText& text : placed) all |= text.box();
    const QSize needed = (QSizeF(all.right() + kHaloPx, all.bottom() + kHaloPx) * pixelRatio).toSize();
    MarkAtlas atlas(nullptr, QSize(0, 0));  // over pictures of any size
    atlas.placeShape(painted(placed, {0, 0}, needed.boundedTo(pixels), pixelRatio), {0, 0}, kClosePx);
    auto text = atlas.take();
    return text->boxes.empty() ? nullptr : text;
}

std::shared_ptr<const live::PictureText> withSideLetters(
    const std::shared_ptr<const live::PictureText>& others, const scene::EdgeLetters& sides, QSize pixels,
    double pixelRatio) {
    if (pixels.isEmpty() || !(pixelRatio > 0.0) || !std::isfinite(pixelRatio)) return others;
    const SideLetters letters = placeSides(sides, (QSizeF(pixels) / pixelRatio).toSize(),
                                           QGuiApplication::font(), fontScaleOverPictures());
    MarkAtlas atlas(others, pixels);
    bool isAny = false;
    for (const auto* letter : {&letters.left, &letters.right, &letters.top, &letters.bottom}) {
        if (!*letter || (*letter)->text.isEmpty()) continue;
        const QRect around = (*letter)->box().adjusted(-kHaloPx, -kHaloPx, kHaloPx, kHaloPx).toAlignedRect();
        atlas.placeShape(
            painted(std::span(&**letter, 1), around.topLeft(), (QSizeF(around.size()) * pixelRatio).toSize(),
                    pixelRatio),
            {int(std::lround(around.x() * pixelRatio)), int(std::lround(around.y() * pixelRatio))}, kClosePx);
        isAny = true;
    }
    return isAny ? atlas.take() : others;
}

}  // namespace macula::viewer
