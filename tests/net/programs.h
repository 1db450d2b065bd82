// Programs that a test starts, and that end with it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace macula::net::test {

// Where a program lies, in PATH or in the folders of administrators; empty if it is not installed.
std::string programNamed(const std::string& name);

// A port of loopback at which nobody listens now. Somebody else may take it before it is used.
std::uint16_t freePort();

// Whether somebody accepts connections there.
bool answersAt(std::uint16_t port);

// Waits up to `seconds` for something that comes by itself.
bool comes(const std::function<bool()>& isThere, double seconds = 30.0);

// A program that runs in the background, with all that it starts, until the object goes or the test's process
// ends. What it prints is kept for texts of failures.
class Program {
  public:
    // `folder`: in which it works and leaves its output.
    Program(const std::vector<std::string>& command, const std::filesystem::path& folder);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    bool isRunning();
    int exitCode();  // waits for its end, 60 seconds at most; -1 if a signal ended it
    std::string output() const;

  private:
    void reap(bool waits);

    std::filesystem::path output_;
    pid_t process_ = -1;
    bool isReaped_ = false;
    int status_ = 0;
};

// Runs a program to its end; its output.
struct Ran {
    int exitCode = -1;
    std::string output;
};
Ran ran(const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace macula::net::test

#define SKIP_WITHOUT_PROGRAM(name)                       \
    if (::macula::net::test::programNamed(name).empty()) \
    GTEST_SKIP() << (name) << " is not installed on this machine"
