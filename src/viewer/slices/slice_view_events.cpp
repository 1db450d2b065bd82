// What a hand does on a slice.
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/camera.h"
#include "scene/drawing/projection_windows.h"
#include "viewer/keys/keys.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/label_editor.h"
#include "viewer/slices/slice_menu.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

namespace {

constexpr double kHitPx = 8.0;       // logical, as all below
constexpr double kOnePointPx = 3.0;  // nearer points are one
constexpr double kClickPx = 3.0;     // a right click moves no farther
constexpr int kManySlices = 5;       // with Shift, or by pages
constexpr int kNotch = 120;          // eighths of a degree: QWheelEvent
constexpr double kZoomPerNotch = 1.15;
constexpr double kDragZoomPerHeight = 6.0;  // times closer for a drag up over the height of the pane

// The point of the same plane that is nearest to `mm` and not beside the volume. Beside it there are no
// slices: other panes would show their last one, with a cross-hair that is somewhere else.
glm::dvec3 placeInVolume(const Volume& volume, const slices::SlicePlane& plane, const glm::dvec3& mm) {
    const auto corners = cornersOf(volume.worldBox());
    glm::dvec3 place = mm;
    for (const glm::dvec3& along : {plane.right, plane.down}) {
        double low = std::numeric_limits<double>::max();
        double high = std::numeric_limits<double>::lowest();
        for (const glm::dvec3& corner : corners) {
            low = std::min(low, glm::dot(corner, along));
            high = std::max(high, glm::dot(corner, along));
        }
        const double at = glm::dot(place, along);
        place += (std::clamp(at, low, high) - at) * along;
    }
    return place;
}

}  // namespace

// Its tool tip is for screen readers: on screen it would lie over the picture wherever the pointer rests.
bool SliceView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    event->accept();  // nor one of what it lies in
    return true;
}

void SliceView::resizeEvent(QResizeEvent*) {
    request();
}

void SliceView::showEvent(QShowEvent*) {
    request();
}

void SliceView::hideEvent(QHideEvent*) {
    setCine(false);
    endGesture();
    hoverAt_.reset();
}

void SliceView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void SliceView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void SliceView::leaveEvent(QEvent*) {
    hoverAt_.reset();
    update();
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    if (!shown_ || drag_ != Drag::none) return event->ignore();
    pressedAt_ = lastAt_ = event->position();
    hasDragged_ = false;
    dragButton_ = event->button();
    switch (dragButton_) {
        case Qt::LeftButton:
            press(event->position());
            break;
        case Qt::RightButton:
            drag_ = Drag::window;
            break;
        case Qt::MiddleButton:
            drag_ = Drag::pan;
            break;
        default:
            return event->ignore();
    }
    update();
}

void SliceView::press(const QPointF& place) {
    if (drawing_) {
        drawing_->press(worldAt(place));
        if (drawing_->isComplete()) {
            finishDrawing();
        } else {
            drag_ = Drag::draw;
        }
        return;
    }
    if (takeClip(place) || takeMeasurement(place)) return;
    selected_.reset();
    switch (tool_) {
        case SliceTool::crosshair:
            drag_ = Drag::crosshair;
            return setCrosshair(worldAt(place));
        case SliceTool::window:
            drag_ = Drag::window;
            return;
        case SliceTool::zoom:
            drag_ = Drag::zoom;
            return;
        case SliceTool::pan:
            drag_ = Drag::pan;
            return;
        case SliceTool::probe:
            drag_ = Drag::probe;
            return;
        case SliceTool::distance:
        case SliceTool::angle:
        case SliceTool::ellipse:
            break;
    }
    if (!showsStudy()) return;  // what is measured is kept with the study
    const slices::SliceFrame& frame = shown_->of.frame;
    drawing_.emplace(tool_, frame.plane, worldAt(place),
                     kOnePointPx * frame.mmPerPixel * shown_->of.pixelRatio);
    drag_ = Drag::draw;
}

// Not for those tools that act on the picture as a whole.
bool SliceView::takesHold() const {
    return tool_ != SliceTool::window && tool_ != SliceTool::zoom && tool_ != SliceTool::pan;
}

bool SliceView::takeClip(const QPointF& place) {
    const auto clip = takesHold() ? clipHandleAt(place) : std::nullopt;
    if (!clip) return false;
    heldClip_ = clip->handle;
    drag_ = Drag::clip;
    session_.endDrag();  // of what was dragged before
    return true;
}

// One that is seen.
bool SliceView::takeMeasurement(const QPointF& place) {
    if (!takesHold()) return false;
    const auto& measurements = session_.state().measurements;
    std::vector<bool> shown;
    for (const slices::Measurement& measurement : measurements) shown.push_back(isShownHere(measurement));
    const double ratio = shown_->of.pixelRatio;
    const auto hit = hitAt(measurements, shown, shown_->of.frame, glm::dvec2(place.x(), place.y()) * ratio,
                           kHitPx * ratio);
    if (!hit) return false;
    selected_ = hit->measurement;
    if (hit->handle) {
        heldHandle_ = *hit->handle;
        drag_ = Drag::handle;
    }
    return true;
}

std::optional<scene::PlacedHandle> SliceView::clipHandleAt(const QPointF& place) const {
    if (!showsClip_ || !hasClipHandles_ || !showsStudy()) return std::nullopt;
    const slices::SliceFrame& frame = shown_->of.frame;
    const scene::StudyState& state = session_.state();
    const double ratio = shown_->of.pixelRatio;
    return handleAt(scene::handlesOn(frame, state.clip, state.cuts, volume()), frame,
                    glm::dvec2(place.x(), place.y()) * ratio, kHitPx * ratio);
}

// What the clip refuses leaves it where it is.
void SliceView::moveClip(const QPointF& place) {
    if (!heldClip_ || !showsStudy()) return;
    const scene::StudyState& state = session_.state();
    const glm::dvec3 mm =
        scene::draggedTo(*heldClip_, worldAt(place), shown_->of.frame, state.clip, volume());
    const auto moved = scene::withHandleAt(state.clip, state.cuts, *heldClip_, mm, volume());
    if (!moved) return;
    session_.drag(tr("Clip"), [&](scene::StudyState& next) {
        next.clip = moved->clip;
        next.cuts = moved->cuts;
    });
}

void SliceView::showCursorAt(const QPointF& place) {
    if (drag_ != Drag::none || drawing_ || !hasClipHandles_) return;
    const auto handle = takesHold() ? clipHandleAt(place) : std::nullopt;
    setCursor(handle                    ? cursorOf(*handle, shown_->of.frame.plane)
              : tool_ == SliceTool::pan ? Qt::OpenHandCursor
                                        : Qt::CrossCursor);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    hoverAt_ = event->position();
    if (!shown_) return;
    showCursorAt(event->position());
    // A button that went up elsewhere: nobody told.
    if (drag_ != Drag::none && !event->buttons().testFlag(dragButton_)) {
        drag_ = Drag::none;
        heldClip_.reset();
        session_.endDrag();
    }
    dragTo(event->position());
    lastAt_ = event->position();
    update();
}

void SliceView::dragTo(const QPointF& place) {
    const QPointF by = place - lastAt_;
    const double heightPx = std::max(height(), 1);
    if (isStillClick(place)) return;
    hasDragged_ = hasDragged_ || drag_ != Drag::none;
    switch (drag_) {
        case Drag::crosshair:
            return setCrosshair(worldAt(place));
        case Drag::window: {
            const DisplayWindow next =
                scene::dragged(window(), glm::dvec2(by.x(), by.y()) / heightPx, wantedVolume());
            return proposeWindow(next, true);
        }
        case Drag::zoom:
            return zoomAt(pressedAt_, std::pow(kDragZoomPerHeight, -by.y() / heightPx));
        case Drag::pan:
            return look(panned(view_, plane(), {by.x(), by.y()}));
        case Drag::handle:
            return moveHandle(place);
        case Drag::clip:
            return moveClip(place);
        case Drag::draw:
        case Drag::none:
            if (drawing_) drawing_->move(worldAt(place));
            return;
        case Drag::probe:
            return;
    }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    if (drag_ == Drag::none || event->button() != dragButton_) return;
    const Drag ended = std::exchange(drag_, Drag::none);
    heldClip_.reset();
    if (ended == Drag::draw && drawing_ && shown_) {
        drawing_->release(worldAt(event->position()));
        if (drawing_->isComplete()) finishDrawing();
    }
    if (ended == Drag::crosshair || ended == Drag::window || ended == Drag::handle || ended == Drag::clip)
        session_.endDrag();
    update();
    if (dragButton_ == Qt::RightButton && !hasDragged_) showMenu(event->position());
}

// A hand that clicks moves a little.
bool SliceView::isStillClick(const QPointF& place) const {
    return dragButton_ == Qt::RightButton && drag_ == Drag::window && !hasDragged_ &&
           (place - pressedAt_).manhattanLength() <= kClickPx;
}

void SliceView::showMenu(const QPointF& place) {
    if (!shown_ || drawing_ || !showsStudy()) return;  // the second volume has its own bar
    const bool isMeant = takeMeasurement(place);
    drag_ = Drag::none;
    std::function<void()> edit;
    if (isMeant) edit = [this, index = *selected_] { editLabel(index); };
    QMenu* menu = makeSliceMenu({.session = &session_,
                                 .own = own_,
                                 .window = studyWindow(),
                                 .editLabel = std::move(edit),
                                 .fit = [this] { fit(); }},
                                this);
    menu->installEventFilter(this);
    menu->popup(mapToGlobal(place.toPoint()));
    update();
}

// The second click of a double one with the right button meets the menu that the first has opened.
bool SliceView::eventFilter(QObject* watched, QEvent* event) {
    auto* menu = qobject_cast<QMenu*>(watched);
    const bool isDouble = event->type() == QEvent::MouseButtonDblClick &&
                          static_cast<const QMouseEvent*>(event)->button() == Qt::RightButton;
    if (menu == nullptr || !isDouble) return QWidget::eventFilter(watched, event);
    menu->close();
    fit();
    return true;
}

void SliceView::editLabel(std::size_t index) {
    const auto& measurements = session_.state().measurements;
    if (!shown_ || index >= measurements.size()) return;
    const slices::Measurement edited = measurements[index];
    const glm::dvec2 px =
        shown_->of.frame.pictureFromWorld(handlesOf(edited).front()) / shown_->of.pixelRatio;
    const QString before = QString::fromStdString(edited.label);
    auto* editor = new LabelEditor(this, QPointF(px.x, px.y).toPoint(), before);
    connect(editor, &LabelEditor::accepted, this, [this, edited](const QString& text) {
        session_.change(tr("Label"), [&](scene::StudyState& next) {
            const auto found = std::ranges::find(next.measurements, edited);
            if (found != next.measurements.end()) found->label = text.toStdString();
        });
    });
}

// Its first click has begun a measurement: that was not meant. In the middle of one it is a click like any
// other.
void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) {  // where the first click opened no menu
        drag_ = Drag::none;
        return fit();
    }
    if (event->button() != Qt::LeftButton || (drawing_ && drawing_->pointsSet() > 1))
        return mousePressEvent(event);
    drawing_.reset();
    update();
    if (shown_ && takeMeasurement(event->position())) {
        drag_ = Drag::none;
        return editLabel(*selected_);
    }
    emit maximizeAsked();
}

void SliceView::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (!shown_) return;
    const QPoint turned = event->angleDelta();
    const int by = turned.y() != 0 ? turned.y() : turned.x();
    if (event->modifiers().testFlag(Qt::ControlModifier))
        return zoomAt(event->position(), std::pow(kZoomPerNotch, double(by) / kNotch));
    wheelRest_ += by;
    const int notches = wheelRest_ / kNotch;
    wheelRest_ -= notches * kNotch;
    if (notches != 0)
        moveBy(event->modifiers().testFlag(Qt::ShiftModifier) ? notches * kManySlices : notches);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    const Qt::KeyboardModifiers others = event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (steps_ && others == Qt::AltModifier && event->key() >= Qt::Key_1 && event->key() <= Qt::Key_9)
        return applyOwnWindow(event->key() - Qt::Key_0);
    if (steps_ && actionOf(*event) == KeyAction::fit) return fit();
    if (!steps_ || others != Qt::NoModifier ||
        !handleKey(event->key(), event->modifiers().testFlag(Qt::ShiftModifier)))
        QWidget::keyPressEvent(event);
}

// Whether it was one of its keys.
bool SliceView::handleKey(int key, bool withShift) {
    const QPointF middle(0.5 * width(), 0.5 * height());
    switch (key) {
        case Qt::Key_Up:
            return moveBy(withShift ? kManySlices : 1), true;
        case Qt::Key_Down:
            return moveBy(withShift ? -kManySlices : -1), true;
        case Qt::Key_PageUp:
            return moveBy(kManySlices), true;
        case Qt::Key_PageDown:
            return moveBy(-kManySlices), true;
        case Qt::Key_Home:
            return goTo(0, tr("Slice")), true;
        case Qt::Key_End:
            return goTo(steps_->count() - 1, tr("Slice")), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without Shift on many keyboards
            return zoomAt(middle, kZoomPerNotch), true;
        case Qt::Key_Minus:
            return zoomAt(middle, 1.0 / kZoomPerNotch), true;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            if (!selected_) return false;
            return removeSelected(), true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!selected_) return false;
            return editLabel(*selected_), true;
        case Qt::Key_Menu:
            return showMenu(hoverAt_.value_or(middle)), true;
        case Qt::Key_Escape:
            if (!drawing_) return false;
            return endGesture(), true;
        case Qt::Key_I:
            session_.change(tr("Inverted"), [](scene::StudyState& next) {
                next.slices.isInverted = !next.slices.isInverted;
            });
            return true;
        case Qt::Key_Space:
            if (role_ == PaneRole::second) return false;  // it follows the study
            return setCine(!isCineOn()), true;
        default:
            if (key < Qt::Key_1 || key > Qt::Key_9) return false;
            return applyWindow(key - Qt::Key_0), true;
    }
}

void SliceView::moveBy(int slices) {
    if (!steps_) return;
    if (wantsSecond() && !secondVolume()->isLinked()) return moveSecond(slices);
    goTo(slice() + (steps_->stepMm() > 0.0 ? slices : -slices), tr("Slice"));
}

void SliceView::goTo(int slice, const QString& what) {
    const glm::dvec3 to = steps_->onSlice(std::clamp(slice, 0, steps_->count() - 1), crosshairMm());
    session_.drag(what, [&](scene::StudyState& next) { next.slices.crosshairMm = to; });
    if (what == tr("Slice")) wheelEnds_.start();
}

void SliceView::setCine(bool on) {
    if (on == isCineOn() || (on && (!steps_ || !isVisible()))) return;
    if (on) {
        cine_.start();
    } else {
        cine_.stop();
        endOwnDrag(tr("Cine"));
    }
    emit cineChanged(on);
}

// Only once the slice before was seen: a slow machine shows all of them, more slowly.
void SliceView::cineStep() {
    if (!isUpToDate() || steps_->count() < 2) return;
    const int now = slice();
    if (now == 0) cineGoesBack_ = false;
    if (now == steps_->count() - 1) cineGoesBack_ = true;
    goTo(cineGoesBack_ ? now - 1 : now + 1, tr("Cine"));
}

void SliceView::zoomAt(const QPointF& place, double factor) {
    if (!steps_) return;
    const glm::ivec2 sizePx(width(), height());
    const glm::dvec2 fromMiddle = glm::dvec2(place.x(), place.y()) - 0.5 * glm::dvec2(sizePx);
    look(zoomed(view_, plane(), fromMiddle, factor, fittedView(volume(), *steps_, sizePx).mmPerPx));
}

void SliceView::look(const PaneView& view) {
    isFitted_ = false;
    view_ = withinReach(view, plane(), placedVolumes());
    request();
}

void SliceView::setCrosshair(const glm::dvec3& mm) {
    if (shown_->of.shows == SliceShows::secondByHand) return;  // it is no place in the study
    const glm::dvec3 to = showsStudy() ? placeInVolume(volume(), plane(), mm) : mm;
    session_.drag(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = to; });
}

void SliceView::moveHandle(const QPointF& place) {
    const auto& measurements = session_.state().measurements;
    if (!selected_ || *selected_ >= measurements.size()) return;
    const std::size_t at = *selected_;
    if (heldHandle_ >= handlesOf(measurements[at]).size()) return;
    const slices::Measurement moved = withHandleAt(measurements[at], heldHandle_, worldAt(place));
    session_.drag(tr("Measurement moved"),
                  [&](scene::StudyState& next) { next.measurements.at(at) = moved; });
}

void SliceView::finishDrawing() {
    const std::optional<slices::Measurement> made = drawing_->soFar();
    drawing_.reset();
    drag_ = Drag::none;
    if (!made) return;
    session_.change(tr("Measurement"), [&](scene::StudyState& next) { next.measurements.push_back(*made); });
    selected_ = session_.state().measurements.size() - 1;
    update();
}

void SliceView::removeSelected() {
    const std::size_t at = *selected_;
    selected_.reset();
    if (at >= session_.state().measurements.size()) return;
    session_.change(tr("Measurement removed"), [at](scene::StudyState& next) {
        next.measurements.erase(next.measurements.begin() + std::ptrdiff_t(at));
    });
}

void SliceView::endGesture() {
    if (drag_ == Drag::crosshair || drag_ == Drag::window || drag_ == Drag::handle || drag_ == Drag::clip)
        session_.endDrag();
    drag_ = Drag::none;
    heldClip_.reset();
    drawing_.reset();
    update();
}

// Of a step that a timer ends: by then, another hand may be at something else.
void SliceView::endOwnDrag(const QString& what) {
    if (session_.undoText() == what) session_.endDrag();
}

}  // namespace macula::viewer
