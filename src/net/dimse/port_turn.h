// Those in this process who listen at one port for a while take turns.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "base/progress.h"

namespace macula::net {

class PortTurn {
  public:
    explicit PortTurn(std::uint16_t port);

    // Until nobody else has the turn; false once cancelled. It is given up with the object.
    bool wait(const CancelToken& cancel);

  private:
    std::shared_ptr<std::timed_mutex> mutex_;
    std::unique_lock<std::timed_mutex> lock_;
};

}  // namespace macula::net
