// How soon a study can be looked at, after the program has begun.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QString>

namespace macula::viewer {

// Listens to the window, and notes when each of these came first.
class OpeningTimes : public QObject {
    Q_OBJECT

  public:
    explicit OpeningTimes(MainWindow& window, QObject* parent = nullptr);

    void start() { clock_.start(); }  // before the window is shown
    // Milliseconds since then, -1 for what has not come: "windowMs", "studyReadMs" (decoded), "sliceMs",
    // "pictureMs" (any of the volume), "modelMs" (splats fit to be shown), and how that model came
    // ("modelOrigin"). "renderThread" is where its time went until then, or until now (times_report.h).
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
