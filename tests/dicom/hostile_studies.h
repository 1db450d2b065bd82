// Studies that a reader may take for what they are not: written as files, each with the volumes that are in
// it and what has to be said. docs/dicom.md lists them all; make_hostile_studies writes them for other
// programs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "synthetic.h"

namespace macula::dicom::test {

struct HostileStudy {
    std::string_view name;   // of its folder
    std::string_view about;  // for the documentation
    std::string_view shown;
    std::vector<std::string_view> said;  // keys of messages; all of them are warnings or worse
    std::size_t volumes = 1;
    // Writes the files, and returns what a reader must come to: a volume each, in any order, voxel by voxel.
    // Fewer than `volumes` where a volume is none that anybody took.
    std::function<std::vector<SyntheticSeries>(const std::filesystem::path& folder)> write;
};

const std::vector<HostileStudy>& hostileStudies();
// Those of them that are several acquisitions or phases.
std::vector<HostileStudy> hostileAcquisitions();

}  // namespace macula::dicom::test
