// How an archive is described on the command line.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "base/result.h"
#include "net/archive/source.h"

namespace macula::cli {

struct PacsOptions {
    std::string name;
    std::string dimse;  // AE@HOST:PORT
    std::string url;
    std::string signIn;  // a word of the JSON; empty: basic if there is a user
    std::string retrieve = "automatic";
    bool tls = false;
    net::DimsePeer peer;
    net::WebPeer web;
    net::Tls files;
    bool askPassword = false;
};

void addPacsOptions(CLI::App& command, PacsOptions& options);

Result<net::Source> sourceOf(const PacsOptions& options);

// From the terminal without an echo, or the first line of stdin: a password has no place among arguments,
// which everybody can list.
Result<net::Secrets> readSecrets(const net::Source& source);

}  // namespace macula::cli
