// A volume or segmentations as one file that other programs read, and what there is to say of it.
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
#include "study/export/segmentation_input.h"
#include "study/open/study_input.h"

namespace macula::app {

struct ExportedVolume {
    formats::VolumeFileInfo file;  // as it is read again
    std::string seriesDigest;
    std::string unit;
    std::optional<ValueRange> valueRange;
    glm::dmat4 worldFromVoxel{1.0};  // patient LPS mm
    double writeSeconds = 0.0;
    std::vector<std::string> notes;  // of the study
};

// Adds to the notes and warnings of the study what other programs may show otherwise.
void noteWhatOthersMisread(StudyInput& study);

// Fails as formats::writeVolumeFile.
Result<ExportedVolume> exportVolume(const StudyInput& study, const std::filesystem::path& file,
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
    std::vector<std::string> notes;
};

// Sentences about the grid that the segmentation is on, and those of its map; without patient data.
std::vector<std::string> notesOf(const SegmentationInput& input);

// `seriesUid` is only told as a digest. Fails as formats::writeVolumeFile.
Result<ExportedSegmentation> exportSegmentation(const SegmentationInput& input, const std::string& seriesUid,
                                                const std::filesystem::path& file, Progress& progress);
nlohmann::ordered_json toJson(const ExportedSegmentation& exported);

}  // namespace macula::app
