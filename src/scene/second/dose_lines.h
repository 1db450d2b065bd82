// The isodoses of a second volume that is a dose, as values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/second/isodoses.h"
#include "study/dose/dose_report.h"
#include "study/open/opened_study.h"

namespace macula::scene {

// What 100 percent of the dose are: a person's choice in the isodoses, else study::usualReference. Nothing if
// it is no dose, or no value is above 0.
std::optional<study::DoseReference> doseReference(const study::OpenedStudy& dose,
                                                  const std::optional<Isodoses>& isodoses);

struct DoseLine {
    double value = 0.0;             // in the unit of the dose
    std::optional<double> percent;  // of the reference; nothing without one
    std::array<std::uint8_t, 3> rgb{};

    bool operator==(const DoseLine&) const = default;
};

// From the highest to the lowest; none unless they are usable. Levels in percent need a reference.
std::vector<DoseLine> doseLines(const Isodoses& isodoses,
                                const std::optional<study::DoseReference>& reference);

}  // namespace macula::scene
