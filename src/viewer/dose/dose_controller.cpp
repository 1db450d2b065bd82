#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/dose/dose_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "base/atomic_file.h"
#include "viewer/dose/dose_panel.h"
#include "viewer/dose/dvh_dialog.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/status/study_notes.h"

namespace macula::viewer {

DoseController::DoseController(const WindowContext& context, SecondVolumeLoader& second)
    : QObject(&context.window),
      context_(context),
      second_(second),
      panel_(new DosePanel(context.session)),
      dialog_(new DvhDialog(&context.window)),
      finding_(this, {.ended =
                          [this](const Result<Found>& outcome) {
                              found_ = outcome ? *outcome : Found();
                              showState();
                              context_.notes.show();
                          }}),
      reporting_(this, {.progressed =
                            [this](const ProgressUpdate& update) {
                                dialog_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                            },
                        .ended = [this](const Result<Report>& outcome) { onReport(outcome); }}) {
    connect(&context_.session, &StudyEditor::studyShown, this, &DoseController::onStudyShown);
    connect(&context_.session, &StudyEditor::changed, this, &DoseController::showState);
    connect(&second_, &SecondVolumeLoader::secondChanged, this, &DoseController::showState);
    connect(panel_, &DosePanel::showAsked, this, &DoseController::showDose);
    connect(panel_, &DosePanel::histogramAsked, this, &DoseController::showHistogram);
    connect(dialog_, &DvhDialog::exportAsked, this, &DoseController::exportCsv);
    connect(dialog_, &DvhDialog::cancelAsked, this, [this] {
        if (reporting_.cancel()) dialog_->setTrouble(tr("Nothing was computed: it was cancelled."));
    });
    context_.notes.setSource(NoteOn::dose, [this] { return notes(); });
}

void DoseController::addViewActions(QMenu& view) {
    show_ = view.addAction(tr("Show &Dose"), this, [this] { showDose(panel_->chosen()); });
    describe(*show_, "show-dose", tr("Lays the dose of the treatment plan over the open images"));
    histogram_ =
        view.addAction(tr("Dose-&Volume Histogram…"), this, [this] { showHistogram(panel_->chosen()); });
    describe(*histogram_, "show-dvh", tr("How much dose each region of the structure set receives"));
    showState();
}

void DoseController::showNames(bool shown) {
    dialog_->showNames(shown);
}

void DoseController::onStudyShown() {
    finding_.cancel();
    reporting_.cancel();
    found_.clear();
    dialog_->hide();
    dialog_->setReport(nullptr, {});
    const study::OpenedStudy& study = context_.session.study();
    if (study.found)
        finding_.start([found = study.found, index = study.volumeIndex](Progress&) -> Result<Found> {
            return study::dosesOn(*found, index);
        });
    panel_->setDoses({});
    showState();
}

// A dose that is the second volume already is laid over again.
void DoseController::showDose(std::size_t dose) {
    if (dose >= found_.size()) return;
    const auto& found = context_.session.study().found;
    const std::size_t volume = found_[dose].volume;
    const auto& there = second_.second();
    const bool isThere =
        there && there->study.found == found && there->study.volumeIndex == volume && second_.state();
    if (isThere) return second_.setView(scene::SecondVolumePlace::over);
    second_.open(found, volume);
}

void DoseController::showHistogram(std::size_t dose) {
    if (dose >= found_.size()) return;
    reported_ = dose;
    const study::OpenedStudy& study = context_.session.study();
    dialog_->begin(tr("Computing the dose in regions"));
    dialog_->show();
    dialog_->raise();
    reporting_.start([found = study.found, on = study.volumeIndex, grid = study.volume,
                      volume = found_[dose].volume](Progress& progress) -> Result<Report> {
        MACULA_TRY(const study::OpenedStudy opened, study::openFoundVolume(found, volume, progress));
        MACULA_TRY(
            study::DoseReport report,
            study::reportDose(
                {.found = *found, .on = on, .grid = *grid, .dose = volume, .values = opened.measured()},
                progress));
        return std::make_shared<const study::DoseReport>(std::move(report));
    });
}

void DoseController::onReport(const Result<Report>& outcome) {
    if (!outcome) return dialog_->setTrouble(inWindowsLanguage(outcome.error()));
    const QString title =
        reported_ < found_.size() ? inWindowsLanguage(study::doseText(found_[reported_].facts)) : QString();
    dialog_->setReport(*outcome, title);
}

void DoseController::showState() {
    if (show_ != nullptr) show_->setEnabled(!found_.empty());
    if (histogram_ != nullptr) histogram_->setEnabled(!found_.empty());
    panel_->setDoses(found_);
    const scene::SecondVolumeState* state = second_.state();
    const auto& second = second_.second();
    if (state == nullptr || !second->study.dose || !state->isLinked()) return panel_->setShown({});
    const scene::Isodoses usual{.areShown = false};
    panel_->setShown({.isodoses = state->isodoses ? &*state->isodoses : &usual,
                      .reference = scene::doseReference(second->study, state->isodoses),
                      .unit = harmless(QString::fromStdString(second->study.volume->unitName()))});
}

void DoseController::exportCsv(const QString& csv) {
    auto* dialog =
        context_.files.toSave(FolderKind::measurements, tr("Save the dose in regions"), tr("Table (*.csv)"),
                              QStringLiteral("csv"), QStringLiteral("dose.csv"));
    context_.files.ask(dialog, FolderKind::measurements, [this, csv](const QString& path) {
        context_.notifications.showOutcome(writeTextAtomically(path.toStdString(), csv.toStdString()),
                                           tr("The dose in regions is written to %1.").arg(path));
    });
}

QStringList DoseController::notes() const {
    if (found_.empty() || second_.second()) return {};
    return {tr("There is a dose on these images (%1): View, Show Dose.")
                .arg(inWindowsLanguage(study::doseText(found_.front().facts)))};
}

}  // namespace macula::viewer
