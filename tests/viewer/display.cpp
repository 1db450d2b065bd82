#include "viewer/display.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace macula::viewer::test {

namespace {

pid_t server = -1;

void stopServer() {
    if (server <= 0) return;
    kill(server, SIGTERM);
    waitpid(server, nullptr, 0);
    server = -1;
}

std::string startServer() {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    server = fork();
    if (server < 0) return "no fork";
    if (server == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);  // also when a test crashes
        close(ends[0]);
        const std::string descriptor = std::to_string(ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24", "-nolisten",
               "tcp", "-noreset", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    // It writes its number once it accepts connections; the end of the pipe without one means it failed.
    std::string number;
    char c = 0;
    while (read(ends[0], &c, 1) == 1 && c != '\n') number += c;
    close(ends[0]);
    if (number.empty()) {
        stopServer();
        return "DISPLAY is not set, and Xvfb (package xvfb) did not start";
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);
    std::atexit(stopServer);
    return {};
}

}  // namespace

std::string ensureDisplay() {
    setenv("QT_QPA_PLATFORM", "xcb", 1);
    const char* display = std::getenv("DISPLAY");
    return display != nullptr && *display != '\0' ? std::string() : startServer();
}

}  // namespace macula::viewer::test
