#include "segment/messages.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace macula::segment {

namespace {

constexpr std::array<CatalogueEntry, 6> kCatalogue{{
    {key::kTableRemoved, Severity::info,
     "The table is left out, and whatever else lies apart from the patient: {partsText}, {volumeText} "
     "(confidence {confidence}).",
     "Show the table again to see everything that was scanned."},
    {key::kPartsRemoved, Severity::info,
     "No table was found. What lies apart from the patient is left out: {partsText}, {volumeText} "
     "(confidence {confidence}).",
     "Show the table again to see everything that was scanned."},
    {key::kNothingToRemove, Severity::info, "Nothing lies apart from the patient; nothing is left out.", ""},
    {key::kTableTouchesPatient, Severity::warning,
     "The patient lies against the table in {slices} of {total} slices of the search grid; the surface "
     "between them is an estimate there, to about 3 mm.",
     "Do not judge the skin of the side that the patient lies on; show the table again for that."},
    {key::kPatientUncertain, Severity::warning,
     "It is not clear what is patient and what is table; nothing is left out.",
     "Cut the table away with a clip plane or box."},
    {key::kNoPatient, Severity::warning, "No patient was found in these images; nothing is left out.", ""},
}};

}  // namespace

std::span<const CatalogueEntry> catalogue() {
    return kCatalogue;
}

Message message(std::string_view key, std::vector<TextArgument> arguments) {
    const auto* const entry = std::find_if(kCatalogue.begin(), kCatalogue.end(),
                                           [&](const CatalogueEntry& e) { return e.key == key; });
    MACULA_CHECK(entry != kCatalogue.end());
    return {.severity = entry->severity,
            .key = std::string(key),
            .arguments = arguments,
            .sentence = Text::of(entry->sentence, std::move(arguments)),
            .action = Text::of(entry->action, {})};
}

}  // namespace macula::segment
