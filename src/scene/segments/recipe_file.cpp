#include "scene/segments/recipe_file.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "formats/volume_file.h"
#include "scene/segments/own_segments.h"
#include "scene/segments/segmentation_file.h"
#include "scene/segments/segments_to_file.h"
#include "segment/surface_file.h"

namespace macula::scene {

namespace fs = std::filesystem;

namespace {

bool isDicomName(const fs::path& path) {
    return path.extension() == ".dcm" || path.extension() == ".DCM";
}

Result<std::vector<Text>> write(const RecipeFile& file, const study::OpenedStudy& study, OwnSegment own,
                                Progress& progress) {
    const auto rgb = study::usualRgb(own.segment);
    if (!isDicomName(file.output))
        return saveSegments(
            file.output, {.segments = {own}, .surfaceOf = own.voxels, .rgb = rgb, .volume = study.measured()},
            progress);
    if (!study.found)
        return Error{ErrorCode::usage,
                     Text("A DICOM segmentation refers to DICOM images, and these are none."),
                     {},
                     Text("Write a .nii.gz file.")};
    own.segment.recommendedRgb = rgb;
    SegmentationRequest request{.parts = {},
                                .volume = study.volume,
                                .found = study.found,
                                .volumeIndex = study.volumeIndex,
                                .isDeidentified = file.isDeidentified};
    request.parts.push_back({ownRevision({std::move(own)}, *study.volume), {}, {1}});
    return writeSegmentation(file.output, request);
}

}  // namespace

Result<std::vector<fs::path>> filesOf(const RecipeFile& file) {
    if (isDicomName(file.output) || segment::surfaceFormatOf(file.output))
        return std::vector<fs::path>{file.output};
    if (!formats::isVolumeFileName(file.output))
        return Error{ErrorCode::usage, Text("The ending of the file says no format."), file.output.string(),
                     Text("Choose .nii.gz or another volume file, .dcm, .stl or .glb.")};
    return formats::filesOfVolumeFile(file.output);
}

Result<WrittenRecipe> writeRecipe(const RecipeFile& file, const study::OpenedStudy& study,
                                  Progress& progress) {
    const Volume& volume = *study.measured();
    MACULA_TRY(VoxelSet voxels, madeBy(file.recipe, volume, progress));
    if (voxels.isEmpty())
        return Error{ErrorCode::usage,
                     Text("The segment has no voxel; nothing was written."),
                     {},
                     Text("Choose other values, or leave steps out.")};
    OwnSegment own;
    own.segment.number = 1;
    own.segment.label = file.label;
    own.segment.algorithm = "SEMIAUTOMATIC";
    own.segment.algorithmName = "Macula";
    own.voxels = std::make_shared<const VoxelSet>(std::move(voxels));
    WrittenRecipe written;
    written.unit = volume.unitName();
    written.notes = volume.provenance().assumptions;
    MACULA_TRY(written.found, segment::statisticsOf(*own.voxels, volume, progress));
    MACULA_TRY(const std::vector<Text> notes, write(file, study, std::move(own), progress));
    written.notes.insert(written.notes.end(), notes.begin(), notes.end());
    return written;
}

nlohmann::ordered_json toJson(const WrittenRecipe& written) {
    nlohmann::ordered_json json{
        {"voxels", written.found.voxels}, {"ml", written.found.ml}, {"unit", written.unit}};
    if (const auto& values = written.found.values) {
        json["mean"] = values->mean;
        json["deviation"] = values->deviation;
        json["least"] = values->least;
        json["most"] = values->most;
    }
    return json;
}

}  // namespace macula::scene
