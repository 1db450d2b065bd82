// Grayscale Softcopy Presentation States of which everything is known.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthetic.h"

namespace macula::dicom::test {

struct SyntheticSoftcopy {
    std::string sopInstanceUid = "2.25.5000";
    std::string seriesUid = "2.25.5001";
    std::string studyUid = "2.25.1000";  // that of SyntheticSeries, as the three below
    std::string patientName = "SYNTHETIC^ONE";
    std::string patientId = "SYN1";
    std::string referencedSeriesUid = "2.25.1001";
    std::vector<std::string> imageUids;
    std::string frames;  // of each of them, from 1, with backslashes between; empty: all
    std::string label = "LUNG";
    std::string description = "Seen by night";
    std::string date = "20240229";
    std::optional<std::pair<double, double>> rescale = std::pair(1.0, -1024.0);  // as SyntheticSeries has it
    std::optional<std::pair<double, double>> window = std::pair(-600.0, 1500.0);
    int rotationDeg = 0;
    bool isFlipped = false;
    bool isInverse = false;
    std::optional<std::array<int, 4>> area;  // top left column and row, bottom right column and row
    std::string sizeMode = "SCALE TO FIT";   // of the area
    std::vector<Edit> edits;                 // the last word
};

void writeSoftcopy(const std::filesystem::path& file, const SyntheticSoftcopy& softcopy);

}  // namespace macula::dicom::test
