// The scale bar of a picture.
#pragma once

#include <QString>
#include <optional>

namespace macula::viewer {

struct ScaleBar {
    double lengthMm = 0.0;  // 1, 2 or 5 times a power of ten
    double lengthPx = 0.0;
    QString text;  // "5 cm", "2 mm", "0.5 mm"; "≈ 5 cm" for an estimate
    bool isCalibrated = true;
};

// The longest bar of at most `mostPx`. Nothing unless `mmPerPx` is a positive number. `isCalibrated`:
// Provenance of what the picture shows.
std::optional<ScaleBar> scaleBar(double mmPerPx, double mostPx, bool isCalibrated);

}  // namespace macula::viewer
