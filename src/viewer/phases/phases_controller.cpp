#include "viewer/phases/phases_controller.h"

#include <QMainWindow>
#include <algorithm>
#include <utility>

#include "study/open/found_volumes.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/phases/phase_bar.h"
#include "viewer/phases/time_curve_dialog.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

PhasesController::PhasesController(const WindowContext& context, OpeningController& opening,
                                   std::array<SliceView*, 3> panes)
    : QObject(&context.window),
      context_(context),
      opening_(opening),
      panes_(panes),
      bar_(new PhaseBar(&context.window)),
      curve_(this, {.ended = [this](const Result<scene::TimeCurves>& curves) { showCurve(curves); }}) {
    clock_.setTimerType(Qt::PreciseTimer);
    connect(&clock_, &QTimer::timeout, this, &PhasesController::step);
    connect(bar_, &PhaseBar::playToggled, this, &PhasesController::setPlaying);
    connect(bar_, &PhaseBar::phaseChosen, this, [this](int phase) {
        setPlaying(false);
        show(std::size_t(phase));
    });
    connect(bar_, &PhaseBar::openAsked, this, &PhasesController::openShown);
    connect(bar_, &PhaseBar::curveAsked, this, &PhasesController::askForCurve);
    connect(&loader_, &PhaseLoader::loaded, this, [this](std::size_t phase) {
        if (phase == shown_) showIfLoaded();
        showNote();
        if (wantsCurve_ && loader_.whyNotAll()) wantsCurve_ = false;
        if (wantsCurve_ && loader_.hasAll()) askForCurve();
    });
    connect(&loader_, &PhaseLoader::failed, this, [this](std::size_t phase, const Error& error) {
        setPlaying(false);
        wantsCurve_ = false;
        if (phase == shown_) show(open_);
        context_.notifications.showError(error);
    });
    // Follows the panes, which drop the phase of the study before.
    connect(&context_.session, &StudyEditor::studyShown, this, &PhasesController::onStudyShown);
}

void PhasesController::onStudyShown() {
    setPlaying(false);
    wantsCurve_ = false;
    curve_.cancel();
    phases_.clear();
    const study::OpenedStudy& study = context_.session.study();
    if (context_.session.hasStudy()) phases_ = study::phasesOf(study);
    bar_->setPhases(int(phases_.size()));
    if (phases_.empty()) return loader_.setPhases({}, {});
    std::vector<std::size_t> volumes;
    for (const study::Phase& phase : phases_) volumes.push_back(phase.volume);
    open_ = std::size_t(std::ranges::find(volumes, study.volumeIndex) - volumes.begin());
    loader_.setPhases(study::phaseSourceOf(study), std::move(volumes));
    loader_.keepOpen(open_, std::make_shared<const study::OpenedStudy>(study));
    show(open_);
}

QString PhasesController::textOf(std::size_t phase) const {
    return tr("Phase %1 of %2, %3")
        .arg(phase + 1)
        .arg(phases_.size())
        .arg(harmless(inWindowsLanguage(phases_[phase].label)));
}

void PhasesController::show(std::size_t phase) {
    if (phase >= phases_.size()) return;
    shown_ = phase;
    const bool isThere = phase == open_ || loader_.phase(phase);
    bar_->setShown(int(phase), isThere ? textOf(phase) : tr("%1 is being decoded").arg(textOf(phase)));
    bar_->setCanOpen(phase != open_);
    showIfLoaded();
    // The other phases are decoded once a person asks for one: many never do.
    if (phase != open_ || isPlaying()) loader_.ask(phase);
    showNote();
}

// Slices keep what they show until another phase is decoded; the bar says so.
void PhasesController::showIfLoaded() {
    const auto study = shown_ == open_ ? nullptr : loader_.phase(shown_);
    if (shown_ != open_ && !study) return;
    QString text = textOf(shown_);
    bar_->setShown(int(shown_), text);
    if (study) text = tr("%1; 3D and saved values: phase %2").arg(text, QString::number(open_ + 1));
    for (SliceView* pane : panes_) pane->setPhase(study, text);
    Q_EMIT shownOnSlices(study, text);
}

void PhasesController::showNote() {
    if (!loader_.fits()) return bar_->setNote(tr("Memory is not enough for all phases"));
    const bool isLoading = (isPlaying() || wantsCurve_ || shown_ != open_) && !loader_.hasAll();
    bar_->setNote(isLoading ? tr("%1 of %2 decoded").arg(loader_.loadedCount()).arg(loader_.count())
                            : QString());
}

void PhasesController::setPlaying(bool plays) {
    if (plays && !phases_.empty()) {
        clock_.start(int(1000.0 / bar_->perSecond()));
        loader_.ask(shown_);
    } else {
        clock_.stop();
    }
    bar_->setPlaying(isPlaying());
    showNote();
}

// Waits for a phase that is not decoded, or whose slices are not on screen yet: none is left out.
void PhasesController::step() {
    const int ms = int(1000.0 / bar_->perSecond());
    if (clock_.interval() != ms) clock_.setInterval(ms);
    const bool areSeen = std::ranges::all_of(
        panes_, [](const SliceView* pane) { return !pane->isVisible() || pane->isUpToDate(); });
    const std::size_t next = (shown_ + 1) % phases_.size();
    if (!loader_.phase(next)) return loader_.ask(next);
    if (areSeen) show(next);
}

void PhasesController::setImagesShown(bool shown) {
    if (shown) setPlaying(false);
    bar_->setPhases(shown ? 0 : int(phases_.size()));
}

void PhasesController::openShown() {
    if (shown_ >= phases_.size() || shown_ == open_) return;
    opening_.openPhase(study::phaseSourceOf(context_.session.study()), phases_[shown_].volume);
}

void PhasesController::askForCurve() {
    if (const std::optional<Error> why = loader_.whyNotAll(); why && !loader_.hasAll())
        return context_.notifications.showError(*why);
    wantsCurve_ = !loader_.hasAll();
    if (wantsCurve_) {
        loader_.ask(shown_);
        return showNote();
    }
    showNote();
    std::vector<std::shared_ptr<const study::OpenedStudy>> studies;
    for (std::size_t phase = 0; phase < phases_.size(); ++phase) studies.push_back(loader_.phase(phase));
    curve_.start([measurements = context_.session.state().measurements, phases = phases_,
                  studies = std::move(studies)](Progress& progress) {
        return scene::timeCurves(measurements, phases, studies, progress.token());
    });
}

void PhasesController::showCurve(const Result<scene::TimeCurves>& curves) {
    if (curves) {
        (new TimeCurveDialog(*curves, context_))->open();
    } else if (curves.error().code != ErrorCode::cancelled) {
        context_.notifications.showError(curves.error());
    }
}

}  // namespace macula::viewer
