#include "live/store/keeper_messages.h"

#include <exception>

#include "base/log.h"

namespace macula::live {

void KeeperMessages::tell(const Error& error) {
    const std::string sentence = error.message.english();
    if (!told_.insert(sentence).second) return;
    log::warning("Stored sessions: {}", sentence);
    if (listener_) listener_(error);
}

void KeeperMessages::tellOfNoMemory(Text (*sentence)()) noexcept {
    try {
        tell({ErrorCode::outOfMemory, sentence(), {}, Text("Close other programs.")});
    } catch (const std::exception&) {
        // There is no memory to report it either.
    }
}

void KeeperMessages::tellOfFault(const CheckFailure& failure) noexcept {
    try {
        log::error("Stored sessions: {}", failure.text());
        tell({ErrorCode::inputNotUsable,
              Text("Stored sessions were not changed, because Macula found a mistake of its own."),
              {},
              Text("Please report this: {}", failure.text())});
    } catch (const std::exception&) {
        // There is no memory to report it.
    }
}

}  // namespace macula::live
