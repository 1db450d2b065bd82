// Measures how soon after the start of the program a study can be seen.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QString>

namespace macula::viewer {

// Listens to the window and notes when each event of toJson() first occurred.
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

}  // namespace macula::viewer
