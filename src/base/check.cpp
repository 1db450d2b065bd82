#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace macula {

void checkFailed(const char* file, int line, const char* what, const std::string& values) {
    std::fprintf(stderr, "%s:%d: check failed: %s%s%s\n", file, line, what, values.empty() ? "" : ": ",
                 values.c_str());
    std::fflush(stderr);
    std::abort();
}

}  // namespace macula
