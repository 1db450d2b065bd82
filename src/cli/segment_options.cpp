#include "cli/segment_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include "cli/shared/output_options.h"
#include "segment/shape_filters.h"

namespace macula::cli {

namespace {

template <class Value>
void addMm(CLI::App& command, const std::string& name, Value& value, const std::string& help) {
    command.add_option(name, value, help)->check(CLI::Range(0.01, segment::kMostMm))->option_text("MM");
}

void addSteps(CLI::App& command, scene::SegmentRecipe& recipe) {
    command
        .add_option("--tolerance", recipe.tolerance,
                    "Grow over values that are so far from the mean around the point")
        ->check(CLI::NonNegativeNumber);
    command.add_flag("--corners", recipe.overCorners,
                     "Connected over edges and corners of voxels, too (26 neighbours; otherwise 6)");
    command.add_flag("--largest", recipe.largest, "Keep the largest connected part");
    command.add_option("--min-ml", recipe.fewestMl, "Remove connected parts that are smaller")
        ->check(CLI::NonNegativeNumber)
        ->option_text("ML");
    command.add_flag("--fill-holes", recipe.fillsHoles, "Fill what the segment encloses");
    addMm(command, "--median", recipe.medianMm, "Smooth: the majority within so many mm along each axis");
    addMm(command, "--gaussian", recipe.gaussianMm, "Smooth: a Gaussian of that standard deviation");
    addMm(command, "--grow-by", recipe.growMm, "Make it larger on all sides");
    addMm(command, "--shrink-by", recipe.shrinkMm, "Make it smaller on all sides");
}

}  // namespace

scene::RecipeFile SegmentOptions::whole() const {
    scene::RecipeFile whole = file;
    if (!threshold.empty()) whole.recipe.threshold = ValueRange{threshold[0], threshold[1]};
    if (!growFromMm.empty())
        whole.recipe.growFromMm = glm::dvec3(growFromMm[0], growFromMm[1], growFromMm[2]);
    return whole;
}

void addSegmentOptions(CLI::App& command, SegmentOptions& o) {
    command.add_option("PATH", o.path, "Folder with DICOM files, or a volume file")->required();
    command
        .add_option("-o,--output", o.file.output,
                    "File to write: .nii.gz and other volume files (0 and 1), .dcm (a segmentation object), "
                    ".stl or .glb (a closed surface, patient LPS in mm)")
        ->required();
    command.add_option("--threshold", o.threshold, "Voxels with values from LOW to HIGH, in their unit")
        ->expected(2)
        ->option_text("LOW HIGH");
    command.add_option("--grow", o.growFromMm, "Only what is connected with that point, in patient LPS mm")
        ->delimiter(',')
        ->expected(3)
        ->option_text("X,Y,Z");
    addSteps(command, o.file.recipe);
    command.add_option("--label", o.file.label,
                       "Name of the segment in a DICOM file; nothing of the patient");
    command.add_flag("--deidentify", o.file.isDeidentified,
                     "A DICOM file without patient and study, with other UIDs, and without the label");
    command.add_option("--series", o.series,
                       "Place in the list of macula info, or series UID (default: the best)");
    addOverwrite(command, o.overwrite);
    command.add_flag("--json", o.json, "Print size and values of the segment as JSON");
}

}  // namespace macula::cli
