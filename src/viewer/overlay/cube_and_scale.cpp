#include "viewer/overlay/cube_and_scale.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "scene/camera/orientation_cube.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

// Logical pixels.
constexpr int kMarginPx = 8;
constexpr int kWidthPx = 124;
constexpr int kCubePx = 72;  // the square that the cube turns in
constexpr int kBarRowPx = 26;
constexpr int kBadgeRowPx = 15;  // the line that says that the bar is not calibrated
constexpr int kAboutPx = 16;     // the "≈" before the length
constexpr int kBarPx = 108;      // the longest bar
constexpr int kTickPx = 5;
constexpr int kFontPx = 12;
constexpr double kLeastTimes = 2.5;  // the picture is at least this many times as large as the marks

constexpr double kLetterOfFace = 1.3;  // height of a letter, in halves of an edge
const QColor kInk(235, 235, 235);
const QColor kPaper(12, 12, 12);
const QColor kEdge(30, 30, 30);

struct Layout {
    double ratio;
    QRect box;  // device pixels, in the picture

    int px(double logical) const { return std::max(1, int(std::lround(logical * ratio))); }
    // The middle of the cube, from the top left of the box.
    QPointF cubeMiddle() const { return {0.5 * box.width(), 0.5 * px(kCubePx)}; }
    double halfEdge() const { return 0.5 * px(kCubePx) / scene::kCubeReach; }
};

std::optional<Layout> layoutOf(const MarkedPicture& picture) {
    if (!(picture.pixelRatio > 0.0) || !std::isfinite(picture.pixelRatio)) return std::nullopt;
    Layout layout{.ratio = picture.pixelRatio, .box = {}};
    const QSize more =
        picture.isCalibrated ? QSize(0, 0) : QSize(layout.px(kAboutPx), layout.px(kBadgeRowPx));
    const QSize size = QSize(layout.px(kWidthPx), layout.px(kCubePx) + layout.px(kBarRowPx)) + more;
    if (picture.pixels.width() < kLeastTimes * size.width() ||
        picture.pixels.height() < kLeastTimes * size.height())
        return std::nullopt;
    const int margin = layout.px(kMarginPx);
    layout.box = QRect(QPoint(picture.pixels.width() - margin - size.width(),
                              picture.pixels.height() - margin - size.height()),
                       size);
    return layout;
}

QPointF pointOf(const glm::dvec2& v) {
    return {v.x, v.y};
}

// The path of a letter of this height, centred on the origin, with y down.
QPainterPath letterPath(const QString& letter, const QFont& font, double height) {
    QPainterPath path;
    path.addText({}, font, letter);
    const QRectF box = path.boundingRect();
    if (box.isEmpty()) return {};
    const double scale = height / box.height();
    return QTransform::fromScale(scale, scale).map(path.translated(-box.center()));
}

void paintCube(QPainter& painter, const CameraBasis& axes, const Layout& layout, const QFont& font) {
    painter.save();
    painter.translate(layout.cubeMiddle());
    painter.scale(layout.halfEdge(), layout.halfEdge());
    for (const scene::CubeFace& face : scene::facesSeen(axes)) {
        QPolygonF outline;
        for (const glm::dvec2& corner : face.corners) outline << pointOf(corner);
        painter.setPen(QPen(kEdge, 0.0));
        const int grey = 90 + int(std::lround(90.0 * face.facing));
        painter.setBrush(QColor(grey, grey, grey + 20));
        painter.drawPolygon(outline);
        painter.save();
        painter.setTransform(
            QTransform(face.right.x, face.right.y, face.down.x, face.down.y, face.middle.x, face.middle.y),
            true);
        //: One letter: Anterior, Posterior, Left, Right, Superior, Inferior
        const QString letter = QCoreApplication::translate("OrientationCube", face.letter.c_str());
        painter.fillPath(letterPath(letter, font, kLetterOfFace), kPaper);
        painter.restore();
    }
    painter.restore();
}

void paintBar(QPainter& painter, const ScaleBar& bar, bool isTrueEverywhere, const Layout& layout) {
    QString text =
        isTrueEverywhere ? bar.text : QCoreApplication::translate("ScaleBar", "%1 at centre").arg(bar.text);
    if (!bar.isCalibrated)
        text += QLatin1Char('\n') + QCoreApplication::translate("ScaleBar", "not calibrated");
    const double left = 0.5 * (layout.box.width() - bar.lengthPx);
    const double y = layout.box.height() - layout.px(4);
    const double tick = layout.px(kTickPx);
    QPen pen(kInk, layout.px(1.5));
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(QPointF(left, y), QPointF(left + bar.lengthPx, y));
    for (const double x : {left, left + bar.lengthPx}) painter.drawLine(QPointF(x, y - tick), QPointF(x, y));
    const QRectF row(0.0, layout.px(kCubePx), layout.box.width(), y - tick - layout.px(kCubePx));
    painter.drawText(row, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextDontClip, text);
}

// The left and right end of the painted pixels in rows [top, bottom) of an image; nothing if there are none.
std::optional<std::pair<int, int>> paintedIn(const QImage& image, int top, int bottom) {
    int left = image.width();
    int right = -1;
    for (int y = top; y < bottom; ++y) {
        const auto* pixels = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            if (qAlpha(pixels[x]) == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    if (right < left) return std::nullopt;
    return std::pair(left, right + 1);
}

// Covers the cube exactly, row by row: it is convex, so a row has no gap. Below it, from `barTop`, one box
// covers the bar and its text.
std::vector<VkRect2D> boxesOf(const QImage& image, int barTop) {
    std::vector<VkRect2D> boxes;
    const auto add = [&](int top, int bottom) {
        const auto ends = paintedIn(image, top, bottom);
        if (!ends) return;
        const VkRect2D box{{ends->first, top},
                           {std::uint32_t(ends->second - ends->first), std::uint32_t(bottom - top)}};
        const bool goesOn = !boxes.empty() && boxes.back().offset.x == box.offset.x &&
                            boxes.back().extent.width == box.extent.width &&
                            boxes.back().offset.y + int(boxes.back().extent.height) == top && top < barTop;
        if (goesOn) {
            boxes.back().extent.height += box.extent.height;
        } else {
            boxes.push_back(box);
        }
    };
    for (int y = 0; y < barTop; ++y) add(y, y + 1);
    add(barTop, image.height());
    return boxes;
}

}  // namespace

std::optional<ScaleBar> scaleBar(double mmPerPx, double mostPx, bool isCalibrated) {
    const double mostMm = mmPerPx * mostPx;
    if (!(mmPerPx > 0.0) || !(mostMm > 0.0) || !std::isfinite(mostMm)) return std::nullopt;
    constexpr double kRounding = 1e-9;  // or rounding in the last bit could turn 100 mm into 50
    const double power = std::pow(10.0, std::floor(std::log10(mostMm) + kRounding));
    double lengthMm = power;
    for (const double times : {2.0, 5.0})
        if (times * power <= mostMm * (1.0 + kRounding)) lengthMm = times * power;
    QString text =
        lengthMm >= 10.0
            ? QCoreApplication::translate("Slices", "%1 cm")
                  .arg(withLocalNumbers(QString::number(lengthMm / 10.0)))
            : QCoreApplication::translate("Slices", "%1 mm").arg(withLocalNumbers(QString::number(lengthMm)));
    if (!isCalibrated) text.prepend(QStringLiteral("≈ "));
    return ScaleBar{
        .lengthMm = lengthMm, .lengthPx = lengthMm / mmPerPx, .text = text, .isCalibrated = isCalibrated};
}

std::optional<ScaleBar> scaleBarOf(const MarkedPicture& picture) {
    if (!basis(picture.camera) || picture.pixels.height() < 1) return std::nullopt;
    return scaleBar(heightAtTargetMm(picture.camera) / picture.pixels.height(), kBarPx * picture.pixelRatio,
                    picture.isCalibrated);
}

std::shared_ptr<const live::PictureText> paintCubeAndScale(const MarkedPicture& picture) {
    const auto axes = basis(picture.camera);
    const auto layout = axes ? layoutOf(picture) : std::nullopt;
    if (!layout) return nullptr;
    QFont font = QGuiApplication::font();
    font.setPixelSize(layout->px(kFontPx));
    font.setBold(true);

    QImage painted(layout->box.size(), QImage::Format_ARGB32_Premultiplied);
    painted.fill(Qt::transparent);
    QPainter painter(&painted);
    painter.setRenderHint(QPainter::Antialiasing);
    paintCube(painter, *axes, *layout, font);
    font.setBold(false);
    painter.setFont(font);
    const auto bar = scaleBarOf(picture);
    if (bar) paintBar(painter, *bar, isParallel(picture.camera), *layout);
    painter.end();

    QImage image(painted.size(), QImage::Format_RGBA8888);
    image.fill(kPaper);
    QPainter(&image).drawImage(0, 0, painted);
    auto marks = std::make_shared<live::PictureText>();
    const QSize size = image.size();
    marks->size = {std::uint32_t(size.width()), std::uint32_t(size.height())};
    marks->boxes = boxesOf(painted, layout->px(kCubePx));
    if (marks->boxes.empty()) return nullptr;
    for (const VkRect2D& box : marks->boxes)
        marks->places.push_back({layout->box.x() + box.offset.x, layout->box.y() + box.offset.y});
    marks->of = {std::uint32_t(picture.pixels.width()), std::uint32_t(picture.pixels.height())};
    const std::size_t rowBytes = std::size_t(size.width()) * 4;
    marks->rgba.resize(rowBytes * std::size_t(size.height()));
    for (int y = 0; y < size.height(); ++y)
        std::memcpy(marks->rgba.data() + rowBytes * std::size_t(y), image.constScanLine(y), rowBytes);
    return marks;
}

std::optional<ViewDirection> cubeSideAt(const MarkedPicture& picture, QPointF place) {
    const auto axes = basis(picture.camera);
    const auto layout = axes ? layoutOf(picture) : std::nullopt;
    if (!layout) return std::nullopt;
    const QPointF px(0.5 * (1.0 + place.x()) * picture.pixels.width(),
                     0.5 * (1.0 - place.y()) * picture.pixels.height());
    const QPointF from = (px - layout->box.topLeft() - layout->cubeMiddle()) / layout->halfEdge();
    return scene::faceAt(*axes, {from.x(), from.y()});
}

}  // namespace macula::viewer
