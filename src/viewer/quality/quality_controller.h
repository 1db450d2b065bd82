// The quality of frames in motion, and the tracing of the picture at rest until it is final.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "live/frame/frame_input.h"
#include "live/frame/render_events.h"
#include "live/quality/calibration.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/viewport/rest_goal.h"

class QAction;
class QMenu;

namespace macula::viewer {

class QualityControl;
class WorkBar;

// Traces the picture at rest until its noise is far below what can be seen. Runs from start() until the
// picture is final, cancel(), or another picture is wanted. Draws nothing: the viewport's owner connects it.
// Lives on the UI thread.
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

// Lives on the UI thread.
class QualityController : public QObject {
    Q_OBJECT

  public:
    QualityController(const WindowContext& context, std::uint32_t sampleLimit);

    QualityControl& control() const { return *control_; }  // the slider
    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& view);

    // Measures this machine's speed once, in the background. `folder` keeps the result; nothing: it is not
    // kept.
    void calibrate(const std::optional<std::filesystem::path>& folder);
    void showCost();  // shows the cost of frames in motion in this window
    void onFrame(const live::FrameShown& frame);

  private:
    void connectConverging();
    void convergeNow();
    void onCalibrated(const Result<live::Calibration>& measured);

    WindowContext context_;
    QualityControl* control_;
    BackgroundJob<live::Calibration> calibration_;
    ConvergeNow* converge_;
    WorkBar* bar_;
    QAction* stop_ = nullptr;  // ends the tracing
};

}  // namespace macula::viewer
