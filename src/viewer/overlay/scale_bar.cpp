#include "viewer/overlay/scale_bar.h"

#include <QCoreApplication>
#include <cmath>

#include "viewer/language/window_language.h"

namespace macula::viewer {

std::optional<ScaleBar> scaleBar(double mmPerPx, double mostPx, bool isCalibrated) {
    const double mostMm = mmPerPx * mostPx;
    if (!(mmPerPx > 0.0) || !(mostMm > 0.0) || !std::isfinite(mostMm)) return std::nullopt;
    constexpr double kRounding = 1e-9;  // or rounding in the last bit could turn 100 mm into 50
    const double power = std::pow(10.0, std::floor(std::log10(mostMm) + kRounding));
    double lengthMm = power;
    for (const double times : {2.0, 5.0})
        if (times * power <= mostMm * (1.0 + kRounding)) lengthMm = times * power;
    QString text =
        lengthMm >= 10.0
            ? QCoreApplication::translate("Slices", "%1 cm")
                  .arg(withLocalNumbers(QString::number(lengthMm / 10.0)))
            : QCoreApplication::translate("Slices", "%1 mm").arg(withLocalNumbers(QString::number(lengthMm)));
    if (!isCalibrated) text.prepend(QStringLiteral("≈ "));
    return ScaleBar{
        .lengthMm = lengthMm, .lengthPx = lengthMm / mmPerPx, .text = text, .isCalibrated = isCalibrated};
}

}  // namespace macula::viewer
