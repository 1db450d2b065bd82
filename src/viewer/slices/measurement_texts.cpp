#include "viewer/slices/measurement_texts.h"

#include <algorithm>

#include "viewer/harmless_text.h"
#include "viewer/language/core_words.h"
#include "viewer/slices/slice_texts.h"

namespace macula::viewer {

QString MeasurementTexts::of(const slices::Measurement& measurement, const Volume& volume) {
    const auto found = std::ranges::find(known_, measurement, &Known::measurement);
    if (found != known_.end()) return found->text;
    constexpr std::size_t kMost = 2048;  // more than a state has; each step of a moved one is one
    if (known_.size() == kMost) known_.erase(known_.begin());
    QString text = withLocalNumbers(QString::fromStdString(slices::textOf(measurement, volume)));
    if (!volume.provenance().isCalibrated && slices::hasSize(measurement)) text = notCalibrated(text);
    if (!measurement.label.empty())
        text = harmless(QString::fromStdString(measurement.label)) + QStringLiteral(": ") + text;
    known_.push_back({measurement, text});
    return text;
}

}  // namespace macula::viewer
