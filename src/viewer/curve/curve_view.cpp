#include "viewer/curve/curve_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/language/window_language.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

constexpr int kGapPx = 6;
constexpr double kScrollMm = 1.0;
constexpr double kScrollFastMm = 5.0;
constexpr int kNotch = 120;
const QColor kInk(235, 235, 235);
const QColor kCurveInk(255, 130, 220, 150);
const QColor kMarkInk(255, 225, 90);
const QColor kQuietInk(150, 150, 150);

QString mmText(double mm) {
    return withLocalNumbers(QString::number(mm, 'f', 1));
}

}  // namespace

CurveView::CurveView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
    setObjectName(QStringLiteral("curve-view"));
    setAccessibleName(tr("Curved plane"));
    setToolTip(tr("Click: the slices go there. Wheel, Left and Right: along the curve"));
}

void CurveView::show(CurvePicture picture) {
    picture_ = std::move(picture);
    message_.clear();
    setAccessibleDescription(tr("%1 mm along the curve, of %2 mm")
                                 .arg(mmText(picture_->of.sectionAtMm),
                                      mmText(picture_->frame->curve().lengthMm())));
    update();
}

void CurveView::clear(const QString& message) {
    picture_.reset();
    message_ = message;
    setAccessibleDescription(message);
    update();
}

int CurveView::sectionPx() const {
    const int side = std::min(height(), width() / 3);
    return std::max(1, int(std::lround(side * devicePixelRatioF())));
}

int CurveView::widthPx() const {
    return std::max(1, int(std::lround(width() * devicePixelRatioF())) - sectionPx() - kGapPx);
}

QRectF CurveView::sectionBox() const {
    const double side = double(picture_->section.width()) / picture_->of.pixelRatio;
    return {width() - side, 0.5 * (height() - side), side, side};
}

// As large as there is space, in the middle.
QRectF CurveView::curvedBox() const {
    const double space = sectionBox().left() - kGapPx;
    QSizeF size(picture_->curved.size());
    size.scale(space, height(), Qt::KeepAspectRatio);
    return {0.5 * (space - size.width()), 0.5 * (height() - size.height()), size.width(), size.height()};
}

std::optional<double> CurveView::lengthAt(const QPointF& place) const {
    if (!picture_) return {};
    const QRectF box = curvedBox();
    if (!box.contains(place)) return {};
    const double x = (place.x() - box.left()) / box.width() * picture_->frame->sizePx().x;
    return picture_->frame->column(x).place.atMm;
}

std::optional<glm::dvec3> CurveView::worldAt(const QPointF& place) const {
    if (!picture_) return {};
    const auto within = [&](const QRectF& box, const glm::ivec2& sizePx) {
        return glm::dvec2((place.x() - box.left()) / box.width(), (place.y() - box.top()) / box.height()) *
               glm::dvec2(sizePx);
    };
    if (const QRectF box = curvedBox(); box.contains(place))
        return picture_->frame->worldFromPicture(within(box, picture_->frame->sizePx()));
    if (const QRectF box = sectionBox(); box.contains(place))
        return picture_->sectionFrame.worldFromPicture(within(box, picture_->sectionFrame.sizePx));
    return {};
}

void CurveView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!picture_) {
        painter.setPen(kQuietInk);
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, message_);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(curvedBox(), picture_->curved);
        painter.drawImage(sectionBox(), picture_->section);
        painter.setRenderHint(QPainter::Antialiasing);
        paintMarks(painter);
        paintTexts(painter);
    }
    if (!hasFocus()) return;
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void CurveView::paintMarks(QPainter& painter) const {
    const QRectF box = curvedBox();
    const slices::CurvedFrame& frame = *picture_->frame;
    const double scale = box.width() / frame.sizePx().x;
    const auto onView = [&](double atMm) {
        const glm::dvec2 px = frame.pictureFromCurve(atMm) * scale;
        return QPointF(box.left() + px.x, box.top() + px.y);
    };
    QPainterPath line(onView(0.0));
    const double length = frame.curve().lengthMm();
    const int parts = std::max(2, int(box.width() / 3.0));
    for (int i = 1; i <= parts; ++i) line.lineTo(onView(length * i / parts));
    painter.setPen(QPen(kCurveInk, 1.0, Qt::DotLine));
    painter.drawPath(line);
    const double x = onView(std::clamp(picture_->of.sectionAtMm, 0.0, length)).x();
    QPainterPath mark(QPointF(x, box.top()));
    mark.lineTo(x, box.top() + 10.0);
    mark.moveTo(x, box.bottom() - 10.0);
    mark.lineTo(x, box.bottom());
    drawHaloed(painter, mark, kMarkInk, 1.5);
    // The curve meets the middle of the section; the line is where the curved plane cuts it.
    const QRectF section = sectionBox();
    const slices::CurvedFrame::Column column = frame.column(frame.pictureFromCurve(picture_->of.sectionAtMm).x);
    const slices::SlicePlane& plane = picture_->sectionFrame.plane;
    const QPointF along(glm::dot(column.down, plane.right), glm::dot(column.down, plane.down));
    QPainterPath cut;
    for (const double way : {-1.0, 1.0}) {
        cut.moveTo(section.center() + way * 0.42 * section.width() * along);
        cut.lineTo(section.center() + way * 0.30 * section.width() * along);
    }
    drawHaloed(painter, cut, kMarkInk, 1.5);
}

void CurveView::paintTexts(QPainter& painter) const {
    const double length = picture_->frame->curve().lengthMm();
    QString text =
        tr("%1 of %2 mm along the curve").arg(mmText(picture_->of.sectionAtMm), mmText(length));
    if (hoverAt_) {
        if (const auto at = lengthAt(*hoverAt_)) text += QLatin1String(", ") + tr("here %1 mm").arg(mmText(*at));
    }
    if (!picture_->of.volume->provenance().isCalibrated)
        text += QLatin1String(", ") + tr("the size of pixels is not calibrated");
    const double line = painter.fontMetrics().height();
    drawHaloedText(painter, {kGapPx * 1.0, height() - kGapPx * 1.0}, text, kInk);
    drawHaloedText(painter, {kGapPx * 1.0, line},
                   picture_->of.look.kind == slices::CurvedKind::straightened
                       ? tr("Straightened: lengths hold along the line")
                       : tr("Stretched: lengths hold along the curve and across it"),
                   kInk);
}

void CurveView::resizeEvent(QResizeEvent*) {
    Q_EMIT resized();
}

void CurveView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    if (const auto mm = worldAt(event->position())) Q_EMIT pointed(*mm, false);
}

void CurveView::mouseMoveEvent(QMouseEvent* event) {
    hoverAt_ = event->position();
    update();
    if (!event->buttons().testFlag(Qt::LeftButton)) return;
    if (const auto mm = worldAt(event->position())) Q_EMIT pointed(*mm, true);
}

void CurveView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) Q_EMIT released();
}

void CurveView::leaveEvent(QEvent*) {
    hoverAt_.reset();
    update();
}

void CurveView::wheelEvent(QWheelEvent* event) {
    const bool isFast = event->modifiers().testFlag(Qt::ShiftModifier);
    const QPoint turned = event->angleDelta();
    const double notches = double(turned.y() != 0 ? turned.y() : turned.x()) / kNotch;
    Q_EMIT scrolledBy(notches * (isFast ? kScrollFastMm : kScrollMm));
    event->accept();
}

void CurveView::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? kScrollFastMm : kScrollMm;
    if (event->key() == Qt::Key_Left) return Q_EMIT scrolledBy(-step);
    if (event->key() == Qt::Key_Right) return Q_EMIT scrolledBy(step);
    QWidget::keyPressEvent(event);
}

}  // namespace macula::viewer
