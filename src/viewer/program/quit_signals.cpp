#include "viewer/program/quit_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <utility>

#include "base/check.h"
#include "base/log.h"

namespace macula::viewer {

namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};

// A signal handler may do little more than write to a pipe, and has no access to an object.
int readEnd = -1;
int writeEnd = -1;
std::array<struct sigaction, kSignals.size()> before;

extern "C" void onSignalToQuit(int) {
    const int error = errno;
    const char asked = 1;
    [[maybe_unused]] const auto written = ::write(writeEnd, &asked, 1);  // a full pipe tells it, too
    errno = error;
}

}  // namespace

QuitSignals::QuitSignals(QObject* parent) : QObject(parent) {
    MACULA_CHECK(readEnd < 0);
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        log::warning("Signals to end the program are not listened to: there is no pipe.");
        return;
    }
    readEnd = ends[0];
    writeEnd = ends[1];
    notifier_ = new QSocketNotifier(readEnd, QSocketNotifier::Read, this);
    connect(notifier_, &QSocketNotifier::activated, this, &QuitSignals::onReadable);
    struct sigaction action {};
    action.sa_handler = &onSignalToQuit;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART | int(SA_RESETHAND);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &before[i]);
        // A signal that the parent process made the program ignore (nohup) stays ignored.
        if (before[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &action, nullptr);
    }
}

QuitSignals::~QuitSignals() {
    if (notifier_ == nullptr) return;
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before[i], nullptr);
    delete notifier_;
    for (int* end : {&readEnd, &writeEnd}) ::close(std::exchange(*end, -1));
}

void QuitSignals::onReadable() {
    std::array<char, 8> read{};
    while (::read(readEnd, read.data(), read.size()) > 0) {
    }
    Q_EMIT asked();
}

}  // namespace macula::viewer
