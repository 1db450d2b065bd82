// macula send ARCHIVE FILES: stores DICOM files in an archive, after a question that names the patients.
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>

#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "dicom/scan.h"
#include "study/archive/archive_json.h"
#include "study/archive/files_to_send.h"
#include "study/open/identity.h"

namespace macula::cli {

namespace {

struct SendOptions : ArchiveOptions {
    std::vector<std::filesystem::path> paths;
    bool yes = false;
};

Result<void> askWhether(const study::FilesToSend& files, const SendOptions& options) {
    for (const study::Identity& patient : files.patients)
        fmt::print(stderr, "{}\n", printable(study::titleOf(patient).english()));
    fmt::print(stderr, "{} to {}.\n",
               files.files.size() == 1 ? "1 file" : fmt::format("{} files", files.files.size()),
               printable(options.archive));
    if (options.yes) return {};
    if (isatty(STDIN_FILENO) == 0)
        return Error{ErrorCode::usage,
                     Text("Nobody is there to confirm that these files go to the archive."),
                     {},
                     Text("Give --yes.")};
    fmt::print(stderr, "Send? [y/N] ");
    std::string answer;
    std::getline(std::cin, answer);
    if (answer == "y" || answer == "Y" || answer == "yes") return {};
    return Error{ErrorCode::cancelled, Text("Nothing was sent."), {}, {}};
}

Result<void> send(const SendOptions& options) {
    MACULA_TRY(const OpenArchive open, openArchive(options));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const study::FilesToSend files, study::filesToSend(options.paths, progress));
    MACULA_TRY_VOID(askWhether(files, options));
    MACULA_TRY(const net::Sent sent, open.archive->send(files.files, progress));
    if (options.json) {
        fmt::print("{}\n", jsonText(study::toJson(sent)));
    } else {
        fmt::print("{} of {} stored.\n", sent.stored, files.files.size());
        for (const net::NotSent& each : sent.notSent)
            printWarning(each.why.english() + " " + each.advice.english() + " (" +
                         printable(each.file.string()) + ")");
    }
    if (sent.notSent.empty()) return {};
    return Error{ErrorCode::archiveNotUsable,
                 Text("{} files were not stored.", sent.notSent.size()),
                 {},
                 Text("The reasons are above.")};
}

}  // namespace

void addSend(CLI::App& app, Action& action) {
    auto options = std::make_shared<SendOptions>();
    auto* command = app.add_subcommand(
        "send", "Store DICOM files in an archive (PACS); asks first, and names the patients");
    addArchive(*command, *options);
    command->add_option("PATHS", options->paths, "Files and folders")->required();
    command->add_flag("--yes", options->yes, "Do not ask");
    command->callback([options, &action] { action = [options] { return send(*options); }; });
}

}  // namespace macula::cli
