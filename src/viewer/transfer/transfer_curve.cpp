#include "viewer/transfer/transfer_curve.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <utility>

namespace macula::viewer {

TransferCurve::TransferCurve(QWidget* parent)
    : QWidget(parent),
      plot_([this] { return TransferLayout::of(size(), fontMetrics()); }),
      edits_(plot_),
      hand_(plot_, edits_),
      keys_(plot_, edits_),
      painting_(plot_) {
    setObjectName(QStringLiteral("transfer-curve"));
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::PreventContextMenu);  // the right button drags
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Transfer function: opacity and colour over value"));
    listen();
    describe();
}

void TransferCurve::listen() {
    connect(&plot_, &TransferPlot::scalesChanged, this, &TransferCurve::forgetBackground);
    connect(&edits_, &TransferEdits::edited, this, &TransferCurve::edited);
    connect(&edits_, &TransferEdits::dragged, this, &TransferCurve::dragged);
    connect(&edits_, &TransferEdits::dragEnded, this, &TransferCurve::dragEnded);
    connect(&edits_, &TransferEdits::colourAsked, this, &TransferCurve::colourAsked);
    connect(&edits_, &TransferEdits::selectionChanged, this, [this] {
        describe();
        update();
        Q_EMIT selectionChanged();
    });
}

void TransferCurve::setFunction(TransferFunction function, const scene::ValueMap& map, const QString& unit) {
    plot_.setFunction(std::move(function), map, unit);
    edits_.deselectIfGone();
    describe();
    update();
}

void TransferCurve::clear() {
    cancelDrag();
    select(std::nullopt);
    setFunction({}, {}, {});
    setHistogram(std::nullopt);
}

void TransferCurve::setHistogram(std::optional<scene::Histogram> histogram) {
    plot_.setHistogram(std::move(histogram));
}

void TransferCurve::cancelDrag() {
    hand_.cancel();
    keys_.cancel();
}

QSize TransferCurve::sizeHint() const {
    return {380, 260};
}

QSize TransferCurve::minimumSizeHint() const {
    return {200, 140};
}

void TransferCurve::resizeEvent(QResizeEvent*) {
    plot_.takeLength();
}

void TransferCurve::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) plot_.takeLength();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::EnabledChange ||
        event->type() == QEvent::StyleChange)
        forgetBackground();
    QWidget::changeEvent(event);
}

void TransferCurve::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painting_.paint(painter,
                    {.size = size(),
                     .pixelRatio = devicePixelRatioF(),
                     .palette = palette(),
                     .font = font(),
                     .metrics = fontMetrics(),
                     .hasFocus = hasFocus()},
                    edits_.selected());
}

bool TransferCurve::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && plot_.hasFunction() &&
        TransferKeys::isTaken(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void TransferCurve::mousePressEvent(QMouseEvent* event) {
    if (hand_.isDragging() || !plot_.hasFunction()) return;
    keys_.end();
    hand_.press(*event);
}

void TransferCurve::mouseMoveEvent(QMouseEvent* event) {
    hand_.move(*event);
}

void TransferCurve::mouseReleaseEvent(QMouseEvent* event) {
    hand_.release(*event);
}

void TransferCurve::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!hand_.isDragging() && plot_.hasFunction()) hand_.doubleClick(*event);
}

void TransferCurve::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (!hand_.isDragging() && plot_.hasFunction()) hand_.turnWheel(*event);
}

void TransferCurve::keyPressEvent(QKeyEvent* event) {
    if (!plot_.hasFunction() || hand_.isDragging() || !keys_.press(*event)) QWidget::keyPressEvent(event);
}

void TransferCurve::keyReleaseEvent(QKeyEvent* event) {
    keys_.release(*event);
    QWidget::keyReleaseEvent(event);
}

void TransferCurve::focusOutEvent(QFocusEvent* event) {
    keys_.end();
    QWidget::focusOutEvent(event);
    update();
}

bool TransferCurve::focusNextPrevChild(bool next) {
    if (!plot_.hasFunction() || !isEnabled()) return QWidget::focusNextPrevChild(next);
    keys_.end();
    return edits_.selectNext(next) || QWidget::focusNextPrevChild(next);
}

// For people who cannot see the picture.
void TransferCurve::describe() {
    const TransferFunction& function = plot_.function();
    const std::optional<PointId> selected = edits_.selected();
    const QString unit = plot_.unit().isEmpty() ? QString() : QStringLiteral(" ") + plot_.unit();
    setToolTip(tr("Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how "
                  "often each value is in the volume behind it; colours below.\n"
                  "Drag a point; double click adds one, Delete removes it; arrows move it, with Shift "
                  "finer.\n"
                  "Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with "
                  "Ctrl: more opaque upwards.\n"
                  "Wheel: zoom the axis; drag the axis to move it; double click on it shows all.")
                   .arg(unit.isEmpty() ? QString() : tr(" in %1").arg(plot_.unit()),
                        QLocale().toString(function.unitDistanceMm, 'g', 4)));
    if (!selected) {
        setAccessibleDescription(
            tr("%n points; none is selected. Arrows shift and widen all of them, Tab "
               "goes through them.",
               nullptr, plot_.pointCount()));
        return;
    }
    const bool isColour = selected->curve == PointId::Curve::colour;
    const QString value = QLocale().toString(plot_.valueOf(*selected), 'g', 7) + unit;
    if (isColour) {
        setAccessibleDescription(
            tr("Colour point %1 of %2 at %3")
                .arg(QString::number(selected->index + 1), QString::number(function.colour.size()), value));
    } else {
        setAccessibleDescription(
            tr("Opacity point %1 of %2 at %3, opacity %4")
                .arg(QString::number(selected->index + 1), QString::number(function.opacity.size()), value,
                     QLocale().toString(function.opacity[selected->index].opacity, 'g', 3)));
    }
}

void TransferCurve::forgetBackground() {
    painting_.forget();
    update();
}

}  // namespace macula::viewer
