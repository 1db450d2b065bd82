#include "viewer/overlay/side_letters.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <cmath>

#include "viewer/overlay/haloed_drawing.h"
#include "viewer/overlay/mark_atlas.h"
#include "viewer/overlay/overlay_layout.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr double kAroundPx = 3.0;  // logical: the halo
constexpr int kClosePx = 3;

QImage painted(const PlacedText& letter, const QRect& around, double pixelRatio) {
    QImage image((QSizeF(around.size()) * pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixelRatio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(letter.font);
    drawHaloedText(painter, letter.at - around.topLeft(), letter.text, letter.ink);
    return image;
}

}  // namespace

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
        const QRect around =
            (*letter)->box().adjusted(-kAroundPx, -kAroundPx, kAroundPx, kAroundPx).toAlignedRect();
        atlas.placeShape(
            painted(**letter, around, pixelRatio),
            {int(std::lround(around.x() * pixelRatio)), int(std::lround(around.y() * pixelRatio))}, kClosePx);
        isAny = true;
    }
    return isAny ? atlas.take() : others;
}

}  // namespace macula::viewer
