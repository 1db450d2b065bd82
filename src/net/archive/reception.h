// Who takes in what others send without being asked for it.
#pragma once

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

class Reception {
  public:
    virtual ~Reception() = default;

    // For what comes over one association, at whose end it goes. Called by several threads at once. The key
    // with which an instance is handed over has the study that the beginning of its dataset names, if that
    // was found there.
    virtual std::unique_ptr<Receiver> receiverFor(const Caller& caller) = 0;
};

}  // namespace macula::net
