// The error for a folder with several patients where the caller named no series.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"
#include "study/open/found_volumes.h"

namespace macula::study {

// inputNotUsable with a list: the series of each patient, by their numbers in `macula info`, which
// FoundVolumes::ofSeries takes. It numbers patients and names none. Nothing if all volumes belong to one
// patient.
std::optional<Error> whichPatient(const FoundVolumes& found, const std::filesystem::path& folder);

}  // namespace macula::study
