#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/segmentation/segmentations_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <exception>
#include <memory>
#include <utility>

#include "base/exceptions.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/segmentation/label_map_opener.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/save_object_dialog.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"

namespace macula::viewer {

namespace {

// The file of own segments recommends the colours that they have here.
std::shared_ptr<const study::LoadedSegmentation> inChosenColours(const study::LoadedSegmentation& own,
                                                                 const scene::SegmentationSettings& choice) {
    auto coloured = std::make_shared<study::LoadedSegmentation>(own);
    for (study::LoadedSegment& each : coloured->segments)
        if (const auto rgb = scene::choiceOf(choice, each.segment.number).rgb)
            each.segment.recommendedRgb = rgb;
    return coloured;
}

}  // namespace

SegmentationsController::SegmentationsController(const WindowContext& context, SegmentationKeeper& keeper,
                                                 const std::array<SliceView*, 3>& slices)
    : QObject(&context.window),
      context_(context),
      keeper_(keeper),
      slices_(slices),
      panel_(new SegmentationPanel(context.session, keeper)),
      labelMaps_(new LabelMapOpener(context, keeper)),
      bar_(new WorkBar),
      saving_(this, {.ended = [this](const auto& notes) {
                  if (notes)
                      context_.notifications.showDone(tr("The segmentation is written to %1.").arg(path_),
                                                      inWindowsLanguage(*notes));
                  else
                      context_.notifications.failUnlessCancelled(notes.error());
                  Q_EMIT written();
              }}) {
    connect(&keeper_, &SegmentationKeeper::shownChanged, this, [this] {
        for (SliceView* pane : slices_) pane->setSegments(keeper_.shown());
    });
    connect(&keeper_, &SegmentationKeeper::listChanged, &context_.notes, &StudyNotes::show);
    connect(&keeper_, &SegmentationKeeper::began, this,
            [this] { bar_->begin(tr("Loading a segmentation")); });
    connect(&keeper_, &SegmentationKeeper::progressed, bar_, &WorkBar::setProgress);
    connect(&keeper_, &SegmentationKeeper::ended, bar_, &QWidget::hide);
    connect(bar_, &WorkBar::cancelClicked, &keeper_, &SegmentationKeeper::cancel);
    connect(labelMaps_, &LabelMapOpener::began, this, [this] { bar_->begin(tr("Opening a segmentation")); });
    connect(labelMaps_, &LabelMapOpener::progressed, bar_, &WorkBar::setProgress);
    connect(labelMaps_, &LabelMapOpener::ended, bar_, &QWidget::hide);
    connect(bar_, &WorkBar::cancelClicked, labelMaps_, &LabelMapOpener::cancel);
    connect(&keeper_, &SegmentationKeeper::failed, &context_.notifications,
            &Notifications::failUnlessCancelled);
    context_.notes.setSource(NoteOn::segments, [this] {
        const QString note = keeper_.note();
        return note.isEmpty() ? QStringList() : QStringList{note};
    });
}

void SegmentationsController::addFileAction(QMenu& file) {
    QAction* open = file.addAction(tr("Open Segme&ntation…"), labelMaps_, &LabelMapOpener::askForFile);
    describe(*open, "open-segmentation",
             tr("A label map of another program, on the voxels of the open volume: NIfTI, NRRD, MetaImage. "
                "DICOM segmentations are found by themselves in the folder"));
    QAction* save =
        file.addAction(tr("Save Se&gmentation as DICOM…"), this, &SegmentationsController::askHowToSave);
    describe(*save, "save-segmentation",
             tr("The segments that are shown, as an object for the archive and other programs"));
}

Result<scene::SegmentationRequest> SegmentationsController::onScreen() const {
    const auto refused = [](const QString& why, const QString& hint) {
        return Error{
            ErrorCode::usage, Text::verbatim(why.toStdString()), {}, Text::verbatim(hint.toStdString())};
    };
    const study::OpenedStudy& study = context_.session.study();
    scene::SegmentationRequest request{
        .parts = {}, .volume = study.volume, .found = study.found, .volumeIndex = study.volumeIndex};
    for (const study::FoundSegmentation& found : keeper_.found()) {
        const auto choice = scene::choiceOf(context_.session.state().segmentations, found.digest);
        if (!choice.isShown) continue;
        for (const auto& loaded : keeper_.allLoaded()) {
            if (loaded->digest != found.digest) continue;
            scene::SegmentationRequest::Part part{
                found.isOwn ? inChosenColours(*loaded, choice) : loaded, found.header.file, {}};
            for (const study::LoadedSegment& each : loaded->segments)
                if (scene::choiceOf(choice, each.segment.number).isVisible)
                    part.numbers.push_back(each.segment.number);
            if (!part.numbers.empty()) request.parts.push_back(std::move(part));
        }
    }
    if (!study.volume || !study.found || request.parts.empty())
        return refused(tr("No segmentation is shown."),
                       tr("Show one in the panel Segmentations, F11, and wait until it is loaded."));
    return request;
}

QString SegmentationsController::unfinished() const {
    return saving_.running() ? tr("A segmentation is still being written.") : QString();
}

void SegmentationsController::askHowToSave() {
    // Takes what is shown now: while a person answers, another study may open.
    const auto now = onScreen();
    if (!now) return context_.notifications.showError(now.error());
    context_.viewport.window().endDrag();
    auto* dialog = new SaveObjectDialog(
        {tr("Save Segmentation as DICOM"),
         tr("A segmentation object for the archive: the %n segments of what is shown, on the voxels of this "
            "series, with labels, colours and codes.",
            nullptr, int(now->segments())),
         tr("Nothing of the patient is written, no label, and all UIDs are other ones.")},
        &context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, request = *now]() mutable {
        request.isDeidentified = dialog->isDeidentified();
        askWhereToSave(std::move(request));
    });
    dialog->open();
}

void SegmentationsController::askWhereToSave(scene::SegmentationRequest request) {
    auto* dialog = context_.files.toSave(FolderKind::presentations, tr("Save the segmentation"),
                                         tr("DICOM files (*.dcm)"), QStringLiteral("dcm"),
                                         QStringLiteral("segmentation.dcm"));
    context_.files.ask(
        dialog, FolderKind::presentations, [this, request = std::move(request)](const QString& path) {
            path_ = path;
            saving_.start([path = path.toStdString(), request](Progress&) -> Result<std::vector<Text>> {
                try {
                    return scene::writeSegmentation(path, request);
                } catch (const std::exception& thrown) {
                    return errorOf(thrown, Text("write the segmentation"));
                }
            });
        });
}

}  // namespace macula::viewer
