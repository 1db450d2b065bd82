// macula dose PATH: the dose-volume figures of each region of a treatment plan.
//
// Output names regions as the files do, and no patient.
#include <CLI/App.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "pictures/output_files.h"
#include "study/dose/dose_report.h"
#include "study/dose/dose_table.h"
#include "study/dose/found_dose.h"
#include "study/open/opened_study.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;

constexpr double kPercent = 100.0;

struct DoseOptions {
    fs::path path;
    std::string series;
    std::string dose;
    fs::path json;
    fs::path csv;
    bool overwrite = false;
    dicom::ScanOptions how;
};

// Fails now, not after the folder was read.
Result<void> checkOutputs(const DoseOptions& options) {
    if (options.json == "-" && options.csv == "-")
        return Error{ErrorCode::usage,
                     Text("Both JSON and the table are for standard output."),
                     {},
                     Text("Give a file for one of them.")};
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    MACULA_TRY_VOID(outputs.write(options.json));
    return outputs.write(options.csv);
}

Error noDose(const fs::path& folder) {
    return {ErrorCode::inputNotUsable, Text("The folder has no dose (RTDOSE) that can be read as a volume."),
            folder.string(), Text("Put the dose of the plan into the folder.")};
}

struct Chosen {
    std::size_t on = 0;
    std::size_t dose = 0;
};

// The volume that is named, else the largest that has a dose. Where there is only the dose, its own grid.
Result<Chosen> choose(const DoseOptions& options, const study::FoundVolumes& found) {
    std::optional<std::size_t> on;
    if (!options.series.empty()) {
        MACULA_TRY(const auto meant, found.ofSeries(options.series, options.path));
        on = meant.index;
    }
    std::vector<std::size_t> doses;
    for (std::size_t i = 0; i < found.volumes().size(); ++i)
        if (found.volumes()[i].series->modality == "RTDOSE") doses.push_back(i);
    if (doses.empty()) return noDose(options.path);
    if (!on) {
        double most = 0.0;
        for (std::size_t i = 0; i < found.volumes().size(); ++i) {
            if (study::dosesOn(found, i).empty()) continue;
            const dicom::Stack& stack = *found.volumes()[i].stack;
            const double voxels = double(stack.columns) * stack.rows * double(stack.frames.size());
            if (voxels <= most) continue;
            most = voxels;
            on = i;
        }
    }
    if (!options.dose.empty()) {
        MACULA_TRY(const auto meant, found.ofSeries(options.dose, options.path));
        if (found.volumes()[meant.index].series->modality != "RTDOSE")
            return Error{ErrorCode::usage, Text("The series is no dose."), options.dose,
                         Text("Choose one of the modality RTDOSE in the list of macula info.")};
        return Chosen{on.value_or(meant.index), meant.index};
    }
    if (!on) return Chosen{doses.front(), doses.front()};
    const std::vector<study::FoundDose> onVolume = study::dosesOn(found, *on);
    if (onVolume.empty())
        return Error{ErrorCode::inputNotUsable,
                     Text("No dose of the folder lies in the coordinate system (frame of reference) of the "
                          "volume."),
                     options.path.string(), Text("Choose the images that the treatment was planned on.")};
    if (onVolume.size() > 1)
        printNote(Text("{} doses lie on the volume. The figures are of one of them; --dose chooses another.",
                       onVolume.size()));
    return Chosen{*on, onVolume.front().volume};
}

std::string number(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string share(const std::optional<double>& value) {
    return value ? number(*value * kPercent, 1) : "-";
}

void print(const study::DoseReport& report) {
    std::size_t width = 6;
    for (const study::RegionInDose& region : report.regions)
        width = std::max(width, std::min<std::size_t>(printable(region.label).size(), 40));
    fmt::print("{:<{}}  {:>8}  {:>8}  {:>7}  {:>7}  {:>7}  {:>7}  {:>7}  {:>7}  {:>7}", "region", width, "mL",
               "outside", "min", "mean", "max", "D98", "D95", "D50", "D2");
    fmt::print("  {:>6}  {:>6}  {:>6}\n", "V20Gy", "V95%", "V100%");
    for (const study::RegionInDose& region : report.regions) {
        const study::DoseFigures f = figuresOf(region, report);
        fmt::print("{:<{}}  {:>8}  {:>7}%", printable(region.label), width,
                   number(region.volumeMl.value_or(std::nan("")), 2),
                   number(region.dose.outsideShare() * kPercent, 1));
        for (const double value : {f.minimum, f.mean, f.maximum, f.d98, f.d95, f.d50, f.d2})
            fmt::print("  {:>7}", number(value, 2));
        fmt::print("  {:>6}  {:>6}  {:>6}\n", share(f.v20Gy), share(f.v95), share(f.v100));
    }
    fmt::print("Doses in {}, V in percent of the region inside the dose.", report.unit);
    if (report.reference)
        fmt::print(" V95% and V100% are of {:.4g} {} ({}).", report.reference->value, report.unit,
                   nameOf(report.reference->of));
    fmt::print("\n");
}

Result<void> showDose(const DoseOptions& options) {
    MACULA_TRY_VOID(checkOutputs(options));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(options.path, progress, options.how));
    const auto found = std::make_shared<const study::FoundVolumes>(std::move(scan));
    MACULA_TRY(const Chosen chosen, choose(options, *found));
    MACULA_TRY(const study::OpenedStudy dose, study::openFoundVolume(found, chosen.dose, progress));
    study::OpenedStudy on = dose;
    if (chosen.on != chosen.dose) {
        MACULA_TRY(on, study::openFoundVolume(found, chosen.on, progress));
    } else {
        printNote(Text("No images lie in the coordinate system of the dose: regions are drawn on its grid."));
    }
    MACULA_TRY(const study::DoseReport report, study::reportDose({.found = *found,
                                                                  .on = chosen.on,
                                                                  .grid = *on.volume,
                                                                  .dose = chosen.dose,
                                                                  .values = dose.measured()},
                                                                 progress));
    if (dose.dose) printNote(study::doseText(*dose.dose));
    printNotes(report.notes);
    if (!options.json.empty()) {
        MACULA_TRY_VOID(printOrWrite(options.json, jsonText(doseJson(report))));
    }
    if (options.csv == "-") {
        fmt::print("{}", doseCsv(report));
    } else if (!options.csv.empty()) {
        MACULA_TRY_VOID(writeTextAtomically(options.csv, doseCsv(report)));
    }
    if (options.json != "-" && options.csv != "-") print(report);
    return {};
}

}  // namespace

void addDose(CLI::App& app, Action& action) {
    auto options = std::make_shared<DoseOptions>();
    DoseOptions& o = *options;
    auto* command = app.add_subcommand(
        "dose", "Print how much dose each region of a structure set receives (dose-volume figures)");
    command->add_option("PATH", o.path, "Folder with the planning images, structure set and dose")
        ->required();
    command->add_option("--series", o.series,
                        "The images: place in the list of macula info, or series UID (default: the largest "
                        "volume with a dose)");
    command->add_option("--dose", o.dose,
                        "The dose, likewise (default: that of a whole plan, else the first)");
    command->add_option("--json", o.json, "File for all figures as JSON; - for stdout, without the table");
    command->add_option("--csv", o.csv, "File for all figures as a table (CSV); - for stdout");
    addOverwrite(*command, o.overwrite);
    addJoin(*command, o.how);
    command->callback([options, &action] { action = [options] { return showDose(*options); }; });
}

}  // namespace macula::cli
