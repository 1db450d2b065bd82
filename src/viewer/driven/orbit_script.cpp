#include "viewer/driven/orbit_script.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QPixmap>
#include <QScreen>
#include <QThreadPool>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <variant>

#include "base/exit_codes.h"
#include "viewer/program/startup.h"

namespace macula::viewer {

namespace {

constexpr int kPaintedAfterMs = 200;
constexpr int kHandIntervalMs = 16;         // as often as a usual mouse and display
constexpr double kHandPixelsOfTurn = 1200;  // at 600 pixels height
constexpr double kSwayPixels = 60;          // up and down
constexpr double kSwaysInTurn = 2;
// An orbit that nothing followed measures nothing: on a slow machine the hand goes on until so many pictures
// did, or the script is out of time.
constexpr std::size_t kFollowedAtLeast = 3;
// Of the orbit, when pictures in motion are taken.
constexpr double kMotionShots[] = {0.2, 0.5, 0.8};
// After it.
constexpr double kRestShotsS[] = {0.5, 2.0, 10.0};

std::atomic<int> failedScreenshots{0};

double percentile(std::vector<double> values, double fraction) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::size_t(fraction * double(values.size() - 1) + 0.5)];
}

}  // namespace

OrbitScript::OrbitScript(MainWindow& window, OrbitScriptOptions options, QObject* parent)
    : QObject(parent), window_(window), options_(std::move(options)), opening_(window) {
    hand_.setTimerType(Qt::PreciseTimer);
    hand_.setInterval(kHandIntervalMs);
    connect(&hand_, &QTimer::timeout, this, &OrbitScript::moveHand);
    deadline_.setSingleShot(true);
    deadline_.setInterval(int(options_.timeoutSeconds * 1000));
    connect(&deadline_, &QTimer::timeout, this, [this] {
        if (phase_ == Phase::resting) return endRest();  // what was measured in motion counts
        const QString what = phase_ == Phase::orbiting ? QStringLiteral("The picture did not follow the hand")
                                                       : QStringLiteral("No finished picture");
        tellError(QStringLiteral("%1 within %2 s.").arg(what).arg(options_.timeoutSeconds));
        finish(exitCodeOf(ErrorCode::deviceNotUsable));
    });
    connect(&window_, &MainWindow::frameShown, this, &OrbitScript::onFrame);
    connect(&window_, &MainWindow::failed, this, &OrbitScript::fail);
    connect(&window_.viewport(), &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        if (const auto* ready = std::get_if<live::DeviceReady>(&event))
            device_ = QString::fromStdString(ready->name);
    });
}

void OrbitScript::start() {
    if (!options_.screenshotFolder.isEmpty()) QDir().mkpath(options_.screenshotFolder);
    heartbeat_.start();
    opening_.start();
    deadline_.start();
}

void OrbitScript::onFrame(const live::FrameShown& frame) {
    switch (phase_) {
        case Phase::waiting:
            if (frame.stage == live::Stage::moving) break;
            phase_ = Phase::learning;
            QTimer::singleShot(int(options_.waitSeconds * 1000), this, &OrbitScript::beginOrbit);
            break;
        case Phase::orbiting:
            onFrameInMotion(frame);
            break;
        case Phase::resting:
            onFrameAtRest(frame);
            break;
        case Phase::learning:
        case Phase::reporting:
        case Phase::done:
            break;
    }
}

void OrbitScript::onFrameInMotion(const live::FrameShown& frame) {
    // A view that is shown once more is no new frame that follows the camera.
    if (frame.inputSequence == lastSequence_) return;
    lastSequence_ = frame.inputSequence;
    followed_.push_back({.atMs = double(orbiting_.nsecsElapsed()) / 1e6,
                         .latencyMs = frame.latencyMs,
                         .picture = frame.picture,
                         .width = frame.width,
                         .height = frame.height,
                         .scale = frame.scale,
                         .denoised = frame.denoised,
                         .foveaAgeMs = frame.foveaAgeMs});
    modelInMotion_ = frame.model;
}

void OrbitScript::onFrameAtRest(const live::FrameShown& frame) {
    const double now = double(resting_.nsecsElapsed()) / 1e6;
    if (atRest_ == live::OnScreen::preview)
        longestPreviewMs_ = std::max(longestPreviewMs_, now - atRestSinceMs_);
    if (frame.picture != atRest_) {
        atRest_ = frame.picture;
        atRestSinceMs_ = now;
    }
    const bool isTraced = frame.picture == live::OnScreen::fading || frame.picture == live::OnScreen::traced;
    const bool isSmooth = frame.denoised || !trace::isPathTraced(frame.look);
    if (firstTracedMs_ < 0.0 && isTraced && (isSmooth || frame.stage == live::Stage::converged))
        firstTracedMs_ = now;
    if (isTraced) samplesAtEnd_ = frame.samplesPerPixel;
    hasConverged_ = frame.stage == live::Stage::converged;
    // Later pictures at rest are taken by time.
    if (hasConverged_ && now > kRestShotsS[std::size(kRestShotsS) - 1] * 1000.0) endRest();
}

void OrbitScript::endRest() {
    if (phase_ != Phase::resting) return;
    phase_ = Phase::reporting;
    // The labels of the window are painted after this event.
    QTimer::singleShot(kPaintedAfterMs, this, [this] {
        takeScreenshot(hasConverged_ ? QStringLiteral("converged.png") : QStringLiteral("rest-end.png"));
        report();
    });
}

void OrbitScript::beginOrbit() {
    phase_ = Phase::orbiting;
    const VulkanWindow& target = window_.viewport().window();
    grip_ = QPointF(target.width() / 2.0, target.height() / 2.0);
    sendMouse(QEvent::MouseButtonPress, grip_, Qt::LeftButton, Qt::LeftButton);
    orbiting_.start();
    hand_.start();
}

void OrbitScript::moveHand() {
    const double seconds = double(orbiting_.nsecsElapsed()) / 1e9;
    // The script takes all its pictures, even where the window stood still for a while.
    if (seconds >= options_.seconds && followed_.size() >= kFollowedAtLeast &&
        nextMotionShot_ == std::size(kMotionShots)) {
        return endOrbit();
    }
    const double turns = seconds / options_.turnSeconds;
    const double sway = kSwayPixels * std::sin(2.0 * std::numbers::pi * kSwaysInTurn * turns);
    sendMouse(QEvent::MouseMove, grip_ + QPointF(kHandPixelsOfTurn * turns, sway), Qt::NoButton,
              Qt::LeftButton);
    if (nextMotionShot_ < std::size(kMotionShots) &&
        seconds >= kMotionShots[nextMotionShot_] * options_.seconds) {
        takeScreenshot(QStringLiteral("motion-%1.png").arg(++nextMotionShot_));
    }
}

void OrbitScript::endOrbit() {
    hand_.stop();
    orbitedSeconds_ = double(orbiting_.nsecsElapsed()) / 1e9;
    sendMouse(QEvent::MouseButtonRelease, grip_, Qt::LeftButton, Qt::NoButton);
    phase_ = Phase::resting;
    resting_.start();
    // What is on screen now is of the hand's last views.
    if (!followed_.empty()) atRest_ = followed_.back().picture;
    for (const double seconds : kRestShotsS) {
        QTimer::singleShot(int(seconds * 1000), this, [this, seconds] {
            if (phase_ == Phase::resting) takeScreenshot(QStringLiteral("rest-%1.png").arg(seconds));
        });
    }
    // A picture that has converged by then shows nothing new.
    QTimer::singleShot(int(kRestShotsS[std::size(kRestShotsS) - 1] * 1000) + kPaintedAfterMs, this, [this] {
        if (hasConverged_) endRest();
    });
    deadline_.start(int(options_.restSeconds * 1000));
}

void OrbitScript::sendMouse(QEvent::Type type, QPointF position, Qt::MouseButton button,
                            Qt::MouseButtons held) {
    VulkanWindow& target = window_.viewport().window();
    QMouseEvent event(type, position, target.mapToGlobal(position), button, held, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &event);
}

void OrbitScript::takeScreenshot(const QString& name) {
    if (options_.screenshotFolder.isEmpty()) return;
    const QString file = QDir(options_.screenshotFolder).filePath(name);
    screenshots_ << file;
    // From the screen: what a person sees, the native window included.
    const QImage picture = window_.screen()->grabWindow(window_.winId()).toImage();
    QThreadPool::globalInstance()->start([picture, file] {
        if (picture.isNull() || !picture.save(file)) ++failedScreenshots;
    });
}

void OrbitScript::report() {
    heartbeat_.stop();
    QThreadPool::globalInstance()->waitForDone();
    double longestGapMs = 0.0;
    double last = 0.0;
    int finest = 0;
    int coarsest = 0;
    int denoised = 0;
    int ofModel = 0;
    std::vector<double> latenciesMs;
    std::vector<double> foveaAgesMs;
    QJsonArray frames;
    for (const Followed& frame : followed_) {
        longestGapMs = std::max(longestGapMs, frame.atMs - last);
        last = frame.atMs;
        finest = finest == 0 ? frame.scale : std::min(finest, frame.scale);
        coarsest = std::max(coarsest, frame.scale);
        if (frame.denoised) ++denoised;
        if (frame.picture == live::OnScreen::model) ++ofModel;
        latenciesMs.push_back(frame.latencyMs);
        if (frame.foveaAgeMs) foveaAgesMs.push_back(*frame.foveaAgeMs);
        frames.append(QJsonObject{{"atMs", std::round(frame.atMs)},
                                  {"picture", QString::fromUtf8(nameOf(frame.picture).data())},
                                  {"width", frame.width},
                                  {"height", frame.height},
                                  {"latencyMs", std::round(10.0 * frame.latencyMs) / 10.0}});
    }
    const QSize size = window_.viewport().pictureSize();
    const QJsonObject json{
        {"device", device_},
        {"opening", opening_.toJson()},
        {"width", size.width()},
        {"height", size.height()},
        {"orbitSeconds", orbitedSeconds_},
        {"orbitFrames", qint64(followed_.size())},
        {"orbitFramesPerSecond", double(followed_.size()) / std::max(orbitedSeconds_, 1e-9)},
        {"orbitModelFrames", ofModel},
        {"orbitLongestGapMs", longestGapMs},
        {"orbitLatencyMedianMs", percentile(latenciesMs, 0.5)},
        {"orbitLatency95thMs", percentile(latenciesMs, 0.95)},
        {"orbitFoveaFrames", qint64(foveaAgesMs.size())},
        {"orbitFoveaAgeMedianMs", percentile(foveaAgesMs, 0.5)},
        {"orbitFoveaAge95thMs", percentile(foveaAgesMs, 0.95)},
        {"orbitScaleFinest", finest},
        {"orbitScaleCoarsest", coarsest},
        {"orbitDenoisedFrames", denoised},
        {"modelSplats", qint64(modelInMotion_.splats)},
        {"modelSteps", qint64(modelInMotion_.steps)},
        {"restFirstTracedMs", firstTracedMs_},
        {"restLongestPreviewMs", longestPreviewMs_},
        {"converged", hasConverged_},
        {"longestUiStallMs", heartbeat_.longestStallMs()},
        {"uiBeats", qint64(heartbeat_.beats())},
        {"samplesPerPixel", qint64(samplesAtEnd_)},
        {"screenshots", QJsonArray::fromStringList(screenshots_)},
        {"frames", frames},
    };
    std::fputs(QJsonDocument(json).toJson(QJsonDocument::Indented).constData(), stdout);
    std::fflush(stdout);
    finish(failedScreenshots == 0 ? kExitDone : exitCodeOf(ErrorCode::outputNotWritable));
}

void OrbitScript::fail(const Error& error) {
    finish(tellError(error));
}

void OrbitScript::finish(int exitCode) {
    if (phase_ == Phase::done) return;
    phase_ = Phase::done;
    hand_.stop();
    deadline_.stop();
    Q_EMIT finished(exitCode);
}

}  // namespace macula::viewer
