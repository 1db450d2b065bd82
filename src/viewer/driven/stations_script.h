// Takes a screenshot at each station of a day's work, for inspection and for the guide.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QJsonArray>
#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "viewer/driven/driven_hand.h"
#include "viewer/driven/driven_steps.h"

namespace macula::viewer {

struct StationsScriptOptions {
    QString folder;               // of the pictures; made if missing
    QString until;                // the last station; empty: all
    double waitSeconds = 30.0;    // at most, for a converged picture at each station with one
    double beginSeconds = 300.0;  // at most, for the first one
};

// The window fills the screen. Writes "FOLDER/NAME.png" for: open, studies, presets, transfer, clip,
// scissors, segments, measure, volume, save, movie, settings, settings-keys, keys; and beside and fusion, if
// the folder has another volume of the same patient. `finished` carries the exit code as in WorkdayScript;
// the names go to standard output as a JSON array.
class StationsScript : public QObject {
    Q_OBJECT

  public:
    StationsScript(MainWindow& window, StationsScriptOptions options, QObject* parent = nullptr);

    void start();  // before the window is shown and the study opened

  Q_SIGNALS:
    void finished(int exitCode);

  private:
    std::vector<DrivenStep> steps();
    void addPanels(std::vector<DrivenStep>& all);
    void addTools(std::vector<DrivenStep>& all);
    void addDialogs(std::vector<DrivenStep>& all);
    void addSecondVolume(std::vector<DrivenStep>& all);
    DrivenStep station(const char* name, std::function<void()> begin) const;
    DrivenStep between(std::function<void()> begin, std::function<bool()> isDone = {}) const;
    bool isAtRest() const;
    void closeDialogs();
    bool openSecond();
    void onEnded(const MeasuredStep& step);
    void takePicture(const QString& name);
    void end();
    void finish(int exitCode);

    MainWindow& window_;
    StationsScriptOptions options_;
    DrivenHand hand_;
    std::unique_ptr<DrivenSteps> steps_;
    bool isConverged_ = false;  // the picture on screen has converged
    bool hasPicture_ = false;
    bool hasSecond_ = false;
    QJsonArray names_;
    bool isDone_ = false;
};

}  // namespace macula::viewer
