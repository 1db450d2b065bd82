#include "viewer/planar/planar_measuring.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/overlay/haloed_drawing.h"
#include "viewer/planar/measurement_shape.h"
#include "viewer/planar/planar_view.h"
#include "viewer/slices/slice_popups.h"

namespace macula::viewer {

namespace {

constexpr double kHitPx = 8.0;       // logical, as below
constexpr double kOnePointPx = 3.0;  // nearer points are one
constexpr double kHandlePx = 3.5;
constexpr double kMarginPx = 8.0;
constexpr std::size_t kMostUndone = 200;
constexpr std::size_t kMostKnown = 64;
const QColor kInk(120, 210, 255);
const QColor kSelectedInk(255, 230, 90);

QPointF asPoint(const glm::dvec2& p) {
    return {p.x, p.y};
}

double lengthOf(const QPointF& by) {
    return std::hypot(by.x(), by.y());
}

double distanceToLine(const QPointF& place, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double part =
        square > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0) : 0.0;
    return lengthOf(place - from - part * along);
}

double distanceTo(const study::ImageMeasurement& measurement, const QPointF& place,
                  const QTransform& paneFromPicture) {
    double least = 1e9;
    for (const auto& line : linesOf(measurement))
        for (std::size_t i = 1; i < line.size(); ++i)
            least = std::min(least, distanceToLine(place, paneFromPicture.map(asPoint(line[i - 1])),
                                                   paneFromPicture.map(asPoint(line[i]))));
    return least;
}

}  // namespace

PlanarMeasuring::PlanarMeasuring(PlanarView& view) : QObject(&view), view_(view) {
    view.addLayer(*this);
}

void PlanarMeasuring::setAll(std::vector<study::ImageMeasurement> all) {
    all_ = std::move(all);
    done_.clear();
    undone_.clear();
    selected_.reset();
    held_.reset();
    moving_.reset();
    dropDrawing();
    Q_EMIT changed();
}

void PlanarMeasuring::setFrame(const MeasuredFrame& frame) {
    if (frame.image != frame_.image || frame.frame != frame_.frame) {
        points_.clear();
        selected_.reset();
        held_.reset();
        moving_.reset();
    }
    frame_ = frame;
    view_.update();
}

void PlanarMeasuring::setTool(std::optional<Kind> tool) {
    tool_ = tool;
    points_.clear();
    view_.setCursor(tool ? Qt::CrossCursor : Qt::ArrowCursor);
    view_.update();
    Q_EMIT toolChanged();
}

void PlanarMeasuring::dropDrawing() {
    points_.clear();
    view_.update();
}

bool PlanarMeasuring::isOnFrame(const study::ImageMeasurement& measurement) const {
    return frame_.header && measurement.image == frame_.image && measurement.frame == frame_.frame;
}

void PlanarMeasuring::follow(const std::vector<study::ImageMeasurement>& all) {
    if (all == all_) return;
    all_ = all;
    selected_.reset();
    held_.reset();
    moving_.reset();
    view_.update();
}

void PlanarMeasuring::record(Step step) {
    done_.push_back(std::move(step));
    if (done_.size() > kMostUndone) done_.erase(done_.begin());
    undone_.clear();
    Q_EMIT stepMade();
}

void PlanarMeasuring::change(const QString& what, std::vector<study::ImageMeasurement> next) {
    record({what, std::exchange(all_, std::move(next))});
    view_.update();
    Q_EMIT changed();
}

void PlanarMeasuring::restore(std::vector<Step>& from, std::vector<Step>& to) {
    if (from.empty()) return;
    Step step = std::move(from.back());
    from.pop_back();
    to.push_back({step.what, std::exchange(all_, std::move(step.before))});
    selected_.reset();
    held_.reset();
    moving_.reset();
    dropDrawing();
    Q_EMIT changed();
}

QString PlanarMeasuring::undoText() const {
    return done_.empty() ? QString() : done_.back().what;
}

QString PlanarMeasuring::redoText() const {
    return undone_.empty() ? QString() : undone_.back().what;
}

void PlanarMeasuring::undo() {
    restore(done_, undone_);
}

void PlanarMeasuring::redo() {
    restore(undone_, done_);
}

void PlanarMeasuring::removeSelected() {
    if (!selected_ || *selected_ >= all_.size()) return;
    std::vector<study::ImageMeasurement> next = all_;
    next.erase(next.begin() + std::ptrdiff_t(*selected_));
    selected_.reset();
    change(tr("Remove measurement"), std::move(next));
}

void PlanarMeasuring::removeAll() {
    if (all_.empty()) return;
    selected_.reset();
    change(tr("Remove measurements"), {});
}

void PlanarMeasuring::setLabel(std::size_t index, const QString& label) {
    if (index >= all_.size()) return;
    std::vector<study::ImageMeasurement> next = all_;
    next[index].label = label.toStdString();
    change(tr("Label"), std::move(next));
}

QString PlanarMeasuring::textOf(const study::ImageMeasurement& measurement) const {
    if (!frame_.header) return {};
    const auto known = std::ranges::find_if(known_, [&](const Known& each) {
        return each.measurement == measurement && each.pixels.lock() == frame_.pixels;
    });
    if (known != known_.end()) return known->text;
    const auto measured = study::measured(measurement, *frame_.header, frame_.pixels.get());
    if (known_.size() >= kMostKnown) known_.erase(known_.begin());
    known_.push_back(
        {measurement, frame_.pixels, withLocalNumbers(inWindowsLanguage(study::textOf(measured)))});
    return known_.back().text;
}

QString PlanarMeasuring::textsOfFrame() const {
    QStringList lines;
    for (const study::ImageMeasurement& each : all_) {
        if (!isOnFrame(each)) continue;
        const QString label = harmless(QString::fromStdString(each.label));
        lines += label.isEmpty() ? textOf(each) : QStringLiteral("%1: %2").arg(label, textOf(each));
    }
    return lines.join(QLatin1Char('\n'));
}

glm::dvec2 PlanarMeasuring::pixelOf(const QPointF& place) const {
    const QPointF pixel = view_.paneFromPicture().inverted().map(place);
    return {std::clamp(pixel.x(), 0.0, double(view_.picture().width())),
            std::clamp(pixel.y(), 0.0, double(view_.picture().height()))};
}

// The nearest handle; without one, the nearest line. Of equally near ones the later, which lies above.
std::optional<PlanarMeasuring::Held> PlanarMeasuring::heldAt(const QPointF& place) const {
    const QTransform paneFromPicture = view_.paneFromPicture();
    std::optional<Held> held;
    double nearest = kHitPx;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        if (!isOnFrame(all_[i])) continue;
        const std::vector<glm::dvec2> handles = handlesOf(all_[i]);
        for (std::size_t h = 0; h < handles.size(); ++h) {
            const double distance = lengthOf(place - paneFromPicture.map(asPoint(handles[h])));
            if (distance > nearest) continue;
            nearest = distance;
            held = Held{i, h};
        }
    }
    if (held) return held;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        if (!isOnFrame(all_[i])) continue;
        const double distance = distanceTo(all_[i], place, paneFromPicture);
        if (distance > nearest) continue;
        nearest = distance;
        held = Held{i, {}};
    }
    return held;
}

bool PlanarMeasuring::isFarFromLast(const QPointF& place) const {
    return points_.empty() ||
           lengthOf(place - view_.paneFromPicture().map(asPoint(points_.back()))) > kOnePointPx;
}

std::optional<study::ImageMeasurement> PlanarMeasuring::drawn() const {
    if (points_.empty() || !tool_) return {};
    study::ImageMeasurement measurement{
        .kind = *tool_, .image = frame_.image, .frame = frame_.frame, .points = points_};
    if (points_.size() < study::pointsOf(*tool_)) measurement.points.push_back(pointer_);
    return measurement;
}

void PlanarMeasuring::addPoint(const QPointF& place) {
    if (!isFarFromLast(place)) return;
    points_.push_back(pixelOf(place));
    if (points_.size() < study::pointsOf(*tool_)) return;
    const auto made = drawn();
    points_.clear();
    const bool isLine = made->kind != Kind::ellipse;
    const glm::dvec2 by = glm::abs(made->points[1] - made->points[0]);
    if (!isLine && !(by.x > 0.0 && by.y > 0.0)) return;
    if (all_.size() >= study::kMostImageMeasurements) return;
    std::vector<study::ImageMeasurement> next = all_;
    next.push_back(*made);
    selected_ = next.size() - 1;
    change(tr("Measurement"), std::move(next));
}

bool PlanarMeasuring::press(const QPointF& place) {
    if (!frame_.header) return false;
    pointer_ = pixelOf(place);
    if (isDrawing()) {
        addPoint(place);
        return true;
    }
    if (held_ = heldAt(place); held_) {
        selected_ = held_->index;
        heldFrom_ = place;
        moving_ = Step{tr("Move measurement"), all_};
        view_.update();
        return true;
    }
    selected_.reset();
    view_.update();
    if (!tool_ || !view_.pixelAt(place)) return false;
    addPoint(place);
    return true;
}

void PlanarMeasuring::drag(const QPointF& place) {
    pointer_ = pixelOf(place);
    if (held_ && held_->index < all_.size()) {
        study::ImageMeasurement& moved = all_[held_->index];
        if (held_->handle)
            moved = withHandleAt(moved, *held_->handle, pointer_);
        else
            moved = movedBy(moved, pointer_ - pixelOf(heldFrom_));
        heldFrom_ = place;
    }
    view_.update();
}

void PlanarMeasuring::release(const QPointF& place) {
    if (held_) {
        held_.reset();
        if (auto step = std::exchange(moving_, {}); step && step->before != all_) {
            std::vector<study::ImageMeasurement> next = std::exchange(all_, std::move(step->before));
            change(step->what, std::move(next));
        }
        return;
    }
    if (isDrawing() && isFarFromLast(place)) addPoint(place);
    view_.update();
}

void PlanarMeasuring::hover(const QPointF& place) {
    if (!isDrawing()) return;
    pointer_ = pixelOf(place);
    view_.update();
}

bool PlanarMeasuring::doubleClick(const QPointF& place) {
    if (!frame_.header) return false;
    if (isDrawing()) return true;
    const auto held = heldAt(place);
    if (!held) return false;
    selected_ = held->index;
    editLabel(held->index, place);
    return true;
}

void PlanarMeasuring::editLabelOfSelected() {
    if (!selected_ || *selected_ >= all_.size() || all_[*selected_].points.empty()) return;
    editLabel(*selected_, view_.paneFromPicture().map(asPoint(all_[*selected_].points.back())));
}

void PlanarMeasuring::editLabel(std::size_t index, const QPointF& place) {
    auto* editor = new LabelEditor(&view_, place.toPoint(), QString::fromStdString(all_[index].label));
    connect(editor, &LabelEditor::accepted, this, [this, of = all_[index]](const QString& label) {
        const auto same = std::ranges::find(all_, of);
        if (same != all_.end()) setLabel(std::size_t(same - all_.begin()), label);
    });
}

void PlanarMeasuring::paintOne(QPainter& painter, const study::ImageMeasurement& measurement, bool isSelected,
                               const QTransform& paneFromPicture) const {
    const QColor ink = isSelected ? kSelectedInk : kInk;
    QPainterPath path;
    for (const auto& line : linesOf(measurement)) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const QPointF at = paneFromPicture.map(asPoint(line[i]));
            if (i == 0)
                path.moveTo(at);
            else
                path.lineTo(at);
        }
    }
    drawHaloed(painter, path, ink, 1.5);
    for (const glm::dvec2& handle : handlesOf(measurement)) {
        QPainterPath dot;
        dot.addEllipse(paneFromPicture.map(asPoint(handle)), kHandlePx, kHandlePx);
        drawHaloed(painter, dot, ink, 1.0);
    }
    QStringList lines;
    if (!measurement.label.empty()) lines += harmless(QString::fromStdString(measurement.label));
    if (measurement.points.size() == study::pointsOf(measurement.kind)) lines += textOf(measurement);
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    const QRectF around = path.boundingRect();
    const double height = metrics.lineSpacing() * double(lines.size());
    const double x = std::clamp(around.right() + kMarginPx, kMarginPx,
                                std::max(kMarginPx, view_.width() - kMarginPx - width));
    double y =
        std::clamp(around.center().y(), kMarginPx, std::max(kMarginPx, view_.height() - kMarginPx - height));
    for (const QString& line : lines) {
        drawHaloedText(painter, {x, y + metrics.ascent()}, line, ink);
        y += metrics.lineSpacing();
    }
}

void PlanarMeasuring::paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF&) {
    for (std::size_t i = 0; i < all_.size(); ++i)
        if (isOnFrame(all_[i])) paintOne(painter, all_[i], selected_ == i, paneFromPicture);
    if (const auto now = drawn()) paintOne(painter, *now, true, paneFromPicture);
}

}  // namespace macula::viewer
