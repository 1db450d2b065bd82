#include "net/dimse/port_turn.h"

#include <chrono>
#include <map>

namespace macula::net {

namespace {

constexpr std::chrono::milliseconds kSlice{50};

// One mutex for each port of this machine that anybody in this process listens at.
std::shared_ptr<std::timed_mutex> mutexOfPort(std::uint16_t port) {
    static std::mutex mutex;
    static std::map<std::uint16_t, std::shared_ptr<std::timed_mutex>> mutexes;
    const std::lock_guard lock(mutex);
    auto& found = mutexes[port];
    if (!found) found = std::make_shared<std::timed_mutex>();
    return found;
}

}  // namespace

PortTurn::PortTurn(std::uint16_t port) : mutex_(mutexOfPort(port)), lock_(*mutex_, std::defer_lock) {}

bool PortTurn::wait(const CancelToken& cancel) {
    while (!lock_.try_lock_for(kSlice))
        if (cancel.cancelled()) return false;
    return true;
}

}  // namespace macula::net
