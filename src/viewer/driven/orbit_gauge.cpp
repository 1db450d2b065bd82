#include "viewer/driven/orbit_gauge.h"

#include <algorithm>
#include <cmath>

namespace macula::viewer {

namespace {

double percentile(std::vector<double> values, double fraction) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[std::size_t(fraction * double(values.size() - 1) + 0.5)];
}

double rounded(double value) {
    return std::round(10.0 * value) / 10.0;
}

}  // namespace

OrbitGauge::OrbitGauge(MainWindow& window, QObject* parent) : QObject(parent), window_(window) {
    connect(&window, &MainWindow::frameShown, this, &OrbitGauge::onFrame);
}

void OrbitGauge::begin() {
    latenciesMs_.clear();
    ofModel_ = 0;
    seconds_ = 0.0;
    lastInput_ = 0;
    size_ = window_.viewport().pictureSize();
    since_.start();
    isRunning_ = true;
}

void OrbitGauge::end() {
    if (!std::exchange(isRunning_, false)) return;
    seconds_ = double(since_.nsecsElapsed()) / 1e9;
}

// A view that is shown once more is no new frame that follows the camera.
void OrbitGauge::onFrame(const live::FrameShown& frame) {
    if (!isRunning_ || frame.inputSequence == lastInput_) return;
    lastInput_ = frame.inputSequence;
    latenciesMs_.push_back(frame.latencyMs);
    if (frame.picture == live::OnScreen::model) ++ofModel_;
}

double OrbitGauge::framesPerSecond() const {
    return seconds_ > 0.0 ? double(latenciesMs_.size()) / seconds_ : 0.0;
}

QJsonObject OrbitGauge::toJson() const {
    return {{"width", size_.width()},
            {"height", size_.height()},
            {"seconds", rounded(seconds_)},
            {"frames", qint64(latenciesMs_.size())},
            {"framesPerSecond", rounded(framesPerSecond())},
            {"modelFrames", qint64(ofModel_)},
            {"latencyMedianMs", rounded(percentile(latenciesMs_, 0.5))},
            {"latency95thMs", rounded(percentile(latenciesMs_, 0.95))}};
}

}  // namespace macula::viewer
