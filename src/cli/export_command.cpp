// macula export PATH -o FILE: a series as one file that other programs read.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/study/segmentation_input.h"
#include "app/study/study_input.h"
#include "base/progress_bar.h"
#include "base/sha256.h"
#include "cli/command.h"
#include "cli/grid_json.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "formats/volume_file.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    fs::path path;
    fs::path output;
    std::string series;
    std::size_t volume = 0;  // from 1; 0: not given
    bool overwrite = false;
    bool json = false;
    dicom::ScanOptions how;
};

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Fails now, not after the series was loaded.
Result<void> checkExport(const Options& options) {
    MACULA_TRY(const auto files, formats::filesOfVolumeFile(options.output));
    OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    for (const fs::path& file : files) MACULA_TRY_VOID(outputs.write(file));
    return {};
}

Result<void> exportSegmentation(const Options& options, const dicom::Scan& scan, const dicom::Series& series,
                                Progress& progress) {
    MACULA_TRY(const app::SegmentationInput input,
               app::loadSegmentation(scan, series, options.volume, progress));
    const LabelMap& map = input.map;
    std::vector<std::string> notes;
    if (!input.onItsSeries) {
        notes.emplace_back(
            input.hasImages ? "It does not lie on the voxels of the images it was drawn on: it is on a grid "
                              "of its own."
                            : "The images it was drawn on are not there: it is on a grid of its own.");
    }
    for (const Message& message : map.messages()) notes.push_back(message.sentence);
    for (const std::string& note : notes) printNote(note);
    MACULA_TRY_VOID(formats::writeVolumeFile(map, options.output, progress));

    nlohmann::ordered_json segments = nlohmann::ordered_json::array();
    for (const Segment& segment : map.segments()) {
        const auto voxels = std::count(map.labels().begin(), map.labels().end(), segment.number);
        segments.push_back({{"number", segment.number}, {"label", segment.label}, {"voxels", voxels}});
    }
    if (!options.json) {
        fmt::print("Wrote {} x {} x {} voxels\n", map.size().x, map.size().y, map.size().z);
        for (const auto& segment : segments) {
            fmt::print("  {:>5}  {} ({} voxels)\n", segment["number"].get<int>(),
                       segment["label"].get<std::string>(), segment["voxels"].get<std::int64_t>());
        }
        return {};
    }
    nlohmann::ordered_json json = {
        {"version", MACULA_VERSION}, {"series", sha256Hex(series.seriesInstanceUid)}, {"segments", segments}};
    json.update(gridToJson(map.size(), map.worldFromVoxel()));
    json["notes"] = notes;
    fmt::print("{}\n", jsonText(json));
    return {};
}

Result<void> exportVolume(const Options& options, const app::StudyInput& study, double loadSeconds,
                          Progress& progress) {
    std::vector<std::string> notes = study.notes;
    const Volume& volume = *study.volume;
    printNotes(study.notes, study.warnings);
    if (isSheared(volume.worldFromVoxel())) {
        notes.emplace_back(
            "The slices are tilted against their axis, and the file says so; some programs do not understand "
            "that, and show the patient askew.");
        printWarning(notes.back());
    }
    const auto start = Clock::now();
    MACULA_TRY_VOID(formats::writeVolumeFile(volume, options.output, progress));
    const double writeSeconds = secondsSince(start);

    MACULA_TRY(const formats::VolumeFileInfo written, formats::readVolumeFileInfo(options.output));
    if (!options.json) {
        fmt::print("Wrote {} x {} x {} voxels, {}, {}\n", written.size.x, written.size.y, written.size.z,
                   written.values, written.format);
        return {};
    }
    nlohmann::ordered_json json = {{"version", MACULA_VERSION},
                                   {"series", study.seriesDigest},
                                   {"format", written.format},
                                   {"values", written.values},
                                   {"unit", volume.unitName()}};
    json.update(gridToJson(written.size, volume.worldFromVoxel()));
    json["sheared"] = isSheared(volume.worldFromVoxel());
    if (const auto& range = volume.valueRange()) json["valueRange"] = {range->low, range->high};
    json["loadSeconds"] = loadSeconds;
    json["writeSeconds"] = writeSeconds;
    json["notes"] = notes;
    fmt::print("{}\n", jsonText(json));
    return {};
}

Result<void> exportSeries(const Options& options) {
    MACULA_TRY_VOID(checkExport(options));
    Progress progress(terminalProgressBar(), interruptToken());
    const auto start = Clock::now();
    if (options.series.empty() || formats::isVolumeFileName(options.path) || options.path == "phantom:") {
        MACULA_TRY(const app::StudyInput study,
                   app::loadStudy(options.path, options.series, progress, options.volume, options.how));
        return exportVolume(options, study, secondsSince(start), progress);
    }
    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(options.path, progress, options.how));
    const dicom::Series* series = findSeries(scan, options.series);
    if (series != nullptr && app::isSegmentationSeries(*series)) {
        if (dicom::findAllSeries(scan, options.series).empty() &&
            options.series.find('.') != std::string::npos) {
            return Error{ErrorCode::usage, "The series holds segmentations, and has no stacks.",
                         options.series, "Give its place alone, and which segmentation with --volume."};
        }
        return exportSegmentation(options, scan, *series, progress);
    }
    MACULA_TRY(const app::StudyInput study,
               app::loadStudy(scan, options.path, options.series, progress, options.volume));
    return exportVolume(options, study, secondsSince(start), progress);
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = app.add_subcommand(
        "export", "Write a series, of images or of segmentations, to a NIfTI, NRRD or MetaImage file");
    command->add_option("PATH", o.path, "Folder with DICOM files, or a volume file to convert")->required();
    command
        ->add_option(
            "-o,--output", o.output,
            "File to write: .nii, .nii.gz, .nrrd, .nhdr, .mha or .mhd; values in units, patient left out")
        ->required();
    command->add_option("--series", o.series,
                        "Place in the list of macula info (3, or 3.2), or series UID (default: the best)");
    command
        ->add_option("--volume", o.volume,
                     "Which volume or segmentation of that series, from 1 (default: its best volume)")
        ->check(CLI::Range(1, 1000000));
    addOverwrite(*command, o.overwrite);
    addJoin(*command, o.how);
    command->add_flag("--json", o.json, "Print what was written as JSON");
    command->callback([options, &action] { action = [options] { return exportSeries(*options); }; });
}

}  // namespace macula::cli
