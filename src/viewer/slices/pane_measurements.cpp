#include "viewer/slices/pane_measurements.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "slices/interpolated.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

// No image was taken there: values come from neighbouring images, and a person saw the ends in interpolated
// slices.
QString interpolated(const QString& text, const slices::Measurement& measurement, double share) {
    if (!slices::hasArea(measurement))
        return QCoreApplication::translate("Slices", "%1, ends in interpolated slices").arg(text);
    constexpr double kPercent = 100.0;
    const int percent = std::max(1, int(std::lround(kPercent * share)));
    return QCoreApplication::translate("Slices", "%1, %2 % interpolated").arg(text).arg(percent);
}

constexpr double kHitPx = 8.0;       // logical, as below
constexpr double kOnePointPx = 3.0;  // nearer points are one
constexpr double kSamePlaneMm = 1e-6;

}  // namespace

QString MeasurementTexts::of(const slices::Measurement& measurement,
                             const std::shared_ptr<const Volume>& of) {
    const Volume& volume = *of;
    const auto found = std::ranges::find_if(known_, [&](const Known& known) {
        return known.measurement == measurement && known.volume.lock() == of;
    });
    if (found != known_.end()) return found->text;
    constexpr std::size_t kMost = 2048;  // more than a state has; each step of a drag adds one
    if (known_.size() == kMost) known_.erase(known_.begin());
    QString text = withLocalNumbers(QString::fromStdString(slices::textOf(measurement, volume)));
    if (!volume.provenance().isCalibrated && slices::hasSize(measurement)) text = notCalibrated(text);
    const bool isArrow = std::holds_alternative<slices::Arrow>(measurement.shape);
    const double share = isArrow ? 0.0 : slices::interpolatedShare(measurement, volume);
    if (share > 0.0) text = interpolated(text, measurement, share);
    const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape);
    if (lesion != nullptr && lesion->isNode)
        text = QCoreApplication::translate("Slices", "%1, lymph node").arg(text);
    if (!measurement.label.empty()) {
        const QString label = harmless(QString::fromStdString(measurement.label));
        text = text.isEmpty() ? label : label + QStringLiteral(": ") + text;
    }
    known_.push_back({measurement, of, text});
    return text;
}

PaneMeasurements::PaneMeasurements(StudyEditor& session, const PaneContent& content)
    : session_(session), content_(content) {}

void PaneMeasurements::forget() {
    selected_.reset();
    texts_.forget();
}

// Finds it even if earlier ones were added or removed; if it was only moved, it has the same index.
bool PaneMeasurements::follow(const scene::StudyState& before) {
    const auto& now = session_.state().measurements;
    if (!selected_ || now == before.measurements) return false;
    std::optional<std::size_t> followed;
    if (*selected_ < before.measurements.size()) {
        const auto found = std::ranges::find(now, before.measurements[*selected_]);
        if (found != now.end()) {
            followed = std::size_t(found - now.begin());
        } else if (now.size() == before.measurements.size()) {
            followed = selected_;
        }
    }
    selected_ = followed;
    return !selected_;
}

bool PaneMeasurements::isSeen(const slices::Measurement& measurement, const SliceRequest& shown) const {
    return shown.showsStudy() &&
           slices::liesIn(measurement, shown.frame.plane, 0.5 * std::abs(content_.steps().stepMm()));
}

std::optional<Hit> PaneMeasurements::selectAt(const QPointF& place, const SliceRequest& shown) {
    const auto& measurements = session_.state().measurements;
    std::vector<bool> seen;
    for (const slices::Measurement& measurement : measurements) seen.push_back(isSeen(measurement, shown));
    const auto hit =
        hitAt(measurements, seen, shown.frame, shown.frameFromPane(place), kHitPx * shown.pixelRatio);
    if (hit) selected_ = hit->measurement;
    return hit;
}

void PaneMeasurements::moveHandle(std::size_t handle, const glm::dvec3& mm) {
    const auto& measurements = session_.state().measurements;
    if (!selected_ || *selected_ >= measurements.size()) return;
    const std::size_t at = *selected_;
    if (handle >= handlesOf(measurements[at]).size()) return;
    const slices::Measurement moved = withHandleAt(measurements[at], handle, mm);
    session_.drag(tr("Measurement moved"),
                  [&](scene::StudyState& next) { next.measurements.at(at) = moved; });
}

void PaneMeasurements::removeSelected() {
    if (!selected_) return;
    const std::size_t at = *selected_;
    selected_.reset();
    if (at >= session_.state().measurements.size()) return;
    session_.change(tr("Measurement removed"), [at](scene::StudyState& next) {
        next.measurements.erase(next.measurements.begin() + std::ptrdiff_t(at));
    });
}

bool PaneMeasurements::goesOnOver(const SliceRequest& shown) const {
    const slices::SlicePlane& drawn = drawing_->plane();
    const slices::SlicePlane& now = shown.frame.plane;
    const double offMm = std::abs(shown.frame.distanceMm(drawn.centreMm));
    return shown.showsStudy() && drawn.right == now.right && drawn.down == now.down &&
           !(offMm > kSamePlaneMm);
}

void PaneMeasurements::beginDrawing(SliceTool tool, const QPointF& place, const SliceRequest& shown) {
    drawing_.emplace(tool, shown.frame.plane, shown.worldFromPane(place),
                     kOnePointPx * shown.frame.mmPerPixel * shown.pixelRatio);
}

void PaneMeasurements::moveDrawing(const glm::dvec3& mm, bool isHeld) {
    if (drawing_) drawing_->move(mm, isHeld);
}

void PaneMeasurements::pressDrawing(const glm::dvec3& mm) {
    drawing_->press(mm);
    finishIfComplete();
}

void PaneMeasurements::releaseDrawing(const glm::dvec3& mm) {
    if (!drawing_) return;
    drawing_->release(mm);
    finishIfComplete();
}

void PaneMeasurements::finishIfComplete() {
    if (!drawing_->isComplete()) return;
    const std::optional<slices::Measurement> made = drawing_->soFar();
    drawing_.reset();
    if (!made) return;
    session_.change(tr("Measurement"), [&](scene::StudyState& next) { next.measurements.push_back(*made); });
    selected_ = session_.state().measurements.size() - 1;
    if (std::holds_alternative<slices::Arrow>(made->shape)) finishedArrow_ = selected_;
}

void PaneMeasurements::setNode(std::size_t measurement, bool isNode) {
    session_.change(tr("Lymph node"), [&](scene::StudyState& next) {
        if (measurement >= next.measurements.size()) return;
        auto& shape = next.measurements[measurement].shape;
        if (auto* lesion = std::get_if<slices::Bidirectional>(&shape)) lesion->isNode = isNode;
    });
}

std::vector<ShownMeasurement> PaneMeasurements::seenOn(const SliceRequest& shown) {
    std::vector<ShownMeasurement> seen;
    const auto& measurements = session_.state().measurements;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (!isSeen(measurements[i], shown)) continue;
        seen.push_back({.measurement = measurements[i],
                        .text = textOf(measurements[i], shown),
                        .isSelected = selected_ == i});
    }
    const auto drawn = drawing_ ? drawing_->soFar() : std::nullopt;
    if (drawn)
        seen.push_back({.measurement = *drawn,
                        .text = textWhileDrawn(*drawn, shown),
                        .isSelected = true,
                        .hasHandles = !drawing_->isFreehand()});
    return seen;
}

// Values come from the plane alone, whatever the slab projects onto it.
QString PaneMeasurements::textOf(const slices::Measurement& measurement, const SliceRequest& shown) {
    const QString text = texts_.of(measurement, shown.volume);
    const bool isOfPlane = shown.slab.thicknessMm > 0.0 && slices::hasArea(measurement);
    return isOfPlane ? tr("Plane alone: %1").arg(text) : text;
}

// Shows only the size: counting values takes too long for each step of the drag.
QString PaneMeasurements::textWhileDrawn(const slices::Measurement& measurement, const SliceRequest& shown) {
    const bool isCalibrated = shown.volume->provenance().isCalibrated;
    if (std::holds_alternative<slices::OpenLine>(measurement.shape)) {
        // Not kept: each step of a long line has all of its points.
        const QString text =
            withLocalNumbers(QString::fromStdString(slices::textOf(measurement, *shown.volume)));
        return isCalibrated ? text : notCalibrated(text);
    }
    if (!slices::hasArea(measurement)) return texts_.of(measurement, shown.volume);
    const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape);
    const double area =
        ellipse ? slices::areaMm2(*ellipse) : slices::areaMm2(std::get<slices::Outline>(measurement.shape));
    if (!std::isfinite(area)) return {};  // of an outline that crosses itself
    return sizeText(tr("%1 mm²").arg(std::llround(area)), isCalibrated);
}

}  // namespace macula::viewer
