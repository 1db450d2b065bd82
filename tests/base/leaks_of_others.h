// Leaks of others that tests/suppressions/leak.txt cannot name: their library is not in the stack, for it was
// built without frame pointers.
#pragma once

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace macula::test {

// While one lives, what this thread allocates is not looked for at the end.
class LeaksOfOthers {
  public:
#ifdef __SANITIZE_ADDRESS__
    LeaksOfOthers() {
        __lsan_disable();
    }
    ~LeaksOfOthers() {
        __lsan_enable();
    }
#else
    LeaksOfOthers() {}
    ~LeaksOfOthers() {}
#endif
    LeaksOfOthers(const LeaksOfOthers&) = delete;
    LeaksOfOthers& operator=(const LeaksOfOthers&) = delete;
};

}  // namespace macula::test
