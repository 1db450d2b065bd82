#include "net/programs.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace macula::net::test {

namespace {

sockaddr_in loopbackAt(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

}  // namespace

std::string programNamed(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(std::string(path == nullptr ? "" : path) + ":/usr/sbin:/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::string candidate = folder + "/" + name;
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return {};
}

std::uint16_t freePort() {
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopbackAt(0);
    socklen_t length = sizeof address;
    EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), length), 0);
    EXPECT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &length), 0);
    close(listener);
    return ntohs(address.sin_port);
}

bool answersAt(std::uint16_t port) {
    const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopbackAt(port);
    const bool answers =
        connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(connection);
    return answers;
}

bool comes(const std::function<bool()>& isThere, double seconds) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!isThere()) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

Program::Program(const std::vector<std::string>& command, const std::filesystem::path& folder) {
    static std::atomic<int> counter{0};
    output_ = folder / fmt::format("output_{}.txt", counter++);
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const int output = open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ != 0) {
        close(output);
        return;
    }
    // A group of its own takes along what the program starts. If the test's process is killed, so is this.
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent || chdir(folder.c_str()) != 0) _exit(126);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
}

Program::~Program() {
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    reap(true);
    kill(-process_, SIGKILL);  // what it started in between
}

void Program::reap(bool waits) {
    if (isReaped_) return;
    isReaped_ = waitpid(process_, &status_, waits ? 0 : WNOHANG) == process_;
}

bool Program::isRunning() {
    reap(false);
    return !isReaped_;
}

int Program::exitCode() {
    EXPECT_TRUE(comes([&] { return !isRunning(); }, 60.0)) << "a program does not end:\n" << output();
    return isReaped_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

std::string Program::output() const {
    std::ifstream file(output_);
    return {std::istreambuf_iterator<char>(file), {}};
}

Ran ran(const std::vector<std::string>& command, const std::filesystem::path& folder) {
    Program program(command, folder);
    const int exitCode = program.exitCode();
    return {exitCode, program.output()};
}

}  // namespace macula::net::test
