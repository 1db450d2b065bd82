// Which dose of a folder, and the regions of which volume: for programs without a window.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "study/dose/dose_report.h"

namespace macula::study {

struct ChosenDose {
    std::size_t on = 0;    // the volume, in FoundVolumes::volumes(); the dose itself if it lies on no other
    std::size_t dose = 0;  // likewise
    std::vector<Text> notes = {};  // sentences, without patient data
};

// `series` and `dose` as FoundVolumes::ofSeries; empty: the largest volume with a dose, and its dose of a
// whole plan, else the first. Fails with inputNotUsable where there is none, and usage if `dose` is no dose.
Result<ChosenDose> chooseDose(const FoundVolumes& found, const std::filesystem::path& folder,
                              const std::string& series, const std::string& dose);

// Reads both volumes, and reports; the notes of the choice come first.
Result<DoseReport> reportDose(const std::shared_ptr<const FoundVolumes>& found, const ChosenDose& chosen,
                              Progress& progress);

}  // namespace macula::study
