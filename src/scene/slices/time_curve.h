// The mean of values within ellipses and outlines in each phase of a study.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "slices/measurement.h"
#include "study/open/opened_study.h"
#include "study/open/phases.h"

namespace macula::scene {

struct TimeCurve {
    std::string label;                                      // the measurement's; may be empty
    std::string kind = {};                                  // slices::kindOf it
    std::size_t number = 0;                                 // of the measurement, from 1
    std::vector<std::optional<slices::AreaValues>> values;  // of each phase; nothing: no voxel
};

struct TimeCurves {
    std::vector<study::Phase> phases;
    std::string unit;
    std::vector<TimeCurve> curves;
};

// `studies` has the volume of each phase. Measurements without an area have no curve. Errors: usage
// without one that has, or if the phases have different units; cancelled.
Result<TimeCurves> timeCurves(std::span<const slices::Measurement> measurements,
                              std::vector<study::Phase> phases,
                              const std::vector<std::shared_ptr<const study::OpenedStudy>>& studies,
                              const CancelToken& token);

// RFC 4180: a line for each phase, with the time in ms where all have one; mean and deviation of each curve.
std::string toCsv(const TimeCurves& curves);

}  // namespace macula::scene
