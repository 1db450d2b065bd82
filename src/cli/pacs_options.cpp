#include "cli/pacs_options.h"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <charconv>
#include <iostream>
#include <map>

namespace macula::cli {

namespace {

const std::map<std::string, net::Retrieve> kRetrieveWords{
    {"automatic", net::Retrieve::automatic}, {"get", net::Retrieve::get}, {"move", net::Retrieve::move}};
const std::map<std::string, net::SignIn> kSignInWords{{"none", net::SignIn::none},
                                                      {"basic", net::SignIn::basic},
                                                      {"bearer", net::SignIn::bearer},
                                                      {"client", net::SignIn::clientCredentials},
                                                      {"device", net::SignIn::device}};

// "ARCHIVE@pacs.example.org:104"; an IPv6 address stands in brackets.
Result<void> readAddress(const std::string& text, net::DimsePeer& peer) {
    const Error wrong{ErrorCode::usage,
                      Text("An archive of DIMSE is written as AE@HOST:PORT."),
                      {},
                      Text("For example --dimse ARCHIVE@pacs.example.org:104.")};
    const std::size_t at = text.find('@');
    const std::size_t colon = text.rfind(':');
    if (at == std::string::npos || colon == std::string::npos || colon < at) return wrong;
    peer.calledAe = text.substr(0, at);
    peer.host = text.substr(at + 1, colon - at - 1);
    if (peer.host.starts_with('[') && peer.host.ends_with(']'))
        peer.host = peer.host.substr(1, peer.host.size() - 2);
    const auto read = std::from_chars(text.data() + colon + 1, text.data() + text.size(), peer.port);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return wrong;
    return {};
}

// From another working folder, a path that was typed as it is would mean another file. Whoever names a
// certificate wants TLS.
net::Tls tlsOf(const PacsOptions& options) {
    net::Tls tls = options.files;
    for (std::filesystem::path* file : {&tls.authorities, &tls.certificate, &tls.key}) {
        if (!file->empty()) *file = std::filesystem::absolute(*file);
    }
    tls.isOn = options.tls || !tls.authorities.empty() || !tls.certificate.empty() || !tls.key.empty();
    return tls;
}

// Nothing that is typed is seen until it is destroyed.
class WithoutEcho {
  public:
    WithoutEcho() {
        if (tcgetattr(STDIN_FILENO, &before_) != 0) return;
        termios quiet = before_;
        quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        isQuiet_ = tcsetattr(STDIN_FILENO, TCSAFLUSH, &quiet) == 0;
    }
    ~WithoutEcho() {
        if (isQuiet_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
    }
    WithoutEcho(const WithoutEcho&) = delete;
    WithoutEcho& operator=(const WithoutEcho&) = delete;

  private:
    termios before_{};
    bool isQuiet_ = false;
};

}  // namespace

void addPacsOptions(CLI::App& command, PacsOptions& options) {
    command.add_option("NAME", options.name, "What you call it")->required();
    command.add_option("--dimse", options.dimse,
                       "AE title, host and port of the archive: ARCHIVE@pacs.example.org:104");
    command.add_option("--web", options.url,
                       "Address of its DICOMweb service: https://pacs.example.org/dicom-web");
    command.add_option("--calling", options.peer.callingAe, "Our AE title, as the archive knows it")
        ->capture_default_str();
    command.add_option("--retrieve", options.retrieve, "C-GET, C-MOVE, or what the archive accepts")
        ->check(CLI::IsMember({"automatic", "get", "move"}))
        ->capture_default_str();
    command.add_option("--receive-at", options.peer.receiverPort,
                       "For C-MOVE: the port at which the archive reaches us, while a fetch lasts");
    command.add_option("--receive-as", options.peer.receiverAe,
                       "For C-MOVE: our AE title there, if it is not that of --calling");
    command
        .add_option("--charset", options.peer.characterSet,
                    "In which names are sent (Specific Character Set)")
        ->capture_default_str();
    command.add_flag("--patient-root", options.peer.patientRoot, "Search by the patient root model");
    command.add_flag("--tls", options.tls, "DIMSE over TLS; on where a certificate is named");
    command.add_option("--authorities", options.files.authorities,
                       "PEM file of who may sign its certificate, if not those of the system");
    command.add_option("--certificate", options.files.certificate,
                       "PEM file of our certificate, where the archive asks for one");
    command.add_option("--key", options.files.key, "PEM file of its key");
    command.add_option("--user", options.web.user, "User of the DICOMweb service");
    command.add_option("--sign-in", options.signIn, "How to sign in; basic if --user is given")
        ->check(CLI::IsMember({"none", "basic", "bearer", "client", "device"}));
    command.add_option("--token-url", options.web.tokenUrl, "OAuth 2: where tokens come from");
    command.add_option("--device-url", options.web.deviceUrl,
                       "OAuth 2 device flow: where codes for the sign-in by a browser come from");
    command.add_option("--client-id", options.web.clientId, "OAuth 2: our client ID");
    command.add_option("--scope", options.web.scope, "OAuth 2: what is asked for");
    command.add_option("--proxy", options.web.proxy, "HTTP proxy, if not that of the environment");
    command.add_flag("--password", options.askPassword,
                     "Ask for the password, token or client secret, or read it from stdin");
}

Result<net::Source> sourceOf(const PacsOptions& options) {
    if (options.dimse.empty() == options.url.empty())
        return Error{ErrorCode::usage,
                     Text("An archive is set up either with --dimse or with --web."),
                     {},
                     Text("Ask the administrator of the archive which it offers.")};
    net::Source source;
    source.name = options.name;
    if (options.url.empty()) {
        net::DimsePeer peer = options.peer;
        MACULA_TRY_VOID(readAddress(options.dimse, peer));
        peer.retrieve = kRetrieveWords.at(options.retrieve);
        peer.tls = tlsOf(options);
        source.peer = peer;
        return source;
    }
    net::WebPeer web = options.web;
    web.url = options.url;
    web.tls = tlsOf(options);
    web.signIn = options.signIn.empty() ? (web.user.empty() ? net::SignIn::none : net::SignIn::basic)
                                        : kSignInWords.at(options.signIn);
    source.peer = web;
    return source;
}

Result<net::Secrets> readSecrets(const net::Source& source) {
    if (isatty(STDIN_FILENO) != 0) fmt::print(stderr, "Password: ");
    std::string line;
    {
        const WithoutEcho quiet;
        std::getline(std::cin, line);
    }
    if (isatty(STDIN_FILENO) != 0) fmt::print(stderr, "\n");
    if (line.empty())
        return Error{ErrorCode::usage,
                     Text("No password was entered."),
                     {},
                     Text("Type it, or pipe it into the command.")};
    const auto* web = std::get_if<net::WebPeer>(&source.peer);
    if (web == nullptr) return net::Secrets{.keyPassphrase = line};
    if (web->signIn == net::SignIn::bearer) return net::Secrets{.token = line};
    return net::Secrets{.password = line};
}

}  // namespace macula::cli
