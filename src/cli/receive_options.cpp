#include "cli/receive_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <utility>

#include "net/dimse/admission.h"

namespace macula::cli {

namespace {

constexpr const char* kAllAddresses = "all";

Result<net::AdmittedCaller> callerOf(const std::string& text) {
    Result<net::AdmittedCaller> caller = net::admittedCaller(text);
    if (caller) return caller;
    Error error = caller.error();
    error.hint = Text("For example --from CT1@10.1.2.3, or --anyone for everybody.");
    return error;
}

}  // namespace

void addReceiveOptions(CLI::App& command, ReceiveOptions& options) {
    net::StoreProviderOptions& provider = options.provider;
    command.add_option("--into", options.into,
                       "Folder for received studies; without it, the private one of fetched studies");
    command.add_option("--ae", provider.ownAe, "AE title of this program")->capture_default_str();
    command.add_option("--port", provider.port, "Port to listen at; 0: any that is free, which is printed")
        ->capture_default_str();
    command
        .add_option(
            "--address", provider.address,
            "Address of this machine to listen at; all: every one. Beyond this machine it needs --from "
            "or --anyone")
        ->capture_default_str();
    command.add_option("--from", options.from,
                       "Who may send: TITLE, TITLE@ADDRESS or *@ADDRESS, with an address or a range of them, "
                       "such as CT1@10.1.2.3 or *@10.1.0.0/16; can be given several times");
    command.add_flag("--anyone", provider.admitsAnyone, "Everybody who reaches this machine may send");
    command.add_option("--tls-certificate", provider.tls.certificate,
                       "PEM file of our certificate: connections are encrypted then");
    command.add_option("--tls-key", provider.tls.key, "PEM file of its key");
    command.add_option("--authorities", provider.tls.authorities,
                       "PEM file of who may sign the certificates that senders then must show");
    command.add_option("--limit-gb", options.limitGigabytes, "How much to take in all")
        ->check(CLI::PositiveNumber);
    command.add_option("--associations", provider.admission.associations, "How many connections at once")
        ->capture_default_str()
        ->check(CLI::Range(1, 256));
    command
        .add_option("--done-after", options.doneAfterSeconds,
                    "Seconds without an image of a study until it counts as done")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 86400.0));
    command.add_option("--for", options.forSeconds, "Stop after that many seconds")
        ->check(CLI::PositiveNumber);
    command.add_flag("--once", options.once, "Stop after the first study");
    command.add_flag("--json", options.json, "Print a line of JSON for each study");
}

Result<study::ReceivingOptions> receivingOptions(const ReceiveOptions& options) {
    net::StoreProviderOptions provider = options.provider;
    if (provider.address == kAllAddresses) provider.address.clear();
    for (const std::string& each : options.from) {
        MACULA_TRY(net::AdmittedCaller caller, callerOf(each));
        provider.callers.push_back(std::move(caller));
    }
    const net::Tls& tls = provider.tls;
    provider.tls.isOn = !tls.certificate.empty() || !tls.key.empty() || !tls.authorities.empty();
    if (options.limitGigabytes > 0)
        provider.mostBytes = static_cast<std::uintmax_t>(options.limitGigabytes * 1e9);
    return study::ReceivingOptions{
        .provider = std::move(provider),
        .into = options.into,
        .limits = {.quiet = std::chrono::milliseconds(static_cast<long>(options.doneAfterSeconds * 1000))}};
}

}  // namespace macula::cli
