// The quality of frames in motion, and the tracing of the picture at rest until it is final.
#pragma once

#include <QObject>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "live/frame/render_events.h"
#include "live/quality/calibration.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class ConvergeNow;
class QualityControl;
class WorkBar;

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
