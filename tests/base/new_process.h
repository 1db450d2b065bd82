// Tests of what holds in another process too.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace macula::test {

// Runs tests of this program in a new process, disabled ones too; its exit code.
inline int runInNewProcess(const char* filter) {
    const pid_t child = fork();
    if (child == 0) {
        const std::string chosen = std::string("--gtest_filter=") + filter;
        execl("/proc/self/exe", "test", chosen.c_str(), "--gtest_also_run_disabled_tests", nullptr);
        _exit(127);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace macula::test
