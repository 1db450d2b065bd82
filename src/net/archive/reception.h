// Who takes in what others send without being asked for it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "net/archive/receiver.h"

namespace macula::net {

// Somebody who makes an association with this program. The title is what the caller says of itself: only the
// address, and a certificate where one is asked for, tell who it is.
struct Caller {
    std::string ae;
    std::string address;  // as numbers
};

// Who may call. Both must fit; one that is empty fits everybody.
struct AdmittedCaller {
    std::string ae;
    std::string address;  // of IPv4 or IPv6, or a range of them: "10.1.2.3", "10.1.0.0/16", "2001:db8::/32"
};

struct AdmissionLimits {
    std::size_t associations = 8;            // at once
    std::size_t associationsPerSecond = 50;  // old machines make one for each image
    std::size_t associationsPerMinute = 1500;
};

class Reception {
  public:
    virtual ~Reception() = default;

    // For what comes over one association, at whose end it goes. Called by several threads at once. The key
    // with which an instance is handed over has the study that the beginning of its dataset names, if that
    // was found there.
    virtual std::unique_ptr<Receiver> receiverFor(const Caller& caller) = 0;
};

}  // namespace macula::net
