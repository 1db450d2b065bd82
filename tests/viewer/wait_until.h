// Waiting for something that happens in the event loop.
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

namespace macula::viewer {

// Only what hangs takes as long: no test depends on how fast a machine is.
inline constexpr int kPatienceSeconds = 480;

// Runs the event loop until `done` or so many seconds have passed; whether it is done.
template <class Done>
bool waitUntil(Done done, int seconds = kPatienceSeconds) {
    QElapsedTimer waited;
    waited.start();
    while (!done()) {
        if (waited.elapsed() > 1000 * seconds) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        QThread::msleep(1);  // the device of these tests may be this processor
    }
    return true;
}

}  // namespace macula::viewer
