// Segmentation objects of which everything is known: what belongs to a segment is a function of the place in
// the patient.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "synthetic.h"

namespace macula::dicom::test {

struct SyntheticSegmentation {
    struct Part {
        int number = 1;
        std::string label = "Liver";
        std::function<double(const glm::dvec3& worldMm)> share;  // 0 to 1; BINARY: from a half on
        std::optional<std::array<int, 3>> cieLab = {};           // as in the file
    };
    std::string type = "BINARY";  // or FRACTIONAL, of 200 levels
    std::string sopInstanceUid = "2.25.4000";
    std::string seriesUid = "2.25.4001";
    std::string frameOfReferenceUid = "2.25.1002";  // that of SyntheticSeries, as the two below; empty: none
    std::string referencedSeriesUid = "2.25.1001";
    std::string patientId = "SYN1";
    std::string contentLabel = "ORGANS";
    glm::ivec3 size{8, 7, 12};
    glm::dmat4 worldFromVoxel{1.0};  // slices need not be perpendicular to rows and columns
    std::vector<Part> parts;
};

// A frame for each slice in which there is something of a part; all of a part's, part by part.
void writeSegmentation(const std::filesystem::path& file, const SyntheticSegmentation& segmentation);

}  // namespace macula::dicom::test
