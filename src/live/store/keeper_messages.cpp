#include "live/store/keeper_messages.h"

#include <exception>

#include "base/log.h"

namespace macula::live {

void KeeperMessages::tell(const Error& error) {
    if (!told_.insert(error.message).second) return;
    log::warning("Stored sessions: {}", error.message);
    if (listener_) listener_(error);
}

void KeeperMessages::tellOfNoMemory(const char* sentence) noexcept {
    try {
        tell({ErrorCode::outOfMemory, sentence, {}, Text("Close other programs.")});
    } catch (const std::exception&) {
        // There is none to say so either.
    }
}

void KeeperMessages::tellOfFault(const CheckFailure& failure) noexcept {
    try {
        log::error("Stored sessions: {}", failure.text());
        tell({ErrorCode::inputNotUsable,
              Text("Stored sessions were not changed, because Macula found a mistake of its own."),
              {},
              "Please report this: " + failure.text()});
    } catch (const std::exception&) {
        // There is no memory to say so.
    }
}

}  // namespace macula::live
