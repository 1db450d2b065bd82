// What is asked where a folder is of several patients, and nobody said which is meant.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"
#include "study/open/found_volumes.h"

namespace macula::app {

// inputNotUsable with the choice: the series of each patient, by the numbers that `macula info` has too and
// FoundVolumes::ofSeries takes. Patients have numbers, and no names. Nothing where all volumes are of one.
std::optional<Error> whichPatient(const FoundVolumes& found, const std::filesystem::path& folder);

}  // namespace macula::app
