// A hand made of code: orbits, takes screenshots, and measures how well the picture followed.
#pragma once

#include "viewer/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <vector>

#include "viewer/ui_heartbeat.h"

namespace macula::viewer {

struct OrbitScriptOptions {
    QString screenshotFolder;  // empty: none are taken
    double seconds = 8.0;      // of orbiting; longer where the picture has hardly followed by then
    double timeoutSeconds = 300.0;
};

// Begins when the first full picture of the study is there, ends when the picture has converged. The drag
// goes through the event system into the native window, as that of a mouse does. At the end a JSON object
// goes to standard output, and `finished` carries the exit code: 0; 3 when the study could not be opened; 4
// when the device could not be used; 1 when no picture came in time or a screenshot could not be written.
class OrbitScript : public QObject {
    Q_OBJECT

  public:
    OrbitScript(MainWindow& window, OrbitScriptOptions options, QObject* parent = nullptr);

    void start();  // before the window is shown, so that showing it is measured too

  signals:
    void finished(int exitCode);

  private:
    enum class Phase { waiting, orbiting, converging, reporting, done };

    void onFrame(const FrameShown& frame);
    void beginOrbit();
    void moveHand();
    void endOrbit();
    void takeScreenshot(const QString& name);
    void report();
    void fail(const Error& error);
    void finish(int exitCode);
    void sendMouse(QEvent::Type type, QPointF position, Qt::MouseButton button, Qt::MouseButtons held);

    MainWindow& window_;
    OrbitScriptOptions options_;
    UiHeartbeat heartbeat_;
    QTimer hand_;
    QTimer deadline_;
    Phase phase_ = Phase::waiting;
    QElapsedTimer orbiting_;
    QPointF grip_;
    double orbitedSeconds_ = 0.0;

    std::vector<double> shownAtMs_;  // since the orbit began
    std::vector<double> latenciesMs_;
    std::vector<int> scales_;
    int denoised_ = 0;  // of the pictures in motion
    std::uint64_t lastSequence_ = 0;
    std::uint64_t samplesAtEnd_ = 0;
    QString device_;
    QStringList screenshots_;
    std::size_t nextMotionShot_ = 0;
};

}  // namespace macula::viewer
