// A segment that a recipe makes of an open study, as a file.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "scene/segments/segment_recipe.h"
#include "segment/statistics.h"
#include "study/open/opened_study.h"

namespace macula::scene {

struct RecipeFile {
    std::filesystem::path output;  // .dcm, or what saveSegments writes
    SegmentRecipe recipe;
    std::string label = "Segment 1";
    bool isDeidentified = false;  // of a DICOM file: see SegmentationRequest
};

// The files that writing makes; usage where the ending says no format.
Result<std::vector<std::filesystem::path>> filesOf(const RecipeFile& file);

struct WrittenRecipe {
    segment::Statistics found;
    std::string unit;
    std::vector<Text> notes;  // what was assumed, and what a reader of the file has to know
};
// Errors: those of madeBy, saveSegments and writeSegmentation; usage for a segment without voxels, and for a
// DICOM file of what are no DICOM images. Nothing is written then.
Result<WrittenRecipe> writeRecipe(const RecipeFile& file, const study::OpenedStudy& study,
                                  Progress& progress);
// voxels, ml, unit; mean, deviation, least and most of those with a value.
nlohmann::ordered_json toJson(const WrittenRecipe& written);

}  // namespace macula::scene
