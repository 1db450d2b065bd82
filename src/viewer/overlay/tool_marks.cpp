#include "viewer/overlay/tool_marks.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "viewer/overlay/mark_atlas.h"

namespace macula::viewer {

namespace {

constexpr std::array kKinds{MarkKind::dot, MarkKind::drawnDot, MarkKind::handle, MarkKind::freeHandle,
                            MarkKind::heldHandle};
const QColor kInk(255, 150, 60);
const QColor kHeldInk(255, 225, 90);
const QColor kPaper(12, 12, 12);

// In logical pixels; odd, so that a mark has a middle pixel.
int sideOf(MarkKind kind) {
    return kind == MarkKind::dot || kind == MarkKind::drawnDot ? 3 : 13;
}

int sidePx(MarkKind kind, double pixelRatio) {
    return std::max(1, int(std::lround(sideOf(kind) * pixelRatio)));
}

// Opaque, like all boxes over a picture.
QImage paintMark(MarkKind kind, double pixelRatio) {
    const int side = sidePx(kind, pixelRatio);
    QImage image(side, side, QImage::Format_RGBA8888);
    image.fill(kind == MarkKind::dot ? kInk : kind == MarkKind::drawnDot ? kHeldInk : kPaper);
    if (kind == MarkKind::dot || kind == MarkKind::drawnDot) return image;
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double rim = 2.0 * pixelRatio;
    const QRectF inside(rim, rim, side - 2.0 * rim, side - 2.0 * rim);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kind == MarkKind::heldHandle ? kHeldInk : kInk);
    if (kind == MarkKind::freeHandle) {
        painter.drawEllipse(inside);
    } else {
        painter.drawRect(inside);
    }
    painter.end();
    return image;
}

// The upper left corner of a mark, in device pixels.
std::optional<VkOffset2D> cornerOf(const ToolMark& mark, QSize pixels, int side) {
    const double x = 0.5 * (mark.place.x + 1.0) * pixels.width();
    const double y = 0.5 * (1.0 - mark.place.y) * pixels.height();
    if (!(x >= -side && x <= pixels.width() + side && y >= -side && y <= pixels.height() + side))
        return std::nullopt;
    return VkOffset2D{int(std::lround(x - 0.5 * side)), int(std::lround(y - 0.5 * side))};
}

}  // namespace

std::shared_ptr<const live::PictureText> withToolMarks(const std::shared_ptr<const live::PictureText>& others,
                                                       std::span<const ToolMark> marks, QSize pixels,
                                                       double pixelRatio) {
    if (pixels.isEmpty()) return others;
    MarkAtlas atlas(others, pixels);
    std::array<std::optional<VkRect2D>, kKinds.size()> boxes;
    std::size_t count = 0;
    for (const ToolMark& mark : marks) {
        if (count == kMostToolMarks) break;
        const auto at = cornerOf(mark, pixels, sidePx(mark.kind, pixelRatio));
        if (!at) continue;
        auto& box = boxes.at(std::size_t(mark.kind));
        if (!box) box = atlas.add(paintMark(mark.kind, pixelRatio));
        atlas.place(*box, *at);
        ++count;
    }
    return count > 0 ? atlas.take() : others;
}

}  // namespace macula::viewer
