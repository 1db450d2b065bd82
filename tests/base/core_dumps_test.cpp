// A program that ends by a fault leaves no copy of its memory, unless somebody asks for it.
#include "base/core_dumps.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

namespace macula {
namespace {

std::string filterNow() {
    std::ifstream file("/proc/self/coredump_filter");
    std::string filter;
    file >> filter;
    return filter;
}

rlim_t limitNow() {
    rlimit limit{};
    return getrlimit(RLIMIT_CORE, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

// What a child of this process gives back.
template <class Work>
int inChild(Work work) {
    const pid_t child = fork();
    if (child == 0) _exit(work());
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

void allowDumps() {
    rlimit limit{};
    getrlimit(RLIMIT_CORE, &limit);
    limit.rlim_cur = limit.rlim_max;
    setrlimit(RLIMIT_CORE, &limit);
    std::ofstream("/proc/self/coredump_filter") << "0x33";
}

TEST(CoreDumps, AreSwitchedOff) {
    const int status = inChild([] {
        unsetenv("MACULA_CORE_DUMPS");
        allowDumps();
        if (filterNow() != "00000033") return 1;
        switchCoreDumpsOff();
        if (limitNow() != 0) return 2;
        return filterNow() == "00000000" ? 0 : 3;
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(CoreDumps, AreNotWrittenByAFault) {
    std::string pattern;
    std::ifstream("/proc/sys/kernel/core_pattern") >> pattern;
    if (pattern.starts_with('|')) GTEST_SKIP() << "a service takes dumps here, whatever the limit";
    const int status = inChild([] {
        unsetenv("MACULA_CORE_DUMPS");
        allowDumps();
        switchCoreDumpsOff();
        signal(SIGQUIT, SIG_DFL);
        raise(SIGQUIT);
        return 0;
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_FALSE(WCOREDUMP(status));
}

TEST(CoreDumps, StayForWhoAsksForThem) {
    const int status = inChild([] {
        setenv("MACULA_CORE_DUMPS", "1", 1);
        allowDumps();
        const rlim_t before = limitNow();
        switchCoreDumpsOff();
        if (limitNow() != before) return 1;
        return filterNow() == "00000033" ? 0 : 2;
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace macula
