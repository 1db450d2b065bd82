// Exports a volume or a segmentation for other programs, and reports on the export.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "formats/volume_file.h"
#include "study/export/segmentation_on_grid.h"
#include "study/open/loaded_study.h"

namespace macula::study {

struct ExportedVolume {
    formats::VolumeFileInfo file;  // read back from the written file
    std::string seriesDigest;
    std::string unit;
    std::optional<ValueRange> valueRange;
    glm::dmat4 worldFromVoxel{1.0};  // patient LPS mm
    double writeSeconds = 0.0;
    std::vector<Text> notes;  // the notes of the study
};

// Adds to notes and warnings that other programs may show a sheared volume (isSheared) skewed.
void noteWhatOthersMisread(LoadedStudy& study);

// Fails as formats::writeVolumeFile.
Result<ExportedVolume> exportVolume(const LoadedStudy& study, const std::filesystem::path& file,
                                    Progress& progress);
nlohmann::ordered_json toJson(const ExportedVolume& exported, double loadSeconds);

struct ExportedSegment {
    int number = 0;
    std::string label;
    std::int64_t voxels = 0;
};
struct ExportedSegmentation {
    std::string seriesDigest;
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};  // patient LPS mm
    std::vector<ExportedSegment> segments;
    std::vector<Text> notes;
};

// Sentences without patient data: whether the map is on a grid of its own, and the messages of the map.
std::vector<Text> notesOf(const SegmentationOnGrid& input);

// Reports `seriesUid` only as a digest. Fails as formats::writeVolumeFile.
Result<ExportedSegmentation> exportSegmentation(const SegmentationOnGrid& input, const std::string& seriesUid,
                                                const std::filesystem::path& file, Progress& progress);
nlohmann::ordered_json toJson(const ExportedSegmentation& exported);

}  // namespace macula::study
