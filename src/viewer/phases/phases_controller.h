// Phases in the window: slices play them, and show how values in an ellipse change over them.
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "scene/slices/time_curve.h"
#include "study/open/phases.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/phases/phase_loader.h"

namespace macula::viewer {

class OpeningController;
class PhaseBar;
class SliceView;

// The bar is visible while the open study is one of several phases. Playing changes slices alone: 3D and what
// a person measures stay with the phase that is open, and the panes say which one they show. Lives on the UI
// thread.
class PhasesController : public QObject {
    Q_OBJECT

  public:
    // `opening` lives until the window's destructor.
    PhasesController(const WindowContext& context, OpeningController& opening,
                     std::array<SliceView*, 3> panes);

    PhaseBar& bar() const { return *bar_; }
    std::size_t shown() const { return shown_; }  // the phase on slices
    bool isPlaying() const { return clock_.isActive(); }
    const PhaseLoader& loader() const { return loader_; }
    void setImagesShown(bool shown);  // images that are no volume hide the slices

  Q_SIGNALS:
    // Slices show that phase, and its text; null: the open study.
    void shownOnSlices(std::shared_ptr<const macula::study::OpenedStudy> phase, const QString& text);

  private:
    void onStudyShown();
    void setPlaying(bool plays);
    void step();
    void show(std::size_t phase);
    void showIfLoaded();
    void showNote();
    QString textOf(std::size_t phase) const;
    void openShown();
    void askForCurve();
    void showCurve(const Result<scene::TimeCurves>& curves);

    WindowContext context_;
    OpeningController& opening_;
    std::array<SliceView*, 3> panes_;
    PhaseBar* bar_;
    PhaseLoader loader_;
    std::vector<study::Phase> phases_;
    std::size_t open_ = 0;   // the phase of the open study
    std::size_t shown_ = 0;  // on slices, as soon as it is decoded
    QTimer clock_;
    bool wantsCurve_ = false;  // as soon as all phases are decoded
    BackgroundJob<scene::TimeCurves> curve_;
};

}  // namespace macula::viewer
