#include "viewer/planar/planar_player.h"

#include <algorithm>
#include <cmath>

namespace macula::viewer {

PlanarPlayer::PlanarPlayer(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &PlanarPlayer::due);
}

void PlanarPlayer::start(double firstMs) {
    isPlaying_ = true;
    clock_.start();
    dueMs_ = firstMs;
    wait();
}

void PlanarPlayer::stop() {
    isPlaying_ = false;
    timer_.stop();
}

void PlanarPlayer::holdFor(double ms) {
    dueMs_ = std::max(dueMs_ + ms, double(clock_.elapsed()));
    wait();
}

void PlanarPlayer::askAgain() {
    constexpr double kPatienceMs = 5.0;
    dueMs_ = double(clock_.elapsed()) + kPatienceMs;
    wait();
}

void PlanarPlayer::wait() {
    timer_.start(int(std::lround(std::max(dueMs_ - double(clock_.elapsed()), 0.0))));
}

}  // namespace macula::viewer
