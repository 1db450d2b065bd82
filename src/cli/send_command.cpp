// macula send ARCHIVE FILES: stores DICOM files in an archive, after a question that names the patients. What
// was not stored waits in the queue.
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <set>

#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "dicom/scan.h"
#include "net/sources/source_address.h"
#include "study/archive/archive_json.h"
#include "study/archive/files_to_send.h"
#include "study/open/identity.h"
#include "study/outbox/outbox.h"
#include "study/outbox/sending.h"

namespace macula::cli {

namespace {

struct SendOptions : ArchiveOptions {
    std::vector<std::filesystem::path> paths;
    bool yes = false;
    bool commit = false;
    int commitSeconds = 60;
    bool noQueue = false;
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

std::vector<std::filesystem::path> storedOf(const study::FilesToSend& files, const study::FilesSent& sent) {
    std::set<std::filesystem::path> notStored(sent.left.begin(), sent.left.end());
    for (const net::NotSent& each : sent.refused) notStored.insert(each.file);
    std::vector<std::filesystem::path> stored;
    for (const std::filesystem::path& file : files.files)
        if (!notStored.contains(file)) stored.push_back(file);
    return stored;
}

std::size_t committedOf(const std::vector<net::Commitment>& commitments) {
    return static_cast<std::size_t>(std::count_if(
        commitments.begin(), commitments.end(),
        [](const net::Commitment& each) { return each.state == net::Commitment::State::committed; }));
}

void printForPeople(const std::vector<net::Commitment>& commitments) {
    fmt::print("The archive has confirmed that it keeps {} of {}.\n", committedOf(commitments),
               commitments.size());
    for (const net::Commitment& each : commitments)
        if (each.state != net::Commitment::State::committed)
            printWarning(each.why.english() + " " + each.advice.english() + " (" +
                         printable(each.file.string()) + ")");
}

// Whoever cancels wants it not to be sent.
bool wasCancelled(const study::FilesSent& sent) {
    return sent.trouble && sent.trouble->code == ErrorCode::cancelled;
}

// Returns the ID of the entry; empty where nothing was left, or where it could not be kept, which is told.
std::string queueRest(const study::FilesSent& sent, const study::FilesToSend& files,
                      const net::Source& archive) {
    study::ToQueue rest{.archive = archive.name,
                        .address = net::addressOf(archive),
                        .files = {},
                        .patients = files.patients,
                        .tries = 1};
    if (sent.trouble) rest.trouble = study::reasonOf(*sent.trouble);
    for (const std::filesystem::path& file : sent.left) rest.files.push_back({file, {}});
    for (const net::NotSent& each : sent.refused)
        rest.files.push_back({each.file, study::Reason{each.why, each.advice}});
    if (rest.files.empty()) return {};
    auto outbox = study::Outbox::open();
    Progress progress({}, interruptToken());
    const auto id = outbox ? outbox->queue(rest, progress) : Result<std::string>(outbox.error());
    if (id) return *id;
    printWarning("What was not stored could not be put into the queue. " + describe(id.error()));
    return {};
}

void printForPeople(const study::FilesSent& sent, std::size_t all) {
    fmt::print("{} of {} stored.\n", sent.stored, all);
    for (const net::NotSent& each : sent.refused)
        printWarning(each.why.english() + " " + each.advice.english() + " (" + printable(each.file.string()) +
                     ")");
    if (sent.trouble && sent.stored + sent.refused.size() > 0)
        printWarning(sent.trouble->message.english() + " " + sent.trouble->hint.english());
}

Error notAllStored(const study::FilesSent& sent, const std::string& queued) {
    const Text wait =
        queued.empty() ? Text() : Text("The files wait in the queue: macula pacs retry sends them.");
    if (sent.trouble && sent.stored + sent.refused.size() == 0)
        return {sent.trouble->code, sent.trouble->message, {}, Text::joined({sent.trouble->hint, wait}, " ")};
    return {ErrorCode::archiveNotUsable,
            Text("{} files were not stored.", sent.left.size() + sent.refused.size()),
            {},
            Text::joined({Text("The reasons are above."), wait}, " ")};
}

Result<void> send(const SendOptions& options) {
    MACULA_TRY(const OpenArchive open, openArchive(options));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const study::FilesToSend files, study::filesToSend(options.paths, progress));
    MACULA_TRY_VOID(askWhether(files, options));
    const study::FilesSent sent = study::sendFiles(*open.archive, files.files, progress);
    if (wasCancelled(sent)) return *sent.trouble;
    const std::string queued = options.noQueue ? std::string() : queueRest(sent, files, open.source);
    const bool isSaidByError = options.noQueue && sent.trouble && sent.stored + sent.refused.size() == 0;
    if (!options.json && !isSaidByError) printForPeople(sent, files.files.size());
    Result<std::vector<net::Commitment>> commitments = std::vector<net::Commitment>();
    const std::vector<std::filesystem::path> stored = storedOf(files, sent);
    const bool asks = options.commit && !stored.empty();
    if (asks)
        commitments = open.archive->commit(stored, std::chrono::seconds(options.commitSeconds), progress);
    if (options.json && !isSaidByError) {
        nlohmann::ordered_json json = study::toJson(study::inOneList(sent));
        json["queued"] = queued.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(queued);
        if (asks && commitments) json["commitment"] = study::toJson(*commitments);
        fmt::print("{}\n", jsonText(json));
    } else if (asks && commitments) {
        printForPeople(*commitments);
    }
    if (!sent.left.empty() || !sent.refused.empty()) return notAllStored(sent, queued);
    if (!commitments) return commitments.error();
    const std::size_t unconfirmed = commitments->size() - committedOf(*commitments);
    if (unconfirmed == 0) return {};
    return Error{ErrorCode::archiveNotUsable,
                 Text("The archive has not confirmed that it keeps {} files.", unconfirmed),
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
    command->add_flag("--commit", options->commit,
                      "Have the archive confirm that it keeps the files (storage commitment)");
    command->add_option("--commit-wait", options->commitSeconds, "How many seconds to wait for that")
        ->capture_default_str()
        ->check(CLI::Range(1, 86400));
    command->add_flag("--no-queue", options->noQueue,
                      "Keep nothing of what could not be stored; without it, macula pacs queue lists it");
    command->callback([options, &action] { action = [options] { return send(*options); }; });
}

}  // namespace macula::cli
