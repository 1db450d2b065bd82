// macula dose PATH: how much dose each region of a treatment plan receives.
#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "pictures/output_files.h"
#include "study/dose/dose_choice.h"
#include "study/dose/dose_table.h"

namespace macula::cli {

namespace {

struct DoseOptions {
    std::filesystem::path path;
    std::string series;
    std::string dose;
    std::filesystem::path json;
    std::filesystem::path csv;
    bool overwrite = false;
    dicom::ScanOptions how;
};

Result<void> showDose(const DoseOptions& options) {
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    MACULA_TRY_VOID(outputs.write(options.json));
    MACULA_TRY_VOID(outputs.write(options.csv));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(options.path, progress, options.how));
    const auto found = std::make_shared<const study::FoundVolumes>(std::move(scan));
    MACULA_TRY(const study::ChosenDose chosen,
               study::chooseDose(*found, options.path, options.series, options.dose));
    MACULA_TRY(const study::DoseReport report, study::reportDose(found, chosen, progress));
    printNotes(report.notes);
    if (!options.csv.empty()) {
        MACULA_TRY_VOID(writeTextAtomically(options.csv, doseCsv(report)));
    }
    if (!options.json.empty()) {
        MACULA_TRY_VOID(printOrWrite(options.json, jsonText(doseJson(report))));
    }
    if (options.json != "-") fmt::print("{}", study::doseLines(report));
    return {};
}

}  // namespace

void addDose(CLI::App& app, Action& action) {
    auto options = std::make_shared<DoseOptions>();
    DoseOptions& o = *options;
    auto* command = app.add_subcommand("dose", "Print how much dose each region of a structure set receives");
    command->add_option("PATH", o.path, "Folder with planning images, structure set and dose")->required();
    command->add_option("--series", o.series,
                        "The images: place in the list of macula info, or series UID (default: the largest "
                        "volume with a dose)");
    command->add_option("--dose", o.dose,
                        "The dose, likewise (default: that of a whole plan, else the first)");
    command->add_option("--json", o.json, "File for all figures as JSON; - for stdout, without the table");
    command->add_option("--csv", o.csv, "File for all figures as a table (CSV)");
    addOverwrite(*command, o.overwrite);
    addJoin(*command, o.how);
    command->callback([options, &action] { action = [options] { return showDose(*options); }; });
}

}  // namespace macula::cli
