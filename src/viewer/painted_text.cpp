#include "viewer/painted_text.h"

#include <QFontDatabase>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "viewer/harmless_text.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kMarginPx = 8;   // logical, as all below
constexpr int kPaddingPx = 4;  // left and right of a line
constexpr int kFontPx = 14;
const QColor kInk(235, 235, 235);
const QColor kPaper(12, 12, 12);

}  // namespace

std::shared_ptr<const app::PictureText> paintText(const std::vector<std::string>& lines, int widthPx,
                                                  double pixelRatio) {
    const auto px = [&](int logical) { return std::max(1, int(std::lround(logical * pixelRatio))); };
    QFont font = QGuiApplication::font();
    font.setPixelSize(px(int(std::lround(kFontPx * fontScaleOverPictures()))));
    const QFontMetrics metrics(font);
    const int room = widthPx - 2 * px(kMarginPx) - 2 * px(kPaddingPx);
    if (room <= 0) return nullptr;

    auto text = std::make_shared<app::PictureText>();
    std::vector<QString> shown;
    for (const std::string& line : lines) {
        const QString words =
            metrics.elidedText(harmless(QString::fromStdString(line)), Qt::ElideRight, room);
        if (words.isEmpty()) continue;
        const int height = metrics.height();
        const int top = px(kMarginPx) + int(shown.size()) * height;
        const int width = std::min(room, metrics.horizontalAdvance(words)) + 2 * px(kPaddingPx);
        text->boxes.push_back({{px(kMarginPx), top}, {std::uint32_t(width), std::uint32_t(height)}});
        text->size.width = std::max(text->size.width, std::uint32_t(px(kMarginPx) + width));
        text->size.height = std::uint32_t(top + height);
        shown.push_back(words);
    }
    if (shown.empty()) return nullptr;

    QImage image(int(text->size.width), int(text->size.height), QImage::Format_RGBA8888);
    image.fill(kPaper);
    QPainter painter(&image);
    painter.setFont(font);
    painter.setPen(kInk);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const VkRect2D& box = text->boxes[i];
        painter.drawText(QPoint(box.offset.x + px(kPaddingPx), box.offset.y + metrics.ascent()), shown[i]);
    }
    painter.end();
    const std::size_t rowBytes = std::size_t(image.width()) * 4;
    text->rgba.resize(rowBytes * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y)
        std::memcpy(text->rgba.data() + rowBytes * std::size_t(y), image.constScanLine(y), rowBytes);
    return text;
}

}  // namespace macula::viewer
