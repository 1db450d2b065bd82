// The bar that says how long something in a picture is.
#pragma once

#include <QString>
#include <optional>

namespace macula::viewer {

struct ScaleBar {
    double lengthMm = 0.0;  // 1, 2 or 5 times a power of ten
    double lengthPx = 0.0;
    QString text;  // "5 cm", "2 mm", "0.5 mm"; "≈ 5 cm" where that is an estimate
    bool isCalibrated = true;
};

// The longest that is at most `mostPx` long. Nothing where the scale is no positive number. `isCalibrated` as
// in Provenance, of what is in the picture.
std::optional<ScaleBar> scaleBar(double mmPerPx, double mostPx, bool isCalibrated);

}  // namespace macula::viewer
