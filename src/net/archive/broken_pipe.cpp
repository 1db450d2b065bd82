#include "net/archive/broken_pipe.h"

#include <cerrno>
#include <ctime>

namespace macula::net {

WithoutBrokenPipes::WithoutBrokenPipes() {
    sigset_t pending;
    sigpending(&pending);
    wasPending_ = sigismember(&pending, SIGPIPE) == 1;
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
}

WithoutBrokenPipes::~WithoutBrokenPipes() {
    const int kept = errno;
    const timespec atOnce{0, 0};
    while (!wasPending_ && sigtimedwait(&pipe_, nullptr, &atOnce) == -1 && errno == EINTR) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = kept;
}

}  // namespace macula::net
