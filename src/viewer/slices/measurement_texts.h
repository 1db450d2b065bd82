// Caches the texts beside measurements.
#pragma once

#include <QString>
#include <vector>

#include "slices/measurement.h"

namespace macula::viewer {

// Caching pays: measuring an ellipse takes milliseconds, and a pane is painted often.
class MeasurementTexts {
  public:
    QString of(const slices::Measurement& measurement, const Volume& volume);
    // Call it before of() gets another volume.
    void forget() { known_.clear(); }

  private:
    struct Known {
        slices::Measurement measurement;
        QString text;
    };
    std::vector<Known> known_;  // the latest is last
};

}  // namespace macula::viewer
