// The picture at rest, traced until its noise is far below what can be seen.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>

#include "live/frame/frame_input.h"
#include "live/frame/render_events.h"

namespace macula::viewer {

// What counts as converged, and whether the model waits for it.
struct RestGoal {
    std::uint32_t sampleLimit = 512;
    double noiseTarget = app::kUnseenNoise;
    bool convergesNow = false;

    bool operator==(const RestGoal&) const = default;
};

// From the word to start until the picture is final, somebody stops it, or another picture is wanted. Draws
// nothing: who has the viewport connects it. Lives on the UI thread.
class ConvergeNow : public QObject {
    Q_OBJECT

  public:
    // Half of the noise that a picture is left at by itself: four times its samples. So many at most.
    static constexpr double kNoiseTarget = 0.5 * app::kUnseenNoise;
    static constexpr std::uint32_t kSampleLimit = 1u << 16;

    // `usual` is what counts as converged otherwise. `nowS`: a clock, in seconds.
    explicit ConvergeNow(const RestGoal& usual, QObject* parent = nullptr, std::function<double()> nowS = {});

    void start();
    void cancel();
    bool running() const { return isRunning_; }

    void onFrame(const app::FrameShown& frame);
    // Another picture is wanted from now on.
    void onOtherPicture();

  signals:
    void goalChanged(const macula::viewer::RestGoal& goal);
    void began();
    void progressed(const QString& stage, double fraction);
    void ended(const QString& told);  // a sentence; empty when somebody stopped it

  private:
    void end(const QString& told);
    QString stageOf(double noise, double fraction) const;

    RestGoal usual_;
    std::function<double()> nowS_;
    bool isRunning_ = false;
    double startedS_ = 0.0;
    double startedAt_ = -1.0;  // the first fraction that was known; below 0: none yet
};

}  // namespace macula::viewer
