// Holds back the signal of a connection that the peer has closed.
#pragma once

#include <csignal>

namespace macula::net {

// Writing to a connection that the peer closed raises SIGPIPE, which ends a process that does not expect it,
// and OpenSSL offers no way around it. While such an object exists, this thread alone holds the signal back,
// because its handler belongs to the program that Macula is a part of. Keeps errno.
class WithoutBrokenPipes {
  public:
    WithoutBrokenPipes();
    ~WithoutBrokenPipes();
    WithoutBrokenPipes(const WithoutBrokenPipes&) = delete;
    WithoutBrokenPipes& operator=(const WithoutBrokenPipes&) = delete;

  private:
    sigset_t pipe_{};
    sigset_t before_{};
    bool wasPending_ = false;
};

}  // namespace macula::net
