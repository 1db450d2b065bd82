#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/segmentation/label_map_opener.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "formats/volume_file.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

LabelMapOpener::LabelMapOpener(const WindowContext& context, SegmentationKeeper& keeper)
    : QObject(&context.window),
      context_(context),
      keeper_(keeper),
      guessing_(this, {.ended = [this](const Result<study::LabelMapGuess>& guess) { onGuessed(guess); }}),
      opening_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended = [this](const Result<study::OpenedLabelMap>& opened) { onOpened(opened); }}) {
    connect(&context_.session, &StudyEditor::studyShown, this, &LabelMapOpener::cancel);
}

void LabelMapOpener::cancel() {
    guessing_.cancel();
    openAsVolume_ = nullptr;
    if (opening_.cancel()) Q_EMIT ended();
}

void LabelMapOpener::askForFile() {
    if (!context_.session.hasStudy())
        return context_.notifications.refuse(tr("A segmentation is shown on a volume."),
                                             tr("Open the volume first that it was drawn on."));
    auto* dialog = context_.files.toOpen(
        FolderKind::studies, tr("Open a segmentation of this volume"),
        tr("Label maps: NIfTI, NRRD, MetaImage (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.hdr)"));
    context_.files.ask(dialog, FolderKind::studies, [this](const QString& path) { open(path); });
}

void LabelMapOpener::open(const QString& path) {
    cancel();
    if (!context_.session.hasStudy()) return;
    path_ = path;
    opening_.start([path = path.toStdString(), volume = context_.session.study().volume](Progress& progress) {
        return study::openLabelMap(path, *volume, progress);
    });
    Q_EMIT began();
}

void LabelMapOpener::onOpened(const Result<study::OpenedLabelMap>& opened) {
    Q_EMIT ended();
    if (!opened) return context_.notifications.failUnlessCancelled(opened.error());
    keeper_.takeOpened(*opened);
    context_.notifications.showDone(tr("%n segments are shown; the panel Segmentations (F11) lists them.",
                                       nullptr, int(opened->loaded->segments.size())),
                                    inWindowsLanguage(opened->loaded->notes));
}

bool LabelMapOpener::takesDropped(const QString& path, std::function<void()> openAsVolume) {
    if (!context_.session.hasStudy() || !formats::isVolumeFileName(path.toStdString())) return false;
    cancel();
    path_ = path;
    openAsVolume_ = std::move(openAsVolume);
    guessing_.start([path = path.toStdString(),
                     volume = context_.session.study().volume](Progress&) -> Result<study::LabelMapGuess> {
        return study::guessLabelMap(path, *volume);
    });
    return true;
}

void LabelMapOpener::onGuessed(const Result<study::LabelMapGuess>& guess) {
    const auto openAsVolume = std::exchange(openAsVolume_, nullptr);
    if (!guess) return context_.notifications.failUnlessCancelled(guess.error());
    if (*guess == study::LabelMapGuess::yes) return open(path_);
    if (*guess == study::LabelMapGuess::no) return openAsVolume();
    openAsVolume_ = openAsVolume;
    askWhatItIs();
}

void LabelMapOpener::askWhatItIs() {
    context_.viewport.window().endDrag();
    auto* box = new QMessageBox(
        QMessageBox::Question, tr("A segmentation?"),
        tr("%1 lies on the voxels of the volume that is open. Is it a segmentation of this volume?")
            .arg(harmless(QFileInfo(path_).fileName())),
        QMessageBox::Cancel, &context_.window);
    box->setObjectName(QStringLiteral("label-map-question"));
    box->setTextFormat(Qt::PlainText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* segmentation = box->addButton(tr("Show It as a &Segmentation"), QMessageBox::AcceptRole);
    segmentation->setObjectName(QStringLiteral("label-map-segmentation"));
    QPushButton* volume = box->addButton(tr("Open It as a &Volume"), QMessageBox::ActionRole);
    volume->setObjectName(QStringLiteral("label-map-volume"));
    box->setDefaultButton(segmentation);
    connect(segmentation, &QPushButton::clicked, this, [this, path = path_] { open(path); });
    connect(volume, &QPushButton::clicked, this, [openIt = std::exchange(openAsVolume_, nullptr)] {
        if (openIt) openIt();
    });
    box->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer
