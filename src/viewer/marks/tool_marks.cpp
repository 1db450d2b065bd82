#include "viewer/marks/tool_marks.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

namespace macula::viewer {

namespace {

constexpr std::array kKinds{MarkKind::dot, MarkKind::drawnDot, MarkKind::handle, MarkKind::freeHandle,
                            MarkKind::heldHandle};
const QColor kInk(255, 150, 60);
const QColor kHeldInk(255, 225, 90);
const QColor kPaper(12, 12, 12);

// Logical pixels, odd: a mark has a middle.
int sideOf(MarkKind kind) {
    return kind == MarkKind::dot || kind == MarkKind::drawnDot ? 3 : 13;
}

int sidePx(MarkKind kind, double pixelRatio) {
    return std::max(1, int(std::lround(sideOf(kind) * pixelRatio)));
}

// Opaque, as boxes over a picture are.
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

// Where its upper left corner is, in device pixels.
std::optional<VkOffset2D> cornerOf(const ToolMark& mark, QSize pixels, int side) {
    const double x = 0.5 * (mark.place.x + 1.0) * pixels.width();
    const double y = 0.5 * (1.0 - mark.place.y) * pixels.height();
    if (!(x >= -side && x <= pixels.width() + side && y >= -side && y <= pixels.height() + side))
        return std::nullopt;
    return VkOffset2D{int(std::lround(x - 0.5 * side)), int(std::lround(y - 0.5 * side))};
}

// Images one below the other; each is a box of its own.
class Atlas {
  public:
    Atlas(const std::shared_ptr<const app::PictureText>& others, QSize pixels) {
        if (others) atlas_ = *others;
        if (atlas_.places.empty()) {
            for (const VkRect2D& box : atlas_.boxes) atlas_.places.push_back(box.offset);
        }
        atlas_.of = {std::uint32_t(pixels.width()), std::uint32_t(pixels.height())};
    }

    // The box of an image that has been added.
    VkRect2D add(const QImage& image) {
        widen(std::uint32_t(image.width()));
        const VkRect2D box{{0, std::int32_t(atlas_.size.height)},
                           {std::uint32_t(image.width()), std::uint32_t(image.height())}};
        const std::size_t rowBytes = std::size_t(atlas_.size.width) * 4;
        atlas_.rgba.resize(atlas_.rgba.size() + rowBytes * std::size_t(image.height()));
        for (int y = 0; y < image.height(); ++y)
            std::memcpy(atlas_.rgba.data() + rowBytes * (atlas_.size.height + std::size_t(y)),
                        image.constScanLine(y), std::size_t(image.width()) * 4);
        atlas_.size.height += std::uint32_t(image.height());
        return box;
    }
    void place(const VkRect2D& box, VkOffset2D at) {
        atlas_.boxes.push_back(box);
        atlas_.places.push_back(at);
    }

    std::shared_ptr<const app::PictureText> take() {
        return std::make_shared<const app::PictureText>(std::move(atlas_));
    }

  private:
    void widen(std::uint32_t width) {
        if (width <= atlas_.size.width) return;
        const std::size_t before = std::size_t(atlas_.size.width) * 4;
        const std::size_t after = std::size_t(width) * 4;
        std::vector<std::byte> wider(after * atlas_.size.height);
        for (std::size_t y = 0; y < atlas_.size.height; ++y)
            std::copy_n(atlas_.rgba.begin() + std::ptrdiff_t(before * y), before,
                        wider.begin() + std::ptrdiff_t(after * y));
        atlas_.rgba = std::move(wider);
        atlas_.size.width = width;
    }

    app::PictureText atlas_;
};

}  // namespace

std::shared_ptr<const app::PictureText> withToolMarks(const std::shared_ptr<const app::PictureText>& others,
                                                      std::span<const ToolMark> marks, QSize pixels,
                                                      double pixelRatio) {
    if (pixels.isEmpty()) return others;
    Atlas atlas(others, pixels);
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
