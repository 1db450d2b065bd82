// Signing in by a browser, which may run on another machine (OAuth 2.0 Device Authorization Grant, RFC 8628).
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/source.h"

namespace macula::net {

// What a person is shown. Printable ASCII, from the service.
struct DeviceCode {
    std::string userCode;      // to be typed there
    std::string address;       // where a browser goes; https, or http on this machine
    std::string wholeAddress;  // with the code in it; empty where the service gives none
    std::chrono::seconds life{600};
};
using ShowDeviceCode = std::function<void(const DeviceCode&)>;

// Asks for a code, shows it, and waits until the person has signed in: up to the life of the code, or until
// it is cancelled. Returns the secrets with the tokens that came. Fails with usage where the source uses
// another way to sign in, with archiveNotUsable where the person declined, the code ran out, or the service
// fails.
Result<Secrets> signInByDevice(const Source& source, const Secrets& secrets, const ShowDeviceCode& show,
                               Progress& progress);

}  // namespace macula::net
