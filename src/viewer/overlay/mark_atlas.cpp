#include "viewer/overlay/mark_atlas.h"

#include <QColor>
#include <QPainter>
#include <algorithm>
#include <cstring>
#include <utility>

namespace macula::viewer {

namespace {

const QColor kPaper(12, 12, 12);
constexpr int kPaintedAlpha = 96;  // a fainter rim of a halo is not missed

bool isPainted(const QImage& image, int x, int y) {
    return qAlpha(reinterpret_cast<const QRgb*>(image.constScanLine(y))[x]) >= kPaintedAlpha;
}

// Begin and end of each run.
std::vector<std::pair<int, int>> runsOf(const QImage& image, int y, int closePx) {
    std::vector<std::pair<int, int>> runs;
    for (int x = 0; x < image.width(); ++x) {
        if (!isPainted(image, x, y)) continue;
        if (!runs.empty() && x - runs.back().second <= closePx) {
            runs.back().second = x + 1;
        } else {
            runs.emplace_back(x, x + 1);
        }
    }
    return runs;
}

}  // namespace

std::vector<VkRect2D> coveredBoxes(const QImage& painted, int closePx) {
    const QImage image = painted.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    std::vector<VkRect2D> boxes;
    std::vector<std::pair<int, int>> before;
    std::size_t firstOfBefore = 0;
    for (int y = 0; y < image.height(); ++y) {
        auto runs = runsOf(image, y, closePx);
        if (runs == before) {
            for (std::size_t i = firstOfBefore; i < boxes.size(); ++i) ++boxes[i].extent.height;
            continue;
        }
        firstOfBefore = boxes.size();
        for (const auto& [begin, end] : runs) boxes.push_back({{begin, y}, {std::uint32_t(end - begin), 1}});
        before = std::move(runs);
    }
    return boxes;
}

QImage opaque(const QImage& painted) {
    QImage image(painted.size(), QImage::Format_RGBA8888);
    image.fill(kPaper);
    QImage plain = painted;
    plain.setDevicePixelRatio(1.0);
    QPainter(&image).drawImage(0, 0, plain);
    return image;
}

MarkAtlas::MarkAtlas(const std::shared_ptr<const live::PictureText>& others, QSize pixels) {
    if (others) atlas_ = *others;
    if (atlas_.places.empty()) {
        for (const VkRect2D& box : atlas_.boxes) atlas_.places.push_back(box.offset);
    }
    atlas_.of = {std::uint32_t(pixels.width()), std::uint32_t(pixels.height())};
}

VkRect2D MarkAtlas::add(const QImage& image) {
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

void MarkAtlas::place(const VkRect2D& box, VkOffset2D at) {
    atlas_.boxes.push_back(box);
    atlas_.places.push_back(at);
}

void MarkAtlas::placeShape(const QImage& painted, VkOffset2D at, int closePx) {
    const std::vector<VkRect2D> parts = coveredBoxes(painted, closePx);
    if (parts.empty()) return;
    const VkOffset2D begin = add(opaque(painted)).offset;
    for (const VkRect2D& part : parts)
        place({{begin.x + part.offset.x, begin.y + part.offset.y}, part.extent},
              {at.x + part.offset.x, at.y + part.offset.y});
}

std::shared_ptr<const live::PictureText> MarkAtlas::take() {
    return std::make_shared<const live::PictureText>(std::move(atlas_));
}

void MarkAtlas::widen(std::uint32_t width) {
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

}  // namespace macula::viewer
