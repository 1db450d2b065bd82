#include "dicom/value_unit.h"

#include <algorithm>
#include <array>

namespace macula::dicom {

namespace {

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames) {
    // PET says it in an attribute of its own (PS3.3 C.8.9.1.1.3), real world values in a code of UCUM.
    const auto nameOf = [](const Frame& frame) {
        return frame.realWorld || frame.units.empty() ? frame.rescaleType : frame.units;
    };
    const std::string name = nameOf(frames.front());
    if (std::ranges::any_of(frames, [&](const Frame& frame) { return nameOf(frame) != name; })) return {};
    if (modality == "CT" && isOneOf(name, {"", "HU", "[hnsf'U]"})) return {Unit::hounsfield, {}};
    if (isOneOf(name, {"BQML", "Bq/ml", "Bq/mL"})) return {Unit::becquerelsPerMillilitre, {}};
    if (isOneOf(name, {"g/ml{SUVbw}", "{SUVbw}g/ml"})) return {Unit::suvBodyWeight, {}};
    if (name == "GML") return {Unit::other, "g/mL"};  // of body weight, or of what SUVType says
    // US is "unspecified", CNTS counts of the scanner.
    if (isOneOf(name, {"", "US", "CNTS", "1", "[arb'U]"})) return {};
    return {Unit::other, name};
}

}  // namespace macula::dicom
