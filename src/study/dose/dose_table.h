// The figures of regions in a dose, for people and other programs.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "study/dose/dose_report.h"

namespace macula::study {

// In the unit of the dose, and shares from 0 to 1. NaN where nothing of the region lies in the dose.
struct DoseFigures {
    double minimum = 0.0;
    double mean = 0.0;
    double maximum = 0.0;
    double d98 = 0.0;  // what 98 % of the volume receive at least, and so on
    double d95 = 0.0;
    double d50 = 0.0;
    double d2 = 0.0;
    std::optional<double> v20Gy = {};  // the share that receives 20 Gy or more; nothing: not in Gy
    // The share that receives 95, 100 and 107 % of the reference or more; nothing without one.
    std::optional<double> v95 = {};
    std::optional<double> v100 = {};
    std::optional<double> v107 = {};
};
DoseFigures figuresOf(const RegionInDose& region, const DoseReport& report);

// "prescription", "maximum" or "choice": the name in files.
std::string_view nameOf(DoseReference::Of of);

// Lines for a terminal: a heading, a line for each region, and what the figures mean. Labels are printable.
std::string doseLines(const DoseReport& report);

// RFC 4180, in UTF-8: a line of names, then one for each region; lines end with CR LF. Numbers have a decimal
// point and six significant digits; fields that do not apply are empty. Texts as in scene::measurementsCsv.
std::string doseCsv(const DoseReport& report);

// Numbers that are not defined are null.
nlohmann::ordered_json doseJson(const DoseReport& report);

}  // namespace macula::study
