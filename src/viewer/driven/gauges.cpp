#include "viewer/driven/gauges.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

#include "live/frame/times_report.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

namespace {

constexpr int kIntervalMs = 5;

double ownWorkMs() {
#ifdef __linux__
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return 1e3 * double(worked.tv_sec) + 1e-6 * double(worked.tv_nsec);
#else
    return 0.0;
#endif
}

double percentile(std::vector<double> values, double fraction) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[std::size_t(fraction * double(values.size() - 1) + 0.5)];
}

double rounded(double value) {
    return std::round(10.0 * value) / 10.0;
}

}  // namespace

UiHeartbeat::UiHeartbeat(QObject* parent) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kIntervalMs);
    connect(&timer_, &QTimer::timeout, this, &UiHeartbeat::beat);
}

void UiHeartbeat::start() {
    longestMs_ = 0.0;
    ownWorkInItMs_ = 0.0;
    ownWorkMs_ = ownWorkMs();
    noticed_ = 0;
    beats_ = 0;
    sinceLast_.start();
    timer_.start();
}

void UiHeartbeat::stop() {
    beat();  // a stall at the very end counts
    timer_.stop();
}

void UiHeartbeat::beat() {
    const double gapMs = double(sinceLast_.nsecsElapsed()) / 1e6;
    sinceLast_.start();
    const double workedBefore = std::exchange(ownWorkMs_, ownWorkMs());
    if (gapMs - kIntervalMs > longestMs_) {
        longestMs_ = gapMs - kIntervalMs;
        ownWorkInItMs_ = ownWorkMs_ - workedBefore;
    }
    if (gapMs - kIntervalMs > kNoticedMs) ++noticed_;
    ++beats_;
}

OpeningTimes::OpeningTimes(MainWindow& window, QObject* parent) : QObject(parent) {
    connect(&window.viewport().window(), &VulkanWindow::exposed, this, [this] { note(windowMs_); });
    connect(&window, &MainWindow::studyShown, this, [this] { note(studyReadMs_); });
    for (const auto orientation :
         {slices::Orientation::axial, slices::Orientation::coronal, slices::Orientation::sagittal})
        connect(&window.slices(orientation), &SliceView::pictureShown, this, [this] { note(sliceMs_); });
    connect(&window, &MainWindow::frameShown, this, [this](const live::FrameShown& frame) {
        note(pictureMs_);
        if (frame.picture == live::OnScreen::model) noteModel(frame.model);
    });
    // At rest it is not on screen, but a hand would see it now.
    connect(&window.viewport(), &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        const auto* spent = std::get_if<live::TimeSpent>(&event);
        if (spent != nullptr && modelMs_ < 0.0) spent_ = spent->stages;
        const auto* changed = std::get_if<live::ModelChanged>(&event);
        if (changed != nullptr && hybrid::isFitToBeShown(changed->model)) noteModel(changed->model);
    });
}

void OpeningTimes::noteModel(const hybrid::ModelNews& model) {
    if (modelMs_ >= 0.0) return;
    note(modelMs_);
    modelOrigin_ = QString::fromUtf8(nameOf(model.origin).data());
}

void OpeningTimes::note(double& ms) const {
    if (ms < 0.0 && clock_.isValid()) ms = double(clock_.nsecsElapsed()) / 1e6;
}

QJsonObject OpeningTimes::toJson() const {
    const std::string times = live::toJson(spent_).dump();
    return {{"windowMs", std::round(windowMs_)},
            {"studyReadMs", std::round(studyReadMs_)},
            {"sliceMs", std::round(sliceMs_)},
            {"pictureMs", std::round(pictureMs_)},
            {"modelMs", std::round(modelMs_)},
            {"modelOrigin", modelOrigin_},
            {"renderThread", QJsonDocument::fromJson(QByteArray::fromStdString(times)).array()}};
}

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
