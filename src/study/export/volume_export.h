// Exports a volume or a segmentation for other programs, and reports on the export.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "formats/volume_file.h"
#include "study/open/loaded_study.h"

namespace macula::study {

// Whether the series holds segmentations, and no images.
bool isSegmentationSeries(const dicom::Series& series);

// A DICOM segmentation as a label map.
struct SegmentationOnGrid {
    LabelMap map;
    bool onItsSeries = false;  // on the grid of the series it was drawn on; otherwise on its own grid
    bool hasImages = false;    // the scan has a volume of that series
};

// Loads segmentation `number` of the series, from 1; 0: the only one. Uses the grid of the images it was
// drawn on if the scan has these as a volume and the segmentation fits. usage for a wrong `number`.
Result<SegmentationOnGrid> loadSegmentation(const dicom::Scan& scan, const dicom::Series& series,
                                            std::size_t number, Progress& progress);

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
