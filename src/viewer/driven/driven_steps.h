// Runs the steps of a scripted user one by one, and measures how long the user interface stalled in each.
#pragma once

#include <QElapsedTimer>
#include <QJsonArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <vector>

#include "viewer/driven/gauges.h"

namespace macula::viewer {

struct DrivenStep {
    QString name;
    std::function<void()> begin = {};   // empty: only waits
    std::function<bool()> isDone = {};  // polled every 20 ms; empty: done at once
    int patienceMs = 30'000;            // after that the step ends and counts as not done
    int restMs = 150;                   // after it is done, still measured as part of it
};

struct MeasuredStep {
    QString name;
    double lastedMs = 0.0;
    double longestStallMs = 0.0;
    double ownWorkInItMs = 0.0;  // UiHeartbeat
    bool isDone = true;
};

// Nothing is measured between two steps, so a slot of `ended` may take long. Lives on the UI thread.
class DrivenSteps : public QObject {
    Q_OBJECT

  public:
    explicit DrivenSteps(std::vector<DrivenStep> steps, QObject* parent = nullptr);

    void start();  // `finished` follows, once
    void stop();   // no signal follows
    const std::vector<MeasuredStep>& measured() const { return measured_; }

  Q_SIGNALS:
    void ended(const macula::viewer::MeasuredStep& step);
    void finished();

  private:
    void next();
    void poll();
    void end(bool isDone);

    std::vector<DrivenStep> steps_;
    std::size_t at_ = 0;
    bool isStopped_ = false;
    std::vector<MeasuredStep> measured_;
    UiHeartbeat heartbeat_;
    QElapsedTimer since_;
    QTimer polls_;
    qint64 doneAtMs_ = -1;
};

// The longest stall of all steps, 0 without steps; and a JSON array with an object for each step.
double longestStallMs(const std::vector<MeasuredStep>& steps);
QJsonArray toJson(const std::vector<MeasuredStep>& steps);

}  // namespace macula::viewer
