#include "cli/shared/interrupt.h"

#include <csignal>

namespace macula::cli {

namespace {

// Never destroyed: a signal may come until the very end.
const CancelToken& token() {
    static const auto* const shared = new CancelToken;
    return *shared;
}

void onSignal(int signal) {
    token().cancel();  // only stores to a lock-free atomic
    std::signal(signal, SIG_DFL);
}

}  // namespace

const CancelToken& interruptToken() {
    // Made before the handler can run: making it allocates.
    static const CancelToken& shared = [&]() -> const CancelToken& {
        const CancelToken& made = token();
        std::signal(SIGINT, onSignal);
        std::signal(SIGTERM, onSignal);
        // The terminal went away; nohup says that nobody minds.
        if (std::signal(SIGHUP, onSignal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
        return made;
    }();
    return shared;
}

}  // namespace macula::cli
