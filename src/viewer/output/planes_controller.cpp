#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/planes_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <utility>

#include "pipeline/volume/window.h"
#include "slices/curve.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/output/planes_dialog.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/status/work_status.h"

namespace macula::viewer {

namespace {

constexpr double kUsualReachMm = 30.0;  // to either side

std::optional<scene::PlaneBatch::Radial> alongCurve(const std::vector<glm::dvec3>& pointsMm,
                                                    const glm::dvec3& nearMm) {
    const slices::Curve curve(pointsMm);
    if (!curve.isUsable()) return std::nullopt;
    const slices::CurvePlace place = curve.at(curve.nearestMm(nearMm));
    return scene::PlaneBatch::Radial{.throughMm = place.mm, .axis = place.along};
}

}  // namespace

PlanesController::PlanesController(const WindowContext& context, const std::array<SliceView*, 3>& panes,
                                   const SettingsController& settings)
    : QObject(&context.window),
      context_(context),
      panes_(panes),
      settings_(settings),
      bar_(new WorkBar),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<scene::WrittenPlanes>& outcome) { onEnded(outcome); }}) {
    showWork(*this, *bar_, tr("Writing planes"), context_.notifications);
    for (SliceView* pane : panes_)
        connect(pane, &SliceView::savePlanesAsked, this, [this, pane] { ask(*pane); });
}

void PlanesController::addAction(QMenu& file) {
    QAction* save = file.addAction(tr("Save a &Batch of Planes…"), this, &PlanesController::askOfActivePane);
    describe(*save, "save-plane-batch",
             tr("Planes like that of the slice pane with the focus, or about a line, as a DICOM series that "
                "keeps its place in the patient"));
}

QString PlanesController::unfinished() const {
    return job_.running() ? tr("A batch of planes is still being written.") : QString();
}

void PlanesController::cancel() {
    if (job_.cancel()) Q_EMIT ended();
}

void PlanesController::askOfActivePane() {
    auto active = std::ranges::find_if(panes_, [](const SliceView* pane) { return pane->hasFocus(); });
    if (active == panes_.end())
        active = std::ranges::find_if(panes_, [](const SliceView* pane) { return pane->isVisible(); });
    if (active == panes_.end() || !(*active)->shownFrame())
        return context_.notifications.refuse(tr("No slice is shown whose plane could be taken."),
                                             tr("Open a study, and show slices: F5."));
    ask(**active);
}

void PlanesController::ask(const SliceView& pane) {
    const auto frame = pane.shownFrame();
    if (!frame || !context_.session.hasStudy()) return;
    context_.viewport.window().endDrag();
    const study::OpenedStudy& study = context_.session.study();
    const scene::SliceState& state = context_.session.state().slices;
    const Volume& volume = *study.measured();
    const glm::dvec3 middle =
        transformPoint(volume.worldFromVoxel(), 0.5 * (glm::dvec3(volume.size()) - 1.0));
    const glm::dvec3 crosshairMm = state.crosshairMm.value_or(middle);
    PlanesDialog::Offer offer{
        .batch = {.like = *frame,
                  .fromMm = -kUsualReachMm,
                  .toMm = kUsualReachMm,
                  .stepMm = state.slab.thicknessMm > 0.0 ? state.slab.thicknessMm
                                                         : slices::stepMm(volume, frame->plane),
                  .slab = state.slab},
        .volume = study.measured(),
        .crosshairMm = crosshairMm,
        .alongCurve = alongCurve(state.curveMm, crosshairMm),
        .namesPatient = study.found != nullptr,
        .isDeidentified = settings_.settings().deidentifies};
    auto* dialog = new PlanesDialog(offer, &context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // Takes what is open now: while a person answers, another study may open.
    scene::PlaneBatchRequest request{.batch = {},
                                     .volume = study.measured(),
                                     .found = study.found,
                                     .volumeIndex = study.volumeIndex,
                                     .window = state.window ? *state.window : seriesWindow(volume)};
    connect(dialog, &QDialog::accepted, this, [this, dialog, request = std::move(request)]() mutable {
        request.batch = dialog->batch();
        request.isDeidentified = dialog->isDeidentified();
        askWhereToSave(std::move(request));
    });
    dialog->open();
}

void PlanesController::askWhereToSave(scene::PlaneBatchRequest request) {
    auto* dialog =
        context_.files.toOpenFolder(FolderKind::presentations, tr("Choose an empty folder for the planes"));
    context_.files.ask(dialog, FolderKind::presentations,
                       [this, request = std::move(request)](const QString& path) {
                           cancel();
                           folder_ = path;
                           job_.start([folder = path.toStdString(), request](Progress& progress) {
                               return scene::writePlanes(folder, request, progress);
                           });
                           Q_EMIT began();
                       });
}

void PlanesController::onEnded(const Result<scene::WrittenPlanes>& outcome) {
    Q_EMIT ended();
    if (outcome) {
        context_.notifications.showDone(
            tr("%n planes are written to %1.", nullptr, int(outcome->files.size())).arg(folder_),
            inWindowsLanguage(outcome->notes));
    } else if (outcome.error().code != ErrorCode::cancelled) {
        Q_EMIT failed(outcome.error());
    }
    Q_EMIT written();
}

}  // namespace macula::viewer
