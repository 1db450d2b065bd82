bool isTaken(const QKeyEvent& event) {
    if (isArrow(event.key())) return true;
    if (event.modifiers().testFlag(Qt::ControlModifier)) return false;
    return event.key() == Qt::Key_Delete #include "viewer/transfer/transfer_curve.h"
#include <QEvent>
#include <QFontMetrics>
#include <QKeyEvent>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/transfer/edited_transfer.h"

           namespace macula::viewer {

        namespace {

        // Logical pixels.
        constexpr double kHitPx = 8.0;
        constexpr double kTopPx = 8.0;
        constexpr double kRightPx = 10.0;
        constexpr double kStripPx = 18.0;
        constexpr double kGapPx = 8.0;  // between plot and strip
        constexpr double kTicksApartPx = 80.0;
        constexpr double kOctavePx = 100.0;  // a drag up by so much makes twice as wide

        constexpr double kAngleOfHalf =
            240.0;  // of a wheel, in eighths of a degree: two steps halve the range
        constexpr double kKeysPerTick = 50.0;
        constexpr double kOpacityPerKey = 0.01;
        constexpr double kFactorPerKey = 1.02;
        constexpr double kFiner = 0.1;
        constexpr double kZoomPerKey = 1.25;
        constexpr double kRare = 0.001;  // of the values, at either end of the axis

        bool isArrow(int key) {
            return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
        }

        // Keys that a window may have a shortcut for; here they are for the points.
        bool isTaken(const QKeyEvent& event) {
            return isArrow(event.key()) || event.key() == Qt::Key_Delete ||
                   event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Insert ||
                   event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus ||
                   event.key() == Qt::Key_Equal || event.key() == Qt::Key_0;
        }

        }  // namespace

        TransferCurve::TransferCurve(QWidget * parent) : QWidget(parent) {
            setObjectName(QStringLiteral("transfer-curve"));
            setFocusPolicy(Qt::StrongFocus);
            setContextMenuPolicy(Qt::PreventContextMenu);  // the right button drags
            setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
            setAccessibleName(tr("Transfer function: opacity and colour over value"));
            describe();
        }

        void TransferCurve::setFunction(TransferFunction function, const app::ValueMap& map,
                                        const QString& unit) {
            const bool hadScales = hasFunction();
            function_ = std::move(function);
            map_ = map;
            if (unit != unit_ || !hadScales) invalidate();
            unit_ = unit;
            const auto sizeOf = [&](PointId::Curve curve) {
                return curve == PointId::Curve::opacity ? function_.opacity.size() : function_.colour.size();
            };
            if (selected_ && selected_->index >= sizeOf(selected_->curve)) select(std::nullopt);
            describe();
            update();
        }

        void TransferCurve::clear() {
            cancelDrag();
            select(std::nullopt);
            setFunction({}, {}, {});
            setHistogram(std::nullopt);
        }

        void TransferCurve::setHistogram(std::optional<app::Histogram> histogram) {
            histogram_ = std::move(histogram);
            invalidate();
        }

        void TransferCurve::fitAxis() {
            if (!hasFunction()) return;
            ValueRange range{
                map_.shownFrom(std::min(function_.opacity.front().value, function_.colour.front().value)),
                map_.shownFrom(std::max(function_.opacity.back().value, function_.colour.back().value))};
            if (histogram_) {
                range.low = std::min(range.low, app::percentile(*histogram_, kRare));
                range.high = std::max(range.high, app::percentile(*histogram_, 1.0 - kRare));
            }
            setAxis(app::ValueAxis::over(range, plotRect().width()), true);
        }

        void TransferCurve::cancelDrag() {
            drag_.reset();
            isNudging_ = false;
        }

        void TransferCurve::select(std::optional<PointId> point) {
            if (point == selected_) return;
            selected_ = point;
            describe();
            update();
            emit selectionChanged();
        }

        QPointF TransferCurve::placeOf(const PointId& point) const {
            const double x = plotRect().left() + axis_.pxOf(valueOf(point));
            if (point.curve == PointId::Curve::colour) return {x, stripRect().center().y()};
            return {x, plotRect().bottom() - function_.opacity.at(point.index).opacity * plotRect().height()};
        }

        QRectF TransferCurve::plotRect() const {
            const double left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + kGapPx;
            const double bottom = stripRect().top() - kGapPx;
            return {left, kTopPx, std::max(1.0, width() - left - kRightPx), std::max(1.0, bottom - kTopPx)};
        }

        QRectF TransferCurve::stripRect() const {
            const double left = fontMetrics().horizontalAdvance(QStringLiteral("0.5")) + kGapPx;
            return {left, axisRect().top() - kStripPx, std::max(1.0, width() - left - kRightPx), kStripPx};
        }

        QRectF TransferCurve::axisRect() const {
            const double high = fontMetrics().height() + kGapPx;
            return {0.0, height() - high, double(width()), high};
        }

        double TransferCurve::keyStep() const {
            return axis_.tickStep(kTicksApartPx) / kKeysPerTick;
        }

        QSize TransferCurve::sizeHint() const {
            return {480, 260};
        }

        QSize TransferCurve::minimumSizeHint() const {
            return {200, 140};
        }

        void TransferCurve::resizeEvent(QResizeEvent*) {
            axis_.lengthPx = plotRect().width();
            invalidate();
        }

        void TransferCurve::changeEvent(QEvent * event) {
            if (event->type() == QEvent::FontChange) axis_.lengthPx = plotRect().width();
            if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
                event->type() == QEvent::EnabledChange || event->type() == QEvent::StyleChange)
                invalidate();
            QWidget::changeEvent(event);
        }

        bool TransferCurve::event(QEvent * event) {
            if (event->type() == QEvent::ShortcutOverride && hasFunction() &&
                isTaken(*static_cast<QKeyEvent*>(event))) {
                event->accept();
                return true;
            }
            return QWidget::event(event);
        }

        double TransferCurve::presetValueAt(double px) const {
            return map_.presetFrom(axis_.valueAt(px - plotRect().left()));
        }

        double TransferCurve::opacityAtPx(double y) const {
            return std::clamp((plotRect().bottom() - y) / plotRect().height(), 0.0, 1.0);
        }

        double TransferCurve::valueOf(const PointId& point) const {
            return map_.shownFrom(point.curve == PointId::Curve::opacity
                                      ? function_.opacity.at(point.index).value
                                      : function_.colour.at(point.index).value);
        }

        // The nearest; of several at one place the last, which can be pulled off to the right.
        std::optional<PointId> TransferCurve::pointAt(QPointF at) const {
            std::optional<PointId> nearest;
            double distance = kHitPx;
            const auto look = [&](const PointId& point) {
                const double away = QLineF(placeOf(point), at).length();
                if (away > distance) return;
                distance = away;
                nearest = point;
            };
            for (std::size_t i = 0; i < function_.opacity.size(); ++i) look({PointId::Curve::opacity, i});
            for (std::size_t i = 0; i < function_.colour.size(); ++i) look({PointId::Curve::colour, i});
            return nearest;
        }

        void TransferCurve::setAxis(const app::ValueAxis& axis, bool isFitted) {
            axis_ = axis;
            isAxisFitted_ = isFitted;
            invalidate();
        }

        void TransferCurve::reveal(const PointId& point) {
            const double value = valueOf(point);
            if (axis_.contains(value)) return;
            setAxis(axis_.panned(value - 0.5 * (axis_.shown.low + axis_.shown.high)), false);
        }

        void TransferCurve::propose(const TransferFunction& function, bool isDrag) {
            if (function == function_) return;
            if (isDrag) {
                emit dragged(function);
            } else {
                emit edited(function);
            }
        }

        void TransferCurve::mousePressEvent(QMouseEvent * event) {
            if (drag_ || !hasFunction()) return;
            endNudge();
            const QPointF at = event->position();
            const std::optional<PointId> hit = pointAt(at);
            const bool isOverCurves = at.y() < axisRect().top();
            const bool isAlt = event->modifiers().testFlag(Qt::AltModifier);
            const Drag drag{.button = event->button(), .from = at, .base = function_, .axis = axis_};
            if (isOverCurves && (event->button() == Qt::RightButton ||
                                 (event->button() == Qt::LeftButton && isAlt && !hit))) {
                drag_ = drag;
                drag_->hand = Hand::whole;
            } else if (event->button() != Qt::LeftButton) {
                event->ignore();
            } else if (hit) {
                select(hit);
                beginPointDrag(*hit, *event);
            } else if (isOverCurves) {
                select(std::nullopt);
            } else {
                drag_ = drag;
                drag_->hand = Hand::axis;
            }
        }

        void TransferCurve::beginPointDrag(const PointId& point, const QMouseEvent& event) {
            drag_ = Drag{.hand = Hand::point,
                         .button = event.button(),
                         .from = event.position(),
                         .base = function_,
                         .axis = axis_,
                         .point = point,
                         .grabbedAt = placeOf(point) - event.position()};
        }

        void TransferCurve::mouseMoveEvent(QMouseEvent * event) {
            if (!drag_) return;
            const QPointF to = event->position();
            switch (drag_->hand) {
                case Hand::point:
                    dragPoint(to + drag_->grabbedAt);
                    break;
                case Hand::whole:
                    dragWhole(to, event->modifiers());
                    break;
                case Hand::axis:
                    setAxis(drag_->axis.panned((drag_->from.x() - to.x()) * drag_->axis.unitsPerPx()), false);
                    break;
            }
        }

        void TransferCurve::dragPoint(QPointF to) {
            const PointId point = drag_->point;
            const double value = presetValueAt(to.x());
            propose(point.curve == PointId::Curve::opacity
                        ? app::movedOpacityPoint(drag_->base, point.index, value, opacityAtPx(to.y()))
                        : app::movedColourPoint(drag_->base, point.index, value),
                    true);
        }

        void TransferCurve::dragWhole(QPointF to, Qt::KeyboardModifiers modifiers) {
            const double factor = std::exp2((drag_->from.y() - to.y()) / kOctavePx);
            if (modifiers.testFlag(Qt::ControlModifier)) {
                propose(app::withOpacityScaled(drag_->base, factor), true);
                return;
            }
            const double about = presetValueAt(drag_->from.x());
            propose(app::shifted(app::widened(drag_->base, factor, about), presetValueAt(to.x()) - about),
                    true);
        }

        void TransferCurve::mouseReleaseEvent(QMouseEvent * event) {
            if (!drag_ || event->button() != drag_->button) return;
            const Hand hand = drag_->hand;
            drag_.reset();
            if (hand != Hand::axis) emit dragEnded();
        }

        void TransferCurve::mouseDoubleClickEvent(QMouseEvent * event) {
            if (event->button() != Qt::LeftButton || drag_ || !hasFunction()) return;
            if (const std::optional<PointId> hit = pointAt(event->position())) {
                select(hit);
                if (hit->curve == PointId::Curve::colour) emit colourAsked();
            } else if (event->position().y() >= axisRect().top()) {
                fitAxis();
            } else {
                addAt(*event);
            }
        }

        // It stays under the hand until the button is let go: all of it is one step.
        void TransferCurve::addAt(const QMouseEvent& event) {
            const QPointF at = event.position();
            const double value = presetValueAt(at.x());
            const bool isColour = at.y() >= stripRect().top();
            const app::Added added = isColour
                                         ? app::withColourPoint(function_, value, colourAt(function_, value))
                                         : app::withOpacityPoint(function_, value, opacityAtPx(at.y()));
            if (!added.index) return;
            propose(added.function, true);
            if (!(function_ == added.function)) return;  // nobody wanted it
            const PointId point{isColour ? PointId::Curve::colour : PointId::Curve::opacity, *added.index};
            select(point);
            beginPointDrag(point, event);
        }

        void TransferCurve::wheelEvent(QWheelEvent * event) {
            event->accept();
            if (!hasFunction() || drag_) return;
            const QPoint angle = event->angleDelta();
            const double px = event->position().x() - plotRect().left();
            if (angle.y() != 0)
                setAxis(axis_.zoomed(std::exp2(-angle.y() / kAngleOfHalf), axis_.valueAt(px)), false);
            if (angle.x() != 0) setAxis(axis_.panned(-angle.x() * axis_.unitsPerPx()), false);
        }

        void TransferCurve::keyPressEvent(QKeyEvent * event) {
            if (!hasFunction() || drag_) return QWidget::keyPressEvent(event);
            const double middle =
                selected_ ? valueOf(*selected_) : 0.5 * (axis_.shown.low + axis_.shown.high);
            switch (event->key()) {
                case Qt::Key_Delete:
                case Qt::Key_Backspace:
                    return removeSelected();
                case Qt::Key_Insert:
                    return addBesideSelected();
                case Qt::Key_Plus:
                case Qt::Key_Equal:
                    return setAxis(axis_.zoomed(1.0 / kZoomPerKey, middle), false);
                case Qt::Key_Minus:
                    return setAxis(axis_.zoomed(kZoomPerKey, middle), false);
                case Qt::Key_0:
                    return fitAxis();
                case Qt::Key_Return:
                case Qt::Key_Enter:
                case Qt::Key_Space:
                    if (!selected_ || selected_->curve != PointId::Curve::colour) break;
                    emit colourAsked();
                    return;
                case Qt::Key_Escape:
                    if (!selected_) break;
                    return select(std::nullopt);
                default:
                    if (nudge(event->key(), event->modifiers())) return;
            }
            QWidget::keyPressEvent(event);
        }

        void TransferCurve::keyReleaseEvent(QKeyEvent * event) {
            if (isArrow(event->key()) && !event->isAutoRepeat()) endNudge();
            QWidget::keyReleaseEvent(event);
        }

        void TransferCurve::focusOutEvent(QFocusEvent * event) {
            endNudge();
            QWidget::focusOutEvent(event);
            update();
        }

        void TransferCurve::endNudge() {
            if (!std::exchange(isNudging_, false)) return;
            emit dragEnded();
        }

        bool TransferCurve::nudge(int key, Qt::KeyboardModifiers modifiers) {
            if (!isArrow(key)) return false;
            const double right = key == Qt::Key_Right ? 1.0 : key == Qt::Key_Left ? -1.0 : 0.0;
            const double up = key == Qt::Key_Up ? 1.0 : key == Qt::Key_Down ? -1.0 : 0.0;
            const bool isFine = modifiers.testFlag(Qt::ShiftModifier);
            isNudging_ = true;
            if (selected_) {
                nudgePoint(right, up, isFine);
            } else {
                nudgeWhole(right, up, isFine, modifiers.testFlag(Qt::ControlModifier));
            }
            return true;
        }

        void TransferCurve::nudgePoint(double right, double up, bool isFine) {
            const PointId point = *selected_;
            const double times = isFine ? kFiner : 1.0;
            // Without a step sideways, to the bit where it was.
            const auto moved = [&](double value) {
                return right == 0.0 ? value : value + right * times * keyStep() / map_.scale;
            };
            if (point.curve == PointId::Curve::opacity) {
                const OpacityPoint& from = function_.opacity[point.index];
                propose(app::movedOpacityPoint(function_, point.index, moved(from.value),
                                               from.opacity + up * times * kOpacityPerKey),
                        true);
            } else {
                propose(
                    app::movedColourPoint(function_, point.index, moved(function_.colour[point.index].value)),
                    true);
            }
            if (selected_) reveal(*selected_);
        }

        void TransferCurve::nudgeWhole(double right, double up, bool isFine, bool isScale) {
            const double times = isFine ? kFiner : 1.0;
            const double factor = std::pow(kFactorPerKey, up * times);
            if (right != 0.0) {
                propose(app::shifted(function_, right * times * keyStep() / map_.scale), true);
            } else if (isScale) {
                propose(app::withOpacityScaled(function_, factor), true);
            } else {
                const double middle =
                    0.5 * (function_.opacity.front().value + function_.opacity.back().value);
                propose(app::widened(function_, factor, middle), true);
            }
        }

        // Halfway to the next point, or to the end of the axis.
        void TransferCurve::addBesideSelected() {
            const PointId from = selected_.value_or(PointId{});
            const bool isColour = from.curve == PointId::Curve::colour;
            const std::size_t count = isColour ? function_.colour.size() : function_.opacity.size();
            const double low = selected_ ? valueOf(from) : axis_.shown.low;
            const bool hasNext = selected_ && from.index + 1 < count;
            const double high =
                hasNext ? valueOf({from.curve, from.index + 1}) : std::max(low, axis_.shown.high);
            const double value = map_.presetFrom(0.5 * (low + high));
            const app::Added added =
                isColour ? app::withColourPoint(function_, value, colourAt(function_, value))
                         : app::withOpacityPoint(function_, value, opacityAt(function_, value));
            if (!added.index) return;
            propose(added.function, false);
            if (!(function_ == added.function)) return;
            select(PointId{from.curve, *added.index});
            reveal(*selected_);
        }

        void TransferCurve::removeSelected() {
            if (!selected_) return;
            const PointId point = *selected_;
            const bool isColour = point.curve == PointId::Curve::colour;
            TransferFunction left = isColour ? app::withoutColourPoint(function_, point.index)
                                             : app::withoutOpacityPoint(function_, point.index);
            if (left == function_) return;  // the last of its curve
            propose(left, false);
            if (!(function_ == left)) return;
            // The one that has taken its place, so that several can be removed in a row.
            const std::size_t count = isColour ? left.colour.size() : left.opacity.size();
            selected_.reset();
            select(PointId{point.curve, std::min(point.index, count - 1)});
        }

        bool TransferCurve::focusNextPrevChild(bool next) {
            const std::size_t opacities = function_.opacity.size();
            if (!hasFunction() || !isEnabled()) return QWidget::focusNextPrevChild(next);
            std::optional<std::size_t> place;  // those of opacity, then those of colour
            if (!selected_) {
                place = next ? 0 : pointCount() - 1;
            } else {
                const std::size_t now = selected_->curve == PointId::Curve::opacity
                                            ? selected_->index
                                            : opacities + selected_->index;
                if (next && now + 1 < pointCount()) place = now + 1;
                if (!next && now > 0) place = now - 1;
            }
            endNudge();
            if (!place) {
                select(std::nullopt);
                return QWidget::focusNextPrevChild(next);
            }
            const bool isColour = *place >= opacities;
            select(isColour ? PointId{PointId::Curve::colour, *place - opacities}
                            : PointId{PointId::Curve::opacity, *place});
            reveal(*selected_);
            return true;
        }

        // For who does not see the picture.
        void TransferCurve::describe() {
            const QString unit = unit_.isEmpty() ? QString() : QStringLiteral(" ") + unit_;
            setToolTip(
                tr("Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how "
                   "often each value is in the volume behind it; colours below.\n"
                   "Drag a point; double click adds one, Delete removes it; arrows move it, with Shift "
                   "finer.\n"
                   "Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with "
                   "Ctrl: "
                   "more opaque upwards.\n"
                   "Wheel: zoom the axis; drag the axis to move it; double click on it shows all.")
                    .arg(unit.isEmpty() ? QString() : tr(" in %1").arg(unit_),
                         QLocale().toString(function_.unitDistanceMm, 'g', 4)));
            if (!selected_) {
                setAccessibleDescription(
                    tr("%1 points; none is selected. Arrows shift and widen all of them, Tab "
                       "goes through them.")
                        .arg(pointCount()));
                return;
            }
            const bool isColour = selected_->curve == PointId::Curve::colour;
            const QString value = QLocale().toString(valueOf(*selected_), 'g', 7) + unit;
            if (isColour) {
                setAccessibleDescription(tr("Colour point %1 of %2 at %3")
                                             .arg(QString::number(selected_->index + 1),
                                                  QString::number(function_.colour.size()), value));
            } else {
                setAccessibleDescription(
                    tr("Opacity point %1 of %2 at %3, opacity %4")
                        .arg(QString::number(selected_->index + 1), QString::number(function_.opacity.size()),
                             value, QLocale().toString(function_.opacity[selected_->index].opacity, 'g', 3)));
            }
        }

        void TransferCurve::invalidate() {
            background_ = QPixmap();
            update();
        }

    }  // namespace macula::viewer
