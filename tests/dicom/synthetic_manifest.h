// Imaging manifests of which everything is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synthetic.h"

namespace macula::dicom::test {

struct SyntheticManifest {
    struct Series {
        std::string studyUid = "2.25.1000";  // that of SyntheticSeries, as the next
        std::string seriesUid = "2.25.1001";
        std::vector<std::string> instanceUids;
        std::string url;       // Retrieve URL of the series; empty: none
        std::string wadoUrl;   // in WADO-RS Retrieval Sequence, as MADO has it
        std::string aeTitle;   // Retrieve AE Title
        std::string location;  // Retrieve Location UID
    };

    std::string code = "113030";
    std::string scheme = "DCM";
    std::string patientName = "SYNTHETIC^ONE";
    std::string patientId = "SYN1";
    std::vector<Series> series;
    std::vector<Edit> edits;  // the last word
};

void writeManifest(const std::filesystem::path& file, const SyntheticManifest& manifest);

// One that names all of these images.
SyntheticManifest manifestOf(const SyntheticSeries& series);

}  // namespace macula::dicom::test
