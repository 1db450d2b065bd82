#include "viewer/phases/phases_in_3d.h"  // before Qt, see vulkan_window.h

#include "viewer/phases/phases_controller.h"

#include <QMainWindow>
#include <algorithm>
#include <utility>

#include "slices/difference.h"
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
      curve_(this, {.ended = [this](const Result<scene::TimeCurves>& curves) { showCurve(curves); }}),
      in3d_(new PhasesIn3d(context, loader_, this)),
      subtraction_(this, {.ended = [this](const Result<Volume>& volume) { takeDifference(volume); }}) {
    clock_.setTimerType(Qt::PreciseTimer);
    connect(&clock_, &QTimer::timeout, this, &PhasesController::step);
    connect(bar_, &PhaseBar::playToggled, this, &PhasesController::setPlaying);
    connect(bar_, &PhaseBar::phaseChosen, this, [this](int phase) {
        setPlaying(false);
        show(std::size_t(phase));
    });
    connect(bar_, &PhaseBar::openAsked, this, &PhasesController::openShown);
    connect(bar_, &PhaseBar::curveAsked, this, &PhasesController::askForCurve);
    connect(bar_, &PhaseBar::in3dToggled, this, &PhasesController::setIn3d);
    connect(bar_, &PhaseBar::learningToggled, in3d_, &PhasesIn3d::setLearning);
    connect(in3d_, &PhasesIn3d::noteChanged, this, [this] { bar_->setNoteOn3d(in3d_->note()); });
    connect(bar_, &PhaseBar::referenceChosen, this, [this](int phase) {
        setReference(phase < 0 ? std::nullopt : std::optional(std::size_t(phase)));
    });
    connect(bar_, &PhaseBar::reachChosen, this, [this](double reach) {
        if (differenceWindow_) differenceWindow_->width = 2.0 * reach;
        showDifference();
    });
    connect(&loader_, &PhaseLoader::loaded, this, [this](std::size_t phase) {
        if (phase == shown_ || phase == reference_) showIfLoaded();
        in3d_->loadedMore();
        showNote();
        if (wantsCurve_ && loader_.whyNotAll()) wantsCurve_ = false;
        if (wantsCurve_ && loader_.hasAll()) askForCurve();
    });
    connect(&loader_, &PhaseLoader::failed, this, [this](std::size_t phase, const Error& error) {
        setPlaying(false);
        wantsCurve_ = false;
        if (phase == reference_) setReference(std::nullopt);
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
    subtraction_.cancel();
    reference_.reset();
    difference_.reset();
    differenceWindow_.reset();
    phases_.clear();
    const study::OpenedStudy& study = context_.session.study();
    if (context_.session.hasStudy()) phases_ = study::phasesOf(study);
    bar_->setPhases(int(phases_.size()));
    bar_->setReference(-1);
    if (phases_.empty()) {
        in3d_->begin(0, 0);
        bar_->setIn3d(false);
        bar_->setNoteOn3d({});
        return loader_.setPhases({}, {});
    }
    std::vector<std::size_t> volumes;
    for (const study::Phase& phase : phases_) volumes.push_back(phase.volume);
    open_ = std::size_t(std::ranges::find(volumes, study.volumeIndex) - volumes.begin());
    study::PhaseSource source = study::phaseSourceOf(study);
    const bool isSameStudy = loader_.isOf(source);
    loader_.setPhases(std::move(source), std::move(volumes));
    loader_.keepOpen(open_, std::make_shared<const study::OpenedStudy>(study));
    const bool wasOn = in3d_->isOn() && isSameStudy;
    in3d_->begin(phases_.size(), open_);
    bar_->setIn3d(false);
    bar_->setNoteOn3d({});
    show(open_);
    // Once 3D has the study.
    if (wasOn) QTimer::singleShot(0, this, [this] { setIn3d(true); });
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
    const QString text = textOf(shown_);
    bar_->setShown(int(shown_), text);
    in3d_->show(shown_, study, text);
    if (reference_) askForDifference();
    if (!reference_) showOnSlices(study, text);
}

void PhasesController::showOnSlices(const std::shared_ptr<const study::OpenedStudy>& study,
                                    const QString& text) {
    QString all = text;
    if (study && in3d_->isOn())
        all = tr("%1; saved values: phase %2").arg(text, QString::number(open_ + 1));
    else if (study)
        all = tr("%1; 3D and saved values: phase %2").arg(text, QString::number(open_ + 1));
    for (SliceView* pane : panes_) pane->setPhase(study, all);
    Q_EMIT shownOnSlices(study, all);
}

// 3D shows volumes that are decoded, and learns from all of them.
void PhasesController::setIn3d(bool on) {
    if (phases_.empty()) return;
    in3d_->setOn(on);
    bar_->setIn3d(on);
    if (on) loader_.ask(shown_);
    show(shown_);
}

void PhasesController::setReference(std::optional<std::size_t> phase) {
    if (phase && *phase >= phases_.size()) return;
    reference_ = phase;
    differenceWindow_.reset();
    subtraction_.cancel();
    bar_->setReference(phase ? int(*phase) : -1);
    if (phase) loader_.ask(loader_.phase(*phase) ? shown_ : *phase);
    showIfLoaded();
    showNote();
}

// Slices keep what they show until the difference is there.
void PhasesController::askForDifference() {
    if (difference_ && difference_->phase == shown_ && difference_->reference == *reference_)
        return showDifference();
    const auto of = loader_.phase(shown_);
    const auto minus = loader_.phase(*reference_);
    if (!of || !minus) return loader_.ask(of ? *reference_ : shown_);
    differenceOf_ = shown_;
    subtraction_.start([of, minus](Progress& progress) {
        return slices::differenceOf(*of->measured(), *minus->measured(), progress.token());
    });
}

void PhasesController::takeDifference(const Result<Volume>& difference) {
    if (!reference_) return;
    if (!difference) {
        if (difference.error().code == ErrorCode::cancelled) return;
        setPlaying(false);
        setReference(std::nullopt);
        return context_.notifications.showError(difference.error());
    }
    const auto of = loader_.phase(differenceOf_);
    if (!of || differenceOf_ != shown_) return;
    study::OpenedStudy study = *of;
    study.inFloats = std::make_shared<const Volume>(*difference);
    difference_ = {.phase = differenceOf_,
                   .reference = *reference_,
                   .study = std::make_shared<const study::OpenedStudy>(std::move(study))};
    showDifference();
}

// The window is that of the first difference that is not 0 everywhere: while phases play, one colour means
// one difference.
void PhasesController::showDifference() {
    if (!reference_ || !difference_ || difference_->phase != shown_ || difference_->reference != *reference_)
        return;
    const Volume& volume = *difference_->study->inFloats;
    if (!differenceWindow_) {
        const DisplayWindow usual = slices::symmetricWindow(volume);
        bar_->setReach(0.5 * usual.width, harmless(inWindowsLanguage(unitText(volume.unitName()))));
        if (shown_ != *reference_) differenceWindow_ = usual;
    }
    const QString text = tr("Difference of values: phase %1 − phase %2 (of %3); saved values: phase %4")
                             .arg(shown_ + 1)
                             .arg(*reference_ + 1)
                             .arg(phases_.size())
                             .arg(open_ + 1);
    for (SliceView* pane : panes_)
        pane->setPhase(difference_->study, text, differenceWindow_.value_or(slices::symmetricWindow(volume)));
    Q_EMIT shownOnSlices(shown_ == open_ ? nullptr : loader_.phase(shown_), textOf(shown_));
}

void PhasesController::showNote() {
    if (!loader_.fits()) return bar_->setNote(tr("Memory is not enough for all phases"));
    const bool isLoading =
        (isPlaying() || wantsCurve_ || in3d_->isOn() || shown_ != open_) && !loader_.hasAll();
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
    in3d_->setPlaying(isPlaying());
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
    if (areSeen && in3d_->isSeen() && !subtraction_.running()) show(next);
}

void PhasesController::setImagesShown(bool shown) {
    if (shown) setPlaying(false);
    bar_->setPhases(shown ? 0 : int(phases_.size()));
    if (shown || phases_.empty()) return;
    bar_->setReference(reference_ ? int(*reference_) : -1);
    bar_->setShown(int(shown_), textOf(shown_));
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
