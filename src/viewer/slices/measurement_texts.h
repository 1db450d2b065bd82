// What is written beside measurements, counted once.
#pragma once

#include <QString>
#include <vector>

#include "slices/measurement.h"

namespace macula::viewer {

// Values within an ellipse take milliseconds, and a pane is painted often.
class MeasurementTexts {
  public:
    QString of(const slices::Measurement& measurement, const Volume& volume);
    // Must be called before another volume is asked for.
    void forget() { known_.clear(); }

  private:
    struct Known {
        slices::Measurement measurement;
        QString text;
    };
    std::vector<Known> known_;  // the one counted last stands last
};

}  // namespace macula::viewer
