// Phases in the window: slices and 3D play them, and show how values change over them.
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/volume.h"
#include "scene/slices/time_curve.h"
#include "study/open/phases.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/phases/phase_loader.h"

namespace macula::viewer {

class OpeningController;
class PhaseBar;
class PhasesIn3d;
class SliceView;

// The bar is visible while the open study is one of several phases. Playing changes slices, and if a person
// wants it 3D (PhasesIn3d): what is saved stays with the phase that is open, and the panes say which one they
// show. Slices may show a difference of two phases in its place. Lives on the UI thread.
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
    const PhasesIn3d& in3d() const { return *in3d_; }
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
    void showOnSlices(const std::shared_ptr<const study::OpenedStudy>& study, const QString& text);
    void setIn3d(bool on);
    void setReference(std::optional<std::size_t> phase);
    void askForDifference();
    void takeDifference(const Result<Volume>& difference);
    void showDifference();
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
    PhasesIn3d* in3d_;
    std::optional<std::size_t> reference_;  // slices show the difference to it; nothing: values
    // The last difference, of the phase and to the phase.
    struct Difference {
        std::size_t phase = 0;
        std::size_t reference = 0;
        std::shared_ptr<const study::OpenedStudy> study;
    };
    std::optional<Difference> difference_;
    std::size_t differenceOf_ = 0;  // the phase of the job
    std::optional<DisplayWindow>
        differenceWindow_;  // of all differences to one phase; nothing: not chosen yet
    BackgroundJob<Volume> subtraction_;
};

}  // namespace macula::viewer
