// macula export PATH -o FILE: a series as one file that other programs read.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/elapsed.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/presentation_export.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "formats/volume_file.h"
#include "pictures/output_files.h"
#include "study/export/volume_export.h"
#include "study/open/loaded_study.h"
#include "study/open/scanned_place.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    fs::path path;
    fs::path output;
    PresentationExportRequest presentation;
    std::string series;
    std::size_t volume = 0;  // from 1; 0: not given
    bool overwrite = false;
    bool json = false;
    dicom::ScanOptions how;
};

// Fails now, not after the series was loaded.
Result<void> checkExport(const ExportOptions& options) {
    MACULA_TRY(const auto files, formats::filesOfVolumeFile(options.output));
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    for (const fs::path& file : files) MACULA_TRY_VOID(outputs.write(file));
    return {};
}

Result<void> exportSegmentation(const ExportOptions& options, const dicom::Scan& scan,
                                const dicom::Series& series, Progress& progress) {
    MACULA_TRY(const study::SegmentationOnGrid input,
               study::loadSegmentation(scan, series, options.volume, progress));
    printNotes(notesOf(input));
    MACULA_TRY(const study::ExportedSegmentation exported,
               study::exportSegmentation(input, series.seriesInstanceUid, options.output, progress));
    if (options.json) {
        fmt::print("{}\n", jsonText(toJson(exported)));
        return {};
    }
    fmt::print("Wrote {} x {} x {} voxels\n", exported.size.x, exported.size.y, exported.size.z);
    for (const study::ExportedSegment& segment : exported.segments)
        fmt::print("  {:>5}  {} ({} voxels)\n", segment.number, segment.label, segment.voxels);
    return {};
}

Result<void> exportVolume(const ExportOptions& options, study::LoadedStudy study, double loadSeconds,
                          Progress& progress) {
    noteWhatOthersMisread(study);
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const study::ExportedVolume exported, study::exportVolume(study, options.output, progress));
    if (options.json) {
        fmt::print("{}\n", jsonText(toJson(exported, loadSeconds)));
        return {};
    }
    const formats::VolumeFileInfo& file = exported.file;
    fmt::print("Wrote {} x {} x {} voxels, {}, {}\n", file.size.x, file.size.y, file.size.z, file.values,
               file.format);
    return {};
}

Result<void> exportSeries(const ExportOptions& options) {
    if (!options.presentation.output.empty())
        return exportPresentation(options.presentation, {.path = options.path,
                                                         .series = options.series,
                                                         .volume = options.volume,
                                                         .how = options.how,
                                                         .overwrite = options.overwrite});
    if (options.output.empty())
        return Error{ErrorCode::usage,
                     Text("--output is required."),
                     {},
                     Text("Give -o FILE for the values, or --presentation-state FILE for a 3D view.")};
    MACULA_TRY_VOID(checkExport(options));
    Progress progress(terminalProgressBar(), interruptToken());
    const auto start = std::chrono::steady_clock::now();
    if (options.series.empty() || formats::isVolumeFileName(options.path) || options.path == "phantom:") {
        MACULA_TRY(study::LoadedStudy study,
                   study::loadStudy(options.path, options.series, progress, options.volume, options.how,
                                    study::PetUnit::asInImages));
        return exportVolume(options, std::move(study), secondsSince(start), progress);
    }
    MACULA_TRY(const study::ScannedPlace place, study::scanPlace(options.path, progress, options.how));
    const dicom::Series* series = study::seriesMeant(place.scan, options.series);
    if (series != nullptr && study::isSegmentationSeries(*series)) {
        if (dicom::findAllSeries(place.scan, options.series).empty() &&
            options.series.find('.') != std::string::npos) {
            return Error{ErrorCode::usage, Text("The series holds segmentations, and has no stacks."),
                         options.series, Text("Give its place alone, and which segmentation with --volume.")};
        }
        return exportSegmentation(options, place.scan, *series, progress);
    }
    MACULA_TRY(study::LoadedStudy study, study::loadStudy(place.scan, options.path, options.series, progress,
                                                          options.volume, study::PetUnit::asInImages));
    return exportVolume(options, std::move(study), secondsSince(start), progress);
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
    auto options = std::make_shared<ExportOptions>();
    ExportOptions& o = *options;
    auto* command = app.add_subcommand(
        "export", "Write a series, of images or of segmentations, to a NIfTI, NRRD or MetaImage file");
    command->add_option("PATH", o.path, "Folder, ZIP, tar or ISO of DICOM files, or a volume file")
        ->required();
    auto* output = command->add_option(
        "-o,--output", o.output,
        "File to write: " + formats::volumeFileEndings() + "; values in units, patient left out");
    command->add_option("--series", o.series,
                        "Place in the list of macula info (3, or 3.2), or series UID (default: the best)");
    command
        ->add_option("--volume", o.volume,
                     "Which volume or segmentation of that series, or point in time of a volume file, from 1 "
                     "(default: the best volume, the first point)")
        ->check(CLI::Range(1, 1000000));
    addOverwrite(*command, o.overwrite);
    addJoin(*command, o.how);
    auto* json = command->add_flag("--json", o.json, "Print what was written as JSON");
    addPresentation(*command, o.presentation)->excludes(output)->excludes(json);
    command->callback([options, &action] { action = [options] { return exportSeries(*options); }; });
}

}  // namespace macula::cli
