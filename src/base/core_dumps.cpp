#include "base/core_dumps.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace macula {

// PR_SET_DUMPABLE would do both, but then desktop portals could not tell which program asks them for a file.
void switchCoreDumpsOff() {
    const char* wanted = std::getenv("MACULA_CORE_DUMPS");
    if (wanted != nullptr && std::strcmp(wanted, "1") == 0) return;
    rlimit limit{};
    if (getrlimit(RLIMIT_CORE, &limit) == 0) {
        limit.rlim_cur = 0;
        static_cast<void>(setrlimit(RLIMIT_CORE, &limit));
    }
    const int filter = open("/proc/self/coredump_filter", O_WRONLY | O_CLOEXEC);
    if (filter < 0) return;
    static_cast<void>(write(filter, "0", 1) == 1);
    close(filter);
}

}  // namespace macula
