// A scripted user without rest: changes everything that a person can change, in quick turns.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "viewer/driven/gauges.h"

namespace macula::viewer {

struct ChangesScriptOptions {
    study::StudySource study;  // alternates with the phantom; nothing: only the phantom
    double seconds = 300.0;
    std::uint32_t seed = 1;
};

// Begins with the first picture of the study. Every 0.1 to 2 s, sometimes 12 s, it chooses another preset,
// clip, light or look, opens the other study, resizes the window, or drags. The seed determines all of it. At
// the end a JSON object goes to standard output: the count of each change, the pictures shown, the longest
// stall of the user interface, and the memory of the process after a fifth of the time and at the end, both
// with the phantom at rest. `finished` carries the exit code: 0; 3 or 4 after an error; 1 when no picture
// came for a minute.
class ChangesScript : public QObject {
    Q_OBJECT

  public:
    ChangesScript(MainWindow& window, ChangesScriptOptions options, QObject* parent = nullptr);

    void start();

  Q_SIGNALS:
    void finished(int exitCode);

  private:
    void onFrame(const live::FrameShown& frame);
    void change();
    void drag();
    void goHome(std::function<void()> then);
    void chooseIn(const char* accessibleName);
    void trigger(const char* prefix);
    void report();
    void finish(int exitCode);
    int below(int count);

    MainWindow& window_;
    ChangesScriptOptions options_;
    std::mt19937 random_;
    QTimer next_;
    QTimer hand_;
    QTimer silence_;
    QElapsedTimer running_;
    bool hasBegun_ = false;
    bool isDone_ = false;
    bool isPhantom_ = false;
    QPointF at_;
    int dragsLeft_ = 0;
    std::map<std::string, std::int64_t> changes_;
    std::map<std::string, std::int64_t> pictures_;
    UiHeartbeat heartbeat_;
    bool isReadEarly_ = false;
    double residentMiBEarly_ = 0.0;
};

}  // namespace macula::viewer
