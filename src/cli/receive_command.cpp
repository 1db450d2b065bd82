// macula receive: takes studies that others send, until somebody stops it.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "base/elapsed.h"
#include "base/printable.h"
#include "cli/command.h"
#include "cli/receive_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "net/dimse/address_range.h"
#include "study/archive/archive_json.h"
#include "study/archive/receiving.h"

namespace macula::cli {

namespace {

constexpr std::chrono::milliseconds kLookedAtEvery{50};

// Prints each sentence once: somebody who knocks again and again does not fill the terminal.
class SaidOnce {
  public:
    void warn(const std::string& sentence) {
        const std::lock_guard lock(mutex_);
        if (said_.size() < kMost && said_.insert(sentence).second) printWarning(printable(sentence));
    }

  private:
    static constexpr std::size_t kMost = 100;
    std::mutex mutex_;
    std::set<std::string> said_;
};

void printListening(const net::StoreProviderOptions& options, std::uint16_t port) {
    const std::string address = options.address.empty() ? "all addresses" : options.address;
    printNote(Text("Listening as {} at port {} of {}{}. Ctrl+C stops it.", options.ownAe, port, address,
                   options.tls.isOn ? " over TLS" : ""));
    if (!options.tls.isOn && !net::isOfThisMachineAlone(options.address))
        printWarning(Text("What other machines send is not encrypted. --tls-certificate encrypts it."));
}

// Each study as soon as it is done.
class Printer {
  public:
    explicit Printer(const ReceiveOptions& options) : options_(options) {}

    void print(const std::vector<study::ReceivedStudy>& studies) {
        for (const study::ReceivedStudy& each : studies) {
            images_ += each.kept;
            const bool isFirst = folders_.insert(each.folder).second;
            if (options_.json)
                fmt::print("{}\n", study::toJson(each).dump(
                                       -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
            else
                printForPeople(each, isFirst);
            // Whoever reads this through a pipe opens the study now.
            std::fflush(stdout);
        }
    }
    std::size_t studies() const { return folders_.size(); }
    std::size_t images() const { return images_; }

  private:
    static void printForPeople(const study::ReceivedStudy& each, bool isFirst) {
        fmt::print("{}\n", each.folder.string());
        printNote(Text("{} images came from {}{}, {} were there.", each.kept,
                       printable(fmt::format("{}", fmt::join(each.senders, ", "))),
                       isFirst ? "" : " to a study that had come before", each.hadAlready));
        for (const Message& message : each.messages)
            printWarning(message.sentence.english() + " " + message.action.english());
    }

    const ReceiveOptions& options_;
    std::set<std::filesystem::path> folders_;
    std::size_t images_ = 0;
};

void printSummary(const Printer& printer, const net::StoreProvider::Counts& counts, std::size_t unreadable) {
    printNote(Text("{} images of {} studies came.", printer.images(), printer.studies()));
    if (counts.refused > 0)
        printWarning(Text("{} objects were refused, {} of them because they cannot be read.", counts.refused,
                          unreadable));
    if (counts.withoutRoom > 0)
        printWarning(Text("There was no room for {} objects. Their sender knows it.", counts.withoutRoom));
    if (counts.cutOff > 0)
        printWarning(Text("{} objects were cut off when their connection ended.", counts.cutOff));
    if (counts.turnedAway > 0) printNote(Text("{} connections were turned away.", counts.turnedAway));
}

Result<void> endOf(const ReceiveOptions& options, const Printer& printer,
                   const net::StoreProvider::Counts& counts, const std::optional<Error>& trouble) {
    // Where only the disk's last word is missing, all was kept, and may still be lost.
    if (counts.withoutRoom > 0 || (trouble && trouble->code == ErrorCode::outputNotWritable))
        return trouble.value_or(Error{ErrorCode::outputNotWritable,
                                      Text("Not all that was sent was kept."),
                                      {},
                                      Text("Make room, or allow more with --limit-gb; then send it again.")});
    if (!options.once || printer.studies() > 0) return {};
    if (interruptToken().cancelled()) return Error{ErrorCode::cancelled, Text("No study had come."), {}, {}};
    return Error{ErrorCode::archiveNotUsable,
                 Text("No study came in {} seconds.", options.forSeconds),
                 {},
                 Text("Check the address, the port and the AE title in the machine that is to send.")};
}

Result<void> receive(const ReceiveOptions& options) {
    MACULA_TRY(study::ReceivingOptions settings, receivingOptions(options));
    SaidOnce said;
    settings.provider.onTurnedAway = [&said](const net::TurnedAway& each) {
        said.warn(textOf(each).english());
    };
    MACULA_TRY(const auto receiving, study::Receiving::start(settings));
    study::ReceivedStudies& studies = receiving->studies();
    printListening(settings.provider, receiving->port());

    Printer printer(options);
    std::optional<Error> trouble;
    const auto begun = std::chrono::steady_clock::now();
    while (!interruptToken().cancelled()) {
        if (options.forSeconds > 0 && secondsSince(begun) >= options.forSeconds) break;
        std::this_thread::sleep_for(kLookedAtEvery);
        printer.print(studies.finishQuiet());
        if (const auto latest = studies.takeTrouble()) {
            trouble = latest;
            said.warn(describe(*latest));
        }
        if (options.once && printer.studies() > 0) break;
    }
    receiving->end();
    printer.print(studies.finishAll());
    if (const auto latest = studies.takeTrouble()) trouble = latest;
    printSummary(printer, receiving->counts(), studies.unreadable());
    return endOf(options, printer, receiving->counts(), trouble);
}

}  // namespace

void addReceive(CLI::App& app, Action& action) {
    auto options = std::make_shared<ReceiveOptions>();
    auto* command = app.add_subcommand(
        "receive", "Take studies that others send (DICOM C-STORE), and print the folder of each");
    addReceiveOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return receive(*options); }; });
}

}  // namespace macula::cli
