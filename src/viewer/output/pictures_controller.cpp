#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/pictures_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <new>
#include <optional>
#include <utility>

#include "study/open/found_volumes.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/output/picture_dialog.h"
#include "viewer/output/picture_overlays.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/status/work_status.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

// One of the images from which the volume was read.
std::optional<dicom::SecondaryCapture::Source> imageOf(const study::OpenedStudy& study) {
    if (!study.found) return std::nullopt;
    const auto& frames = study.found->volumes().at(study.volumeIndex).stack->frames;
    if (frames.empty()) return std::nullopt;
    const dicom::Instance& image = *frames[frames.size() / 2].instance;
    return dicom::SecondaryCapture::Source{image.file, image.sopInstanceUid};
}

}  // namespace

PictureExport::PictureExport(std::string preferredDevice, QObject* parent)
    : QObject(parent),
      preferredDevice_(std::move(preferredDevice)),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const auto& outcome) { onEnded(outcome); }}) {}

void PictureExport::start(pictures::ViewPicture picture) {
    path_ = QString::fromStdString(picture.output.string());
    using Written = Result<std::vector<Text>>;
    job_.start([picture = std::move(picture), device = preferredDevice_](Progress& progress) -> Written {
        try {
            return pictures::writeViewPicture(picture, device, progress);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory for this picture."),
                         {},
                         Text("Choose a smaller size, or close other programs.")};
        }
    });
    Q_EMIT began();
}

void PictureExport::cancel() {
    if (job_.cancel()) Q_EMIT ended();
}

void PictureExport::onEnded(const Result<std::vector<Text>>& outcome) {
    Q_EMIT ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        return;
    }
    Q_EMIT written(path_, inWindowsLanguage(*outcome));
}

PicturesController::PicturesController(const WindowContext& context, const PaneGrid& panes,
                                       const SettingsController& settings)
    : QObject(&context.window),
      context_(context),
      panes_(panes),
      settings_(settings),
      export_(new PictureExport(context.device, this)),
      bar_(new WorkBar) {
    showWork(*export_, *bar_, tr("Drawing the picture"), context_.notifications);
    connect(export_, &PictureExport::written, this, [this](const QString& path, const QStringList& notes) {
        context_.notifications.showDone(tr("The picture is written to %1.").arg(path), notes);
        Q_EMIT written();
    });
}

void PicturesController::addActions(QMenu& file) {
    QAction* save = file.addAction(tr("Save &Picture…"), this, &PicturesController::askHowToSave);
    save->setShortcut(keyOf(KeyAction::savePicture));
    describe(*save, "save-picture", tr("Draw what is seen in 3D at any size and quality, without names"));
}

QString PicturesController::unfinished() const {
    return export_->running() ? tr("A picture is still being drawn.") : QString();
}

void PicturesController::cancel() {
    export_->cancel();
}

pictures::ViewPicture PicturesController::onScreen() const {
    const study::OpenedStudy& study = context_.session.study();
    return {.volume = study.volume,
            .seriesDigest = study.seriesDigest,
            .drawing = context_.shown.drawing(),
            .camera = toCamera(context_.viewport.camera()),
            .sizePx = {screenPx().width(), screenPx().height()},
            .effort = {.quality = settings_.settings().quality.toStdString()},
            .output = {},
            .source = imageOf(study),
            .isOfNobody = study.identity.isOfNobody};
}

// The size of a hidden 3D window means nothing.
QSize PicturesController::screenPx() const {
    return is3dShown() ? context_.viewport.pictureSize() : panes_.size() * panes_.devicePixelRatioF();
}

bool PicturesController::is3dShown() const {
    return panes_.isShown(Pane::volume);
}

void PicturesController::addOverlays(pictures::ViewPicture& picture) {
    picture.stampsFor = [sizePx = picture.sizePx, isCalibrated = picture.volume->provenance().isCalibrated](
                            const Camera& camera) { return overlaysOf(camera, sizePx, isCalibrated); };
}

void PicturesController::askHowToSave() {
    if (instead_ && instead_()) return;
    if (!context_.notifications.refuseUnless(context_.session.hasStudy(),
                                             tr("There is no picture to save yet.")))
        return;
    if (!context_.notifications.refuseUnless(!context_.viewport.showsOtherPhase(),
                                             whyNotOfOpenPhase(context_.viewport)))
        return;
    context_.viewport.window().endDrag();
    auto* dialog = new PictureDialog(screenPx(), &context_.window);
    if (!is3dShown()) dialog->tellThat3dIsHidden();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->beginWith(settings_.settings().quality, settings_.settings().deidentifies);
    dialog->offerEffectsOf(context_.session.state().settings.look);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { askWhereToSave(*dialog); });
    dialog->open();
}

void PicturesController::askWhereToSave(const PictureDialog& how) {
    auto* dialog = context_.files.toSave(
        FolderKind::pictures, tr("Save the picture"),
        tr("Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)"),
        QStringLiteral("png"), QStringLiteral("picture"));
    FileDialogs::followFilter(*dialog);
    // Takes what is on screen now: while a person looks for a folder, another study may open.
    pictures::ViewPicture picture = onScreen();
    picture.sizePx = {how.sizePx().width(), how.sizePx().height()};
    picture.effort = {.quality = how.quality()};
    picture.effects = how.effects();
    picture.isDeidentified = how.isDeidentified();
    if (how.hasOverlays()) addOverlays(picture);
    context_.files.ask(dialog, FolderKind::pictures,
                       [this, picture = std::move(picture)](const QString& path) {
                           pictures::ViewPicture wanted = picture;
                           wanted.output = path.toStdString();
                           export_->start(std::move(wanted));
                       });
}

}  // namespace macula::viewer
