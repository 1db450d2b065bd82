// A scripted user that orbits, takes screenshots, and measures how well the picture followed.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <optional>
#include <vector>

#include "viewer/driven/gauges.h"

namespace macula::viewer {

struct OrbitScriptOptions {
    QString screenshotFolder;    // empty: no screenshots
    double waitSeconds = 0.0;    // before the orbit, while the model learns
    double turnSeconds = 8.0;    // once around the patient
    double seconds = 8.0;        // of orbiting; longer if few pictures have followed by then
    double restSeconds = 300.0;  // after the orbit, at most
    double timeoutSeconds = 300.0;
};

// Begins waitSeconds after the first full picture of the study, and ends when the picture has converged or
// restSeconds are over. The drag goes through the event system into the native window, as a mouse drag does.
// At the end a JSON object goes to standard output: the opening times, each picture in motion (its kind, its
// size, when it was on screen and how long after the input), and how soon it was sharp again (-1: not within
// restSeconds). `finished` carries the exit code: 0; 3 when the study could not be opened; 4 when the device
// could not be used; 1 when no picture came in time or a screenshot could not be written.
class OrbitScript : public QObject {
    Q_OBJECT

  public:
    OrbitScript(MainWindow& window, OrbitScriptOptions options, QObject* parent = nullptr);

    void start();  // before the window is shown, so that showing it is measured too

  Q_SIGNALS:
    void finished(int exitCode);

  private:
    enum class Phase { waiting, learning, orbiting, resting, reporting, done };

    void onFrame(const live::FrameShown& frame);
    void onFrameInMotion(const live::FrameShown& frame);
    void onFrameAtRest(const live::FrameShown& frame);
    void beginOrbit();
    void moveHand();
    void endOrbit();
    void endRest();
    void takeScreenshot(const QString& name);
    void report();
    void fail(const Error& error);
    void finish(int exitCode);
    void sendMouse(QEvent::Type type, QPointF position, Qt::MouseButton button, Qt::MouseButtons held);

    MainWindow& window_;
    OrbitScriptOptions options_;
    UiHeartbeat heartbeat_;
    OpeningTimes opening_;
    QTimer hand_;
    QTimer deadline_;
    Phase phase_ = Phase::waiting;
    QElapsedTimer orbiting_;
    QPointF grip_;
    double orbitedSeconds_ = 0.0;

    struct Followed {
        double atMs = 0.0;  // since the orbit began
        double latencyMs = 0.0;
        live::OnScreen picture = live::OnScreen::nothing;
        int width = 0;
        int height = 0;
        int scale = 1;
        bool denoised = false;
        std::optional<double> foveaAgeMs;
    };
    std::vector<Followed> followed_;
    QElapsedTimer resting_;
    live::OnScreen atRest_ = live::OnScreen::nothing;  // on screen since atRestSinceMs_
    double atRestSinceMs_ = 0.0;
    double longestPreviewMs_ = 0.0;  // a reduced picture, after the hand stopped
    double firstTracedMs_ = -1.0;    // from then until a denoised picture with all pixels
    bool hasConverged_ = false;
    hybrid::ModelNews modelInMotion_{};
    std::uint64_t lastSequence_ = 0;
    std::uint64_t samplesAtEnd_ = 0;
    QString device_;
    QStringList screenshots_;
    std::size_t nextMotionShot_ = 0;
};

}  // namespace macula::viewer
