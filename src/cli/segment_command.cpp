// macula segment PATH -o FILE: one segment of a volume, by its values, as a file for other programs.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "formats/volume_file.h"
#include "pictures/output_files.h"
#include "scene/segments/own_segments.h"
#include "scene/segments/segment_recipe.h"
#include "scene/segments/segmentation_file.h"
#include "scene/segments/segments_to_file.h"
#include "segment/shape_filters.h"
#include "segment/statistics.h"
#include "segment/surface_file.h"
#include "study/open/opened_study.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;

struct SegmentOptions {
    fs::path path;
    fs::path output;
    std::string series;
    std::string label = "Segment 1";
    std::vector<double> threshold;
    std::vector<double> growFromMm;
    scene::SegmentRecipe recipe;
    bool isDeidentified = false;
    bool overwrite = false;
    bool json = false;
};

bool isDicomName(const fs::path& path) {
    return path.extension() == ".dcm" || path.extension() == ".DCM";
}

Result<void> checkOutput(const SegmentOptions& options) {
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    if (isDicomName(options.output) || segment::surfaceFormatOf(options.output))
        return outputs.write(options.output);
    if (!formats::isVolumeFileName(options.output))
        return Error{ErrorCode::usage, Text("The ending of the file says no format."),
                     options.output.string(),
                     Text("Choose .nii.gz or another volume file, .dcm, .stl or .glb.")};
    MACULA_TRY(const auto files, formats::filesOfVolumeFile(options.output));
    for (const fs::path& file : files) MACULA_TRY_VOID(outputs.write(file));
    return {};
}

Result<std::vector<Text>> write(const SegmentOptions& options, const study::OpenedStudy& study,
                                scene::OwnSegment own, Progress& progress) {
    if (!isDicomName(options.output)) {
        const auto rgb = study::usualRgb(own.segment);
        return scene::saveSegments(
            options.output,
            {.segments = {own}, .surfaceOf = own.voxels, .rgb = rgb, .volume = study.measured()}, progress);
    }
    if (!study.found)
        return Error{ErrorCode::usage,
                     Text("A DICOM segmentation refers to DICOM images, and these are none."),
                     {},
                     Text("Write a .nii.gz file.")};
    own.segment.recommendedRgb = study::usualRgb(own.segment);
    scene::SegmentationRequest request{.parts = {},
                                       .volume = study.volume,
                                       .found = study.found,
                                       .volumeIndex = study.volumeIndex,
                                       .isDeidentified = options.isDeidentified};
    request.parts.push_back({scene::ownRevision({std::move(own)}, *study.volume), {}, {1}});
    return scene::writeSegmentation(options.output, request);
}

void print(const SegmentOptions& options, const segment::Statistics& found, const std::string& unit) {
    if (options.json) {
        nlohmann::ordered_json json{{"voxels", found.voxels}, {"ml", found.ml}, {"unit", unit}};
        if (found.values)
            json.update({{"mean", found.values->mean},
                         {"deviation", found.values->deviation},
                         {"least", found.values->least},
                         {"most", found.values->most}});
        fmt::print("{}\n", jsonText(json));
        return;
    }
    fmt::print("{}: {} voxels, {:.3f} ml\n", options.label, found.voxels, found.ml);
    if (found.values)
        fmt::print("  mean {:.2f}, SD {:.2f}, from {:.2f} to {:.2f} {}\n", found.values->mean,
                   found.values->deviation, found.values->least, found.values->most, unit);
}

Result<void> makeSegment(const SegmentOptions& options) {
    MACULA_TRY_VOID(checkOutput(options));
    Progress progress(terminalProgressBar(), interruptToken());
    const study::StudySource source =
        options.path == "phantom:" ? study::StudySource() : study::StudySource(options.path);
    MACULA_TRY(const study::OpenedStudy study,
               study::openStudy(source, progress, {.series = options.series, .asksWhichPatient = true}));
    if (!study.volume)
        return Error{
            ErrorCode::inputNotUsable, study.joinQuestion, {}, Text("Choose a series with --series.")};
    scene::SegmentRecipe recipe = options.recipe;
    if (!options.threshold.empty()) recipe.threshold = ValueRange{options.threshold[0], options.threshold[1]};
    if (!options.growFromMm.empty())
        recipe.growFromMm = glm::dvec3(options.growFromMm[0], options.growFromMm[1], options.growFromMm[2]);
    const Volume& volume = *study.measured();
    MACULA_TRY(VoxelSet voxels, scene::madeBy(recipe, volume, progress));
    if (voxels.isEmpty())
        return Error{ErrorCode::usage,
                     Text("The segment has no voxel; nothing was written."),
                     {},
                     Text("Choose other values, or leave steps out.")};
    scene::OwnSegment own;
    own.segment.number = 1;
    own.segment.label = options.label;
    own.segment.algorithm = "SEMIAUTOMATIC";
    own.segment.algorithmName = "Macula";
    own.voxels = std::make_shared<const VoxelSet>(std::move(voxels));
    MACULA_TRY(const segment::Statistics found, segment::statisticsOf(*own.voxels, volume, progress));
    MACULA_TRY(const std::vector<Text> notes, write(options, study, std::move(own), progress));
    printNotes(volume.provenance().assumptions);
    printNotes(notes);
    print(options, found, volume.unitName());
    return {};
}

template <class Value>
void addMm(CLI::App& command, const std::string& name, Value& value, const std::string& help) {
    command.add_option(name, value, help)->check(CLI::Range(0.01, segment::kMostMm))->option_text("MM");
}

}  // namespace

void addSegment(CLI::App& app, Action& action) {
    auto options = std::make_shared<SegmentOptions>();
    SegmentOptions& o = *options;
    auto* command = app.add_subcommand(
        "segment", "Make a segment of a volume by its values, and write it as a label map, DICOM or surface");
    command->add_option("PATH", o.path, "Folder with DICOM files, or a volume file")->required();
    command
        ->add_option("-o,--output", o.output,
                     "File to write: .nii.gz and other volume files (0 and 1), .dcm (a segmentation object), "
                     ".stl or .glb (a closed surface, patient LPS in mm)")
        ->required();
    command->add_option("--threshold", o.threshold, "Voxels with values from LOW to HIGH, in their unit")
        ->expected(2)
        ->option_text("LOW HIGH");
    command->add_option("--grow", o.growFromMm, "Only what is connected with that point, in patient LPS mm")
        ->delimiter(',')
        ->expected(3)
        ->option_text("X,Y,Z");
    command
        ->add_option("--tolerance", o.recipe.tolerance,
                     "Grow over values that are so far from the mean around the point")
        ->check(CLI::NonNegativeNumber);
    command->add_flag("--corners", o.recipe.overCorners,
                      "Connected over edges and corners of voxels, too (26 neighbours; otherwise 6)");
    command->add_flag("--largest", o.recipe.largest, "Keep the largest connected part");
    command->add_option("--min-ml", o.recipe.fewestMl, "Remove connected parts that are smaller")
        ->check(CLI::NonNegativeNumber)
        ->option_text("ML");
    command->add_flag("--fill-holes", o.recipe.fillsHoles, "Fill what the segment encloses");
    addMm(*command, "--median", o.recipe.medianMm, "Smooth: the majority within so many mm along each axis");
    addMm(*command, "--gaussian", o.recipe.gaussianMm, "Smooth: a Gaussian of that standard deviation");
    addMm(*command, "--grow-by", o.recipe.growMm, "Make it larger on all sides");
    addMm(*command, "--shrink-by", o.recipe.shrinkMm, "Make it smaller on all sides");
    command->add_option("--label", o.label, "Name of the segment in a DICOM file; nothing of the patient");
    command->add_flag("--deidentify", o.isDeidentified,
                      "A DICOM file without patient and study, with other UIDs, and without the label");
    command->add_option("--series", o.series,
                        "Place in the list of macula info, or series UID (default: the best)");
    addOverwrite(*command, o.overwrite);
    command->add_flag("--json", o.json, "Print size and values of the segment as JSON");
    command->callback([options, &action] { action = [options] { return makeSegment(*options); }; });
}

}  // namespace macula::cli
