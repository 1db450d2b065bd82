// Messages about separating the patient from the table: the catalogue of docs/table-removal.md. Keys never
// change meaning. Sentences and actions hold no patient data.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace macula::segment {

struct CatalogueEntry {
    std::string_view key;
    Severity severity = Severity::info;
    std::string_view sentence;  // fmt syntax; its {names} are arguments, all of them required
    std::string_view action;    // advice to the user; may be empty
};

std::span<const CatalogueEntry> catalogue();

// `key` is in the catalogue, and `arguments` has every name that its sentence mentions; further ones are for
// programs.
Message message(std::string_view key, std::vector<TextArgument> arguments = {});

namespace key {
inline constexpr std::string_view kTableRemoved = "table-removed";
inline constexpr std::string_view kPartsRemoved = "parts-removed";
inline constexpr std::string_view kNothingToRemove = "nothing-to-remove";
inline constexpr std::string_view kTableTouchesPatient = "table-touches-patient";
inline constexpr std::string_view kPatientUncertain = "patient-uncertain";
inline constexpr std::string_view kNoPatient = "no-patient";
}  // namespace key

}  // namespace macula::segment
