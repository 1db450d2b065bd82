// What a hand made of code does, one thing after the other, and how long the user interface was deaf in each.
#pragma once

#include <QElapsedTimer>
#include <QJsonArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <vector>

#include "viewer/driven/ui_heartbeat.h"

namespace macula::viewer {

struct DrivenStep {
    QString name;
    std::function<void()> begin = {};   // empty: nothing but waiting
    std::function<bool()> isDone = {};  // asked again and again; empty: at once
    int patienceMs = 30'000;            // then it goes on, and the step counts as not done
    int restMs = 150;                   // after it is done: what it set going is counted in it
};

struct MeasuredStep {
    QString name;
    double lastedMs = 0.0;
    double longestStallMs = 0.0;
    double ownWorkInItMs = 0.0;  // UiHeartbeat
    bool isDone = true;
};

// Nothing is measured between two steps: who listens to `ended` may take its time. Lives on the UI thread.
class DrivenSteps : public QObject {
    Q_OBJECT

  public:
    explicit DrivenSteps(std::vector<DrivenStep> steps, QObject* parent = nullptr);

    void start();  // `finished` follows, once
    void stop();   // nothing follows
    const std::vector<MeasuredStep>& measured() const { return measured_; }

  signals:
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

// The longest of all, 0 of none; and an array of { "step", "ms", "longestUiStallMs", "done" }.
double longestStallMs(const std::vector<MeasuredStep>& steps);
QJsonArray toJson(const std::vector<MeasuredStep>& steps);

}  // namespace macula::viewer
