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
#include "viewer/overlay/slice_texts.h"

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
    setAccessibleDescription(
        tr("%1 mm along the curve, of %2 mm")
            .arg(mmText(picture_->of.sectionAtMm), mmText(picture_->frame->curve().lengthMm())));
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
        paintSides(painter);
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
    const slices::CurvedFrame::Column column = columnAtMark();
    const slices::SlicePlane& plane = picture_->sectionFrame.plane;
    const QPointF along(glm::dot(column.down, plane.right), glm::dot(column.down, plane.down));
    QPainterPath cut;
    for (const double way : {-1.0, 1.0}) {
        cut.moveTo(section.center() + way * 0.42 * section.width() * along);
        cut.lineTo(section.center() + way * 0.30 * section.width() * along);
    }
    drawHaloed(painter, cut, kMarkInk, 1.5);
}

QStringList CurveView::notes() const {
    const CurveRequest& of = picture_->of;
    QStringList notes;
    notes << (of.look.kind == slices::CurvedKind::straightened
                  ? tr("Straightened: lengths hold along the line")
                  : tr("Stretched: lengths hold along the curve and across it"));
    if (!of.phaseText.isEmpty()) notes << of.phaseText;
    if (const QString slab = slabText(of.slab); !slab.isEmpty()) notes << slab;
    if (of.isInverted) notes << (of.isLowBright ? tr("Low values are white") : tr("Inverted"));
    if (!of.volume->provenance().interpolatedSlices.empty()) notes << tr("Some slices are interpolated");
    if (!of.volume->provenance().isCalibrated) notes << tr("The size of pixels is not calibrated");
    return notes;
}

void CurveView::paintTexts(QPainter& painter) const {
    QString text = tr("%1 of %2 mm along the curve")
                       .arg(mmText(picture_->of.sectionAtMm), mmText(picture_->frame->curve().lengthMm()));
    if (hoverAt_) {
        if (const auto at = lengthAt(*hoverAt_))
            text += QLatin1String(", ") + tr("here %1 mm").arg(mmText(*at));
    }
    drawHaloedText(painter, {kGapPx * 1.0, height() - kGapPx * 1.0}, text, kInk);
    const double line = painter.fontMetrics().height();
    double y = line;
    for (const QString& note : notes()) {
        drawHaloedText(painter, {kGapPx * 1.0, y}, note, kInk);
        y += line;
    }
}

// Of the section, and of the curved plane at the mark: it turns along the curve.
void CurveView::paintSides(QPainter& painter) const {
    const auto paint = [&](const QRectF& box, const slices::SlicePlane& plane) {
        const scene::EdgeLetters letters = edgeLetters(plane);
        const double line = painter.fontMetrics().height();
        const double ascent = painter.fontMetrics().ascent();
        const auto widthOf = [&](const std::string& text) {
            return painter.fontMetrics().horizontalAdvance(QString::fromStdString(text));
        };
        const auto draw = [&](double x, double y, const std::string& text) {
            drawHaloedText(painter, {x, y}, QString::fromStdString(text), kInk);
        };
        draw(box.left() + 2.0, box.center().y() + 0.5 * ascent, letters.left);
        draw(box.right() - widthOf(letters.right) - 2.0, box.center().y() + 0.5 * ascent, letters.right);
        draw(box.center().x() - 0.5 * widthOf(letters.top), box.top() + line, letters.top);
        draw(box.center().x() - 0.5 * widthOf(letters.bottom), box.bottom() - 3.0, letters.bottom);
    };
    paint(sectionBox(), picture_->sectionFrame.plane);
    const slices::CurvedFrame::Column column = columnAtMark();
    paint(curvedBox(), {.centreMm = column.place.mm, .right = column.place.along, .down = column.down});
}

slices::CurvedFrame::Column CurveView::columnAtMark() const {
    const slices::CurvedFrame& frame = *picture_->frame;
    return frame.column(frame.pictureFromCurve(picture_->of.sectionAtMm).x);
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
