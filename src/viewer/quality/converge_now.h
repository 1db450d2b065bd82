// Traces the picture at rest until its noise is far below what can be seen.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>

#include "live/frame/frame_input.h"
#include "live/frame/render_events.h"
#include "viewer/viewport/rest_goal.h"

namespace macula::viewer {

// Runs from start() until the picture is final, cancel(), or another picture is wanted. Draws nothing: the
// viewport's owner connects it. Lives on the UI thread.
class ConvergeNow : public QObject {
    Q_OBJECT

  public:
    // Half the usual noise target, which takes four times the samples; and the most samples.
    static constexpr double kNoiseTarget = 0.5 * live::kUnseenNoise;
    static constexpr std::uint32_t kSampleLimit = 1u << 16;

    // `usual` is the goal while it does not run. `nowS`: a clock, in seconds.
    explicit ConvergeNow(const RestGoal& usual, QObject* parent = nullptr, std::function<double()> nowS = {});

    void start();
    void cancel();
    bool running() const { return isRunning_; }

    void onFrame(const live::FrameShown& frame);
    // Call when another picture is wanted; ends the run.
    void onOtherPicture();

  Q_SIGNALS:
    void goalChanged(const macula::viewer::RestGoal& goal);
    void began();
    void progressed(const QString& stage, double fraction);
    void ended(const QString& told);  // a sentence; empty after cancel()

  private:
    void end(const QString& told);
    QString stageOf(double noise, double fraction) const;

    RestGoal usual_;
    std::function<double()> nowS_;
    bool isRunning_ = false;
    double startedS_ = 0.0;
    double startedAt_ = -1.0;  // the first known fraction; below 0: none yet
};

}  // namespace macula::viewer
