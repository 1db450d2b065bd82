// macula export PATH -o FILE: a series as one file that other programs read.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/grid_json.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/study_input.h"
#include "dicom/volume_file.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    fs::path path;
    fs::path output;
    std::string series;
    std::size_t volume = 0;  // from 1; 0: not given
    bool force = false;
    bool json = false;
};

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Fails now, not after the series was loaded.
Result<void> checkExport(const Options& options) {
    MACULA_TRY(const auto files, dicom::filesOfVolumeFile(options.output));
    MACULA_TRY_VOID(checkFolderOf(options.output));
    for (const fs::path& file : files) {
        std::error_code error;
        const auto status = fs::symlink_status(file, error);
        if (fs::is_directory(status)) {
            return Error{ErrorCode::outputNotWritable, "There is a folder of that name.", file.string(),
                         "Choose another name."};
        }
        if (fs::exists(status) && !options.force) {
            return Error{ErrorCode::outputNotWritable, "The file exists already.", file.string(),
                         "Give --force to replace it, or choose another name."};
        }
    }
    return {};
}

Result<void> exportVolume(const Options& options) {
    MACULA_TRY_VOID(checkExport(options));
    Progress progress(terminalProgressBar(), interruptToken());
    auto start = Clock::now();
    MACULA_TRY(StudyInput study, loadStudy(options.path, options.series, progress, options.volume));
    const double loadSeconds = secondsSince(start);
    const Volume& volume = *study.volume;
    if (isSheared(volume.worldFromVoxel())) {
        study.notes.emplace_back(
            "The slices are tilted against their axis, and the file says so; some programs do not understand "
            "that, and show the patient askew.");
    }
    for (const std::string& note : study.notes) printNote(note);
    start = Clock::now();
    MACULA_TRY_VOID(dicom::writeVolumeFile(volume, options.output, progress));
    const double writeSeconds = secondsSince(start);

    MACULA_TRY(const dicom::VolumeFileInfo written, dicom::readVolumeFileInfo(options.output));
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
    json["notes"] = study.notes;
    fmt::print("{}\n", json.dump(4));
    return {};
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = app.add_subcommand("export", "Write a series to a NIfTI, NRRD or MetaImage file");
    command->add_option("PATH", o.path, "Folder with DICOM files, or a volume file to convert")->required();
    command
        ->add_option(
            "-o,--output", o.output,
            "File to write: .nii, .nii.gz, .nrrd, .nhdr, .mha or .mhd; values in units, patient left out")
        ->required();
    command->add_option("--series", o.series,
                        "Place in the list of macula info (3, or 3.2), or series UID (default: the best)");
    command->add_option("--volume", o.volume, "Which volume of that series, from 1 (default: its best)")
        ->check(CLI::Range(1, 1000000));
    command->add_flag("--force", o.force, "Replace a file that exists");
    command->add_flag("--json", o.json, "Print what was written as JSON");
    command->callback([options, &action] { action = [options] { return exportVolume(*options); }; });
}

}  // namespace macula::cli
