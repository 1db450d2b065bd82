#include "viewer/slices/measurement_texts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
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
    if (!std::holds_alternative<slices::Ellipse>(measurement.shape))
        return QCoreApplication::translate("Slices", "%1, ends in interpolated slices").arg(text);
    constexpr double kPercent = 100.0;
    const int percent = std::max(1, int(std::lround(kPercent * share)));
    return QCoreApplication::translate("Slices", "%1, %2 % interpolated").arg(text).arg(percent);
}

}  // namespace

QString MeasurementTexts::of(const slices::Measurement& measurement, const Volume& volume) {
    const auto found = std::ranges::find(known_, measurement, &Known::measurement);
    if (found != known_.end()) return found->text;
    constexpr std::size_t kMost = 2048;  // more than a state has; each step of a drag adds one
    if (known_.size() == kMost) known_.erase(known_.begin());
    QString text = withLocalNumbers(QString::fromStdString(slices::textOf(measurement, volume)));
    if (!volume.provenance().isCalibrated && slices::hasSize(measurement)) text = notCalibrated(text);
    if (const double share = slices::interpolatedShare(measurement, volume); share > 0.0)
        text = interpolated(text, measurement, share);
    if (!measurement.label.empty())
        text = harmless(QString::fromStdString(measurement.label)) + QStringLiteral(": ") + text;
    known_.push_back({measurement, text});
    return text;
}

}  // namespace macula::viewer
