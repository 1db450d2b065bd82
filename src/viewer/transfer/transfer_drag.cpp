#include "viewer/transfer/transfer_drag.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "scene/transfer/edited_transfer.h"

namespace macula::viewer {

namespace {

constexpr double kOctavesPerHeight = 2.0;
constexpr double kMostOctaves = 40.0;
constexpr double kWidthOfAStep = 100.0;  // in preset values, for a curve without a width

// From where the opacity begins to change to where it ends; for constant opacity, the whole curve.
ValueRange slopeOf(const TransferFunction& function) {
    const auto& points = function.opacity;
    ValueRange all{points.front().value, points.back().value};
    const auto differs = [](const OpacityPoint& a, const OpacityPoint& b) { return a.opacity != b.opacity; };
    const auto first = std::adjacent_find(points.begin(), points.end(), differs);
    if (first == points.end()) return all;
    const auto last = std::adjacent_find(points.rbegin(), points.rend(), differs);
    return {first->value, last->value};
}

QString textOf(double shift, double factor, const QString& unit) {
    // A hand cannot move by less than a thousandth.
    const double shown = std::abs(shift) < 1e-3 ? 0.0 : shift;
    const QString by = QLocale().toString(std::abs(shown), 'f', std::abs(shown) >= 10.0 ? 0 : 2);
    return TransferDrag::tr("Transfer function: shifted by %1%2, %3 times as wide")
        .arg(shown < 0.0 ? QStringLiteral("\u2212") : QStringLiteral("+"),
             unit.isEmpty() ? by : by + QLatin1Char(' ') + unit)
        .arg(QLocale().toString(factor, 'f', 2));
}

}  // namespace

TransferDrag::TransferDrag(StudyEditor& session, const TransferFunctionEditor& editor, QObject* parent)
    : QObject(parent), session_(session), editor_(editor) {}

void TransferDrag::drag(QPointF byHeights) {
    if (isRefused_ || !session_.hasStudy() || !std::isfinite(byHeights.x()) || !std::isfinite(byHeights.y()))
        return;
    if (!base_) {
        base_ = editor_.edited();
        moved_ = {};
    }
    if (!base_ || base_->function.opacity.empty()) {
        isRefused_ = true;
        Q_EMIT told(
            tr("The transfer function cannot be moved yet: how it lies on these values is still counted."));
        return;
    }
    moved_ += byHeights;
    const TransferFunction& base = base_->function;
    const ValueRange slope = slopeOf(base);
    const double width = slope.high > slope.low ? slope.high - slope.low : kWidthOfAStep;
    const double shift = moved_.x() * width;
    const double factor = std::exp2(std::clamp(-kOctavesPerHeight * moved_.y(), -kMostOctaves, kMostOctaves));
    TransferFunction now =
        scene::shifted(scene::widened(base, factor, 0.5 * (slope.low + slope.high)), shift);
    session_.drag(tr("Transfer function"), [&](scene::StudyState& next) {
        next.preset = std::make_shared<const TransferFunction>(std::move(now));
    });
    Q_EMIT told(textOf(shift * base_->map.scale, factor,
                       QString::fromStdString(session_.study().volume->unitName())));
}

void TransferDrag::end() {
    if (!base_ && !isRefused_) return;
    base_.reset();
    isRefused_ = false;
    session_.endDrag();
    Q_EMIT told({});
}

}  // namespace macula::viewer
