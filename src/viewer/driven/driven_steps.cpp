#include "viewer/driven/driven_steps.h"

#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::viewer {

namespace {

constexpr int kPollEveryMs = 20;

double rounded(double ms) {
    return std::round(10.0 * ms) / 10.0;
}

}  // namespace

DrivenSteps::DrivenSteps(std::vector<DrivenStep> steps, QObject* parent)
    : QObject(parent), steps_(std::move(steps)) {
    polls_.setInterval(kPollEveryMs);
    connect(&polls_, &QTimer::timeout, this, &DrivenSteps::poll);
}

void DrivenSteps::start() {
    at_ = 0;
    isStopped_ = false;
    measured_.clear();
    next();
}

void DrivenSteps::stop() {
    isStopped_ = true;
    polls_.stop();
    heartbeat_.stop();
}

void DrivenSteps::next() {
    if (isStopped_) return;
    if (at_ >= steps_.size()) return Q_EMIT finished();
    doneAtMs_ = -1;
    heartbeat_.start();
    since_.start();
    if (steps_[at_].begin) steps_[at_].begin();
    if (!isStopped_) polls_.start();
}

void DrivenSteps::poll() {
    const DrivenStep& step = steps_[at_];
    if (doneAtMs_ < 0) {
        if (!step.isDone || step.isDone()) {
            doneAtMs_ = since_.elapsed();
        } else if (since_.elapsed() >= step.patienceMs) {
            return end(false);
        } else {
            return;
        }
    }
    if (since_.elapsed() - doneAtMs_ >= step.restMs) end(true);
}

void DrivenSteps::end(bool isDone) {
    polls_.stop();
    heartbeat_.stop();
    MeasuredStep measured;
    measured.name = steps_[at_].name;
    measured.lastedMs = double(since_.nsecsElapsed()) / 1e6;
    measured.longestStallMs = heartbeat_.longestStallMs();
    measured.ownWorkInItMs = heartbeat_.ownWorkInItMs();
    measured.isDone = isDone;
    measured_.push_back(measured);
    Q_EMIT ended(measured);
    ++at_;
    QTimer::singleShot(0, this, &DrivenSteps::next);
}

double longestStallMs(const std::vector<MeasuredStep>& steps) {
    double longest = 0.0;
    for (const MeasuredStep& step : steps) longest = std::max(longest, step.longestStallMs);
    return longest;
}

QJsonArray toJson(const std::vector<MeasuredStep>& steps) {
    QJsonArray array;
    for (const MeasuredStep& step : steps)
        array.append(QJsonObject{{"step", step.name},
                                 {"ms", rounded(step.lastedMs)},
                                 {"longestUiStallMs", rounded(step.longestStallMs)},
                                 {"ownWorkInItMs", rounded(step.ownWorkInItMs)},
                                 {"done", step.isDone}});
    return array;
}

}  // namespace macula::viewer
