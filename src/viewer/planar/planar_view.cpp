#include "viewer/planar/planar_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

constexpr double kMostScale = 64.0;  // logical pixels for a pixel of the picture
constexpr double kMarginPx = 8.0;
constexpr double kBarHeightPx = 4.0;
constexpr double kLongestBarPart = 0.25;  // of the pane's width
constexpr int kWheelStep = 120;
constexpr double kZoomOfStep = 1.2;
constexpr double kDragZoomPerHeight = 6.0;  // magnification by a drag up over the pane's height
constexpr double kQuarter = 90.0;
const QColor kInk(235, 235, 235);
const QColor kWarningInk(255, 214, 120);

enum class Corner { topLeft, topRight, bottomLeft, bottomRight };

void drawLines(QPainter& painter, const QSize& pane, Corner corner, const QStringList& lines,
               const QColor& ink) {
    const QFontMetricsF metrics(painter.font());
    const bool isRight = corner == Corner::topRight || corner == Corner::bottomRight;
    const bool isBottom = corner == Corner::bottomLeft || corner == Corner::bottomRight;
    const double height = metrics.lineSpacing() * double(lines.size());
    double base = (isBottom ? pane.height() - kMarginPx - height : kMarginPx) + metrics.ascent();
    const double most = 0.6 * pane.width();
    for (const QString& line : lines) {
        const QString text = metrics.elidedText(line, Qt::ElideRight, most);
        const double x = isRight ? pane.width() - kMarginPx - metrics.horizontalAdvance(text) : kMarginPx;
        drawHaloedText(painter, {x, base}, text, ink);
        base += metrics.lineSpacing();
    }
}

}  // namespace

void PlanarLabels::setScale(const std::optional<dicom::PixelSize>& size) {
    using Of = dicom::PixelSize::Of;
    if (!size || size->of == Of::film) return;
    mmPerPixel = size->columnMm;
    isCalibrated = size->of == Of::object || size->of == Of::regions;
}

PlanarView::PlanarView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("images"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void PlanarView::setPicture(const QImage& picture, double heightOverWidth) {
    if (picture.size() != picture_.size() && !picture_.isNull()) fit();
    picture_ = picture;
    heightOverWidth_ = heightOverWidth;
    message_.clear();
    update();
}

void PlanarView::setLabels(const PlanarLabels& labels) {
    labels_ = labels;
    update();
}

void PlanarView::setTurn(const PlanarTurn& turn) {
    turn_ = turn;
    fit();
}

void PlanarView::setMessage(const QString& message) {
    message_ = message;
    if (!message.isEmpty()) picture_ = {};
    update();
}

void PlanarView::setArea(const std::optional<QRectF>& area) {
    area_ = area;
    fit();
}

void PlanarView::fit() {
    setZoom({});
}

void PlanarView::setZoom(const PlanarZoom& zoom) {
    zoom_ = zoom;
    keepInPane();
    update();
    Q_EMIT zoomed();
}

QRectF PlanarView::area() const {
    return area_.value_or(QRectF(picture_.rect()));
}

QTransform PlanarView::shapeFromPicture() const {
    QTransform turned;
    turned.scale(turn_.isMirrored ? -1.0 : 1.0, 1.0);
    turned.rotate(kQuarter * turn_.quarters);
    turned.scale(1.0, heightOverWidth_);
    turned.translate(-area().center().x(), -area().center().y());
    return turned;
}

double PlanarView::fittingScale() const {
    const QRectF shape = shapeFromPicture().mapRect(area());
    if (shape.isEmpty()) return 1.0;
    return std::min(width() / shape.width(), height() / shape.height());
}

QTransform PlanarView::paneFromPicture() const {
    const double scale = zoom_.scale.value_or(fittingScale());
    return shapeFromPicture() * QTransform::fromScale(scale, scale) *
           QTransform::fromTranslate(0.5 * width() + zoom_.middle.x(), 0.5 * height() + zoom_.middle.y());
}

std::optional<QPointF> PlanarView::pixelAt(const QPointF& place) const {
    if (picture_.isNull()) return {};
    const QPointF pixel = paneFromPicture().inverted().map(place);
    const bool isIn =
        pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < picture_.width() && pixel.y() < picture_.height();
    return isIn ? std::optional(pixel) : std::nullopt;
}

void PlanarView::zoomBy(double factor, const QPointF& fixed) {
    if (picture_.isNull()) return;
    const double before = zoom_.scale.value_or(fittingScale());
    const double least = std::min(fittingScale(), 1.0);
    const double after = std::clamp(before * factor, least, std::max(kMostScale, least));
    const QPointF fromMiddle = fixed - QPointF(0.5 * width(), 0.5 * height());
    zoom_.middle = fromMiddle + (zoom_.middle - fromMiddle) * (after / before);
    zoom_.scale = after;
    keepInPane();
    update();
    Q_EMIT zoomed();
}

void PlanarView::keepInPane() {
    zoom_.middle.setX(std::clamp(zoom_.middle.x(), -0.5 * width(), 0.5 * width()));
    zoom_.middle.setY(std::clamp(zoom_.middle.y(), -0.5 * height(), 0.5 * height()));
}

void PlanarView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, labels_);
}

QImage PlanarView::pictureWithoutNames() const {
    QImage image(size() * devicePixelRatioF(), QImage::Format_RGB888);
    image.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&image);
    painter.setFont(font());
    PlanarLabels labels = labels_;
    labels.identity.clear();
    paint(painter, labels);
    return image;
}

void PlanarView::paint(QPainter& painter, const PlanarLabels& labels) const {
    painter.fillRect(rect(), Qt::black);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!picture_.isNull()) {
        painter.save();
        // Enlarged pixels stay pixels: what lies between them was not measured.
        painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_.scale.value_or(fittingScale()) < 1.0);
        painter.setTransform(paneFromPicture(), true);
        painter.drawImage(QPointF(0.0, 0.0), picture_);
        painter.restore();
        for (PlanarLayer* layer : layers_)
            layer->paint(painter, paneFromPicture(), paneFromPicture().mapRect(area()));
    }
    if (!message_.isEmpty()) {
        painter.setPen(kInk);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, message_);
    }
    paintLabels(painter, labels);
    if (!picture_.isNull()) paintScale(painter);
}

void PlanarView::paintLabels(QPainter& painter, const PlanarLabels& labels) const {
    const QFontMetricsF metrics(painter.font());
    QStringList warnings = labels.warnings;
    if (labels.mmPerPixel > 0.0) warnings += QString();  // the scale bar's line
    // In a low pane names go first, from the last line on, then the rest; warnings stay.
    const auto lines = qsizetype((height() - 2.0 * kMarginPx) / metrics.lineSpacing());
    const auto display = labels.display.mid(std::max<qsizetype>(0, labels.display.size() - lines));
    drawLines(painter, size(), Corner::topLeft,
              labels.identity.mid(0, std::max<qsizetype>(0, lines - display.size())), kInk);
    drawLines(painter, size(), Corner::topRight,
              labels.place.mid(0, std::max<qsizetype>(0, lines - warnings.size())), kInk);
    drawLines(painter, size(), Corner::bottomLeft, display, kInk);
    drawLines(painter, size(), Corner::bottomRight, warnings, kWarningInk);
    if (picture_.isNull()) return;
    const std::array<QString, 4> letters = edgeLetters(labels.towards, turn_);
    const double middleY = 0.5 * height() + 0.5 * metrics.ascent();
    const auto widthOf = [&](std::size_t i) { return metrics.horizontalAdvance(letters[i]); };
    drawHaloedText(painter, {kMarginPx, middleY}, letters[0], kInk);
    drawHaloedText(painter, {0.5 * (width() - widthOf(1)), kMarginPx + metrics.ascent()}, letters[1], kInk);
    drawHaloedText(painter, {width() - kMarginPx - widthOf(2), middleY}, letters[2], kInk);
    drawHaloedText(painter, {0.5 * (width() - widthOf(3)), height() - kMarginPx - metrics.descent()},
                   letters[3], kInk);
}

// A length on the screen is the same in both directions: shapeFromPicture() makes pixels as high as they are.
void PlanarView::paintScale(QPainter& painter) const {
    if (labels_.mmPerPixel <= 0.0) return;
    const auto bar = scaleBar(labels_.mmPerPixel / zoom_.scale.value_or(fittingScale()),
                              kLongestBarPart * width(), labels_.isCalibrated);
    if (!bar) return;
    const QFontMetricsF metrics(painter.font());
    const double right = width() - kMarginPx;
    const double bottom = height() - kMarginPx;
    QPainterPath path;
    path.moveTo(right - bar->lengthPx, bottom - kBarHeightPx);
    path.lineTo(right - bar->lengthPx, bottom);
    path.lineTo(right, bottom);
    path.lineTo(right, bottom - kBarHeightPx);
    drawHaloed(painter, path, kInk, 1.5);
    drawHaloedText(painter,
                   {right - bar->lengthPx - kMarginPx - metrics.horizontalAdvance(bar->text), bottom},
                   bar->text, kInk);
}

void PlanarView::resizeEvent(QResizeEvent*) {
    keepInPane();
}

void PlanarView::mousePressEvent(QMouseEvent* event) {
    lastAt_ = pressedAt_ = event->position();
    scrollRestPx_ = 0.0;
    if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier || picture_.isNull())
        return;
    for (auto layer = layers_.rbegin(); layer != layers_.rend() && taken_ == nullptr; ++layer)
        if ((*layer)->press(event->position())) taken_ = *layer;
}

void PlanarView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - std::exchange(lastAt_, event->position());
    const Qt::MouseButtons buttons = event->buttons();
    if (taken_ != nullptr) {
        taken_->drag(event->position());
        return Q_EMIT pointedAt(pixelAt(event->position()));
    }
    if (buttons != Qt::NoButton && event->modifiers() == Qt::ShiftModifier) {
        dragBy(moved, MouseDrag::pan);
    } else if ((buttons & Qt::MiddleButton) != 0) {
        dragBy(moved, mouseProfile().middle);
    } else if ((buttons & Qt::LeftButton) != 0) {
        dragBy(moved, mouseProfile().leftOnImages);
    } else if ((buttons & Qt::RightButton) != 0) {
        dragBy(moved, mouseProfile().right);
    } else {
        for (PlanarLayer* layer : layers_) layer->hover(event->position());
    }
    Q_EMIT pointedAt(pixelAt(event->position()));
}

void PlanarView::dragBy(QPointF moved, MouseDrag drag) {
    switch (drag) {
        case MouseDrag::window:
            return Q_EMIT windowDragged(moved);
        case MouseDrag::zoom:
            return zoomBy(std::pow(kDragZoomPerHeight, -moved.y() / std::max(height(), 1)), pressedAt_);
        case MouseDrag::scroll: {
            scrollRestPx_ += moved.y();
            const int images = int(scrollRestPx_ / kScrollPx);
            scrollRestPx_ -= images * kScrollPx;
            if (images != 0) Q_EMIT steppedBy(images);
            return;
        }
        case MouseDrag::pan:
        case MouseDrag::tool:
            break;
    }
    if (!zoom_.scale) zoom_.scale = fittingScale();
    zoom_.middle += moved;
    keepInPane();
    update();
    Q_EMIT zoomed();
}

void PlanarView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton && taken_ != nullptr)
        std::exchange(taken_, nullptr)->release(event->position());
}

void PlanarView::mouseDoubleClickEvent(QMouseEvent* event) {
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer)
        if ((*layer)->doubleClick(event->position())) return;
    fit();
}

void PlanarView::wheelEvent(QWheelEvent* event) {
    const int turned = event->angleDelta().y();
    if (event->modifiers() == Qt::ControlModifier)
        return zoomBy(std::pow(kZoomOfStep, double(turned) / kWheelStep), event->position());
    wheelRest_ += turned;
    const int steps = wheelRest_ / kWheelStep;
    wheelRest_ -= steps * kWheelStep;
    if (steps != 0) Q_EMIT steppedBy(-steps);
}

void PlanarView::leaveEvent(QEvent*) {
    Q_EMIT pointedAt({});
}

}  // namespace macula::viewer
