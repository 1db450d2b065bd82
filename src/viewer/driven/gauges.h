// Measures the window: how soon a study is seen, how long the event loop is blocked, and how well the picture
// follows a hand.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <vector>

namespace macula::viewer {

// How long the event loop was blocked. A timer on the UI thread fires every 5 ms; when it is late, other work
// held up the event loop, and clicks would have waited as long.
class UiHeartbeat : public QObject {
    Q_OBJECT

  public:
    explicit UiHeartbeat(QObject* parent = nullptr);

    void start();
    void stop();
    // The longest hold-up since start(), beyond the interval itself.
    double longestStallMs() const { return longestMs_; }
    // The processor time of this thread in that hold-up; for the rest of it the thread waited, for a core or
    // for something else. 0 on systems other than Linux.
    double ownWorkInItMs() const { return ownWorkInItMs_; }
    // How often a hold-up was longer than a person notices.
    static constexpr double kNoticedMs = 50.0;
    long noticed() const { return noticed_; }
    long beats() const { return beats_; }

  private:
    void beat();

    QTimer timer_;
    QElapsedTimer sinceLast_;
    double longestMs_ = 0.0;
    double ownWorkInItMs_ = 0.0;
    double ownWorkMs_ = 0.0;  // processor time of this thread at the last beat
    long noticed_ = 0;
    long beats_ = 0;
};

// How soon after the start of the program a study can be seen. Listens to the window and notes when each
// event of toJson() first occurred.
class OpeningTimes : public QObject {
    Q_OBJECT

  public:
    explicit OpeningTimes(MainWindow& window, QObject* parent = nullptr);

    void start() { clock_.start(); }  // before the window is shown
    // Milliseconds since start(), -1 for an event that has not occurred: "windowMs", "studyReadMs" (decoded),
    // "sliceMs", "pictureMs" (of the volume), "modelMs" (splats fit to be shown), and its origin
    // ("modelOrigin"). "renderThread": its stages until modelMs, or until now (times_report.h).
    QJsonObject toJson() const;

  private:
    void note(double& ms) const;
    void noteModel(const hybrid::ModelNews& model);

    QElapsedTimer clock_;
    double windowMs_ = -1.0;
    double studyReadMs_ = -1.0;
    double sliceMs_ = -1.0;
    double pictureMs_ = -1.0;
    double modelMs_ = -1.0;
    QString modelOrigin_;
    std::vector<StageTimes> spent_;
};

// How well the picture follows while a hand turns the volume.
class OrbitGauge : public QObject {
    Q_OBJECT

  public:
    explicit OrbitGauge(MainWindow& window, QObject* parent = nullptr);

    void begin();
    void end();
    double framesPerSecond() const;  // 0 before it has ended
    // "width" and "height" of the picture, "seconds", "frames", "framesPerSecond", "modelFrames" (of splats,
    // with all pixels), "latencyMedianMs", "latency95thMs".
    QJsonObject toJson() const;

  private:
    void onFrame(const live::FrameShown& frame);

    MainWindow& window_;
    bool isRunning_ = false;
    QElapsedTimer since_;
    double seconds_ = 0.0;
    std::uint64_t lastInput_ = 0;
    std::size_t ofModel_ = 0;
    QSize size_;
    std::vector<double> latenciesMs_;
};

}  // namespace macula::viewer
