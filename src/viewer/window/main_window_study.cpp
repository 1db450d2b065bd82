// Shows another study in the window, and handles the window's events.
#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <utility>

#include "scene/slices/opening_planes.h"
#include "viewer/archive/archive_controller.h"
#include "viewer/archive/send_controller.h"
#include "viewer/browser/browser_controller.h"
#include "viewer/clip/clips_controller.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/documents/documents_controller.h"
#include "viewer/dose/dose_controller.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/links/links_controller.h"
#include "viewer/look/view3d_controller.h"
#include "viewer/pick/pick_controller.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/quality/quality_controller.h"
#include "viewer/second/second_volume_controller.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/visibility_note.h"
#include "viewer/volume/table_removal.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::showStudy(const study::OpenedStudy& study) {
    states_->keep();  // stores the earlier study's state
    opening_->forgetNotes();
    const Volume& volume = *study.volume;
    const scene::OpeningPlanes planes = scene::openingPlanes(volume);
    OpeningState opening = states_->openingState(study, planes);
    const Camera camera = toCamera(viewport_->camera());
    notes_->set(NoteOn::preset, presetWarning(*opening.state.preset, volume));
    pick_->cancel();
    session_.show(study, std::move(opening.state));
    panes_->favour(planes.largest);
    panes_->showLayout();
    scene::Drawing first = shown_->drawing();
    notes_->set(NoteOn::visibility, visibilityNote(first, volume, session_.catalogue()));
    viewport_->setStudy(study.volume, linesToShow(study.identity), std::move(first), options_.firstView);
    if (opening.keepsCamera) {
        viewport_->showFrom(camera);
    } else if (opening.left && opening.left->camera) {
        viewport_->showFrom(*opening.left->camera);
    } else if (opening.left) {
        viewport_->setParallel(false);
    }
    view3d_->redraw();
    if (opening.left) shown_->table().ask(opening.left->leavesTableOut);
    states_->begin();
    browser_->onStudyShown();
    status_->onStudyShown();
    QStringList notes = std::move(opening.notes);
    notes += inWindowsLanguage(volume.provenance().assumptions);
    notes += inWindowsLanguage(study.messages);
    notifications_->hide();
    notes_->set(NoteOn::study, notes);
    notes_->show();
    quality_->showCost();
    Q_EMIT studyShown();
}

void MainWindow::showNames(bool shown) {
    viewport_->showNames(shown);
    panes_->showNames(shown);
    planar_->showNames(shown);
    browser_->showNames(shown);
    archive_->showNames(shown);
    links_->showNames(shown);
    documents_->showNames(shown);
    watch_->showNames(shown);
    send_->showNames(shown);
    dose_->showNames(shown);
    segmentations_->panel().showNames(shown);
    names_->setChecked(shown);
    status_->showTexts();
}

void MainWindow::openLink(const QString& link) {
    if (isMinimized()) setWindowState(windowState() & ~Qt::WindowMinimized);
    raise();
    activateWindow();
    links_->open(link);
}

// Letters of tools are shortcuts of the window, but not in a list.
bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isForList(static_cast<const QKeyEvent&>(*event)))
        event->accept();
    return QMainWindow::event(event);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (!viewport_->handleKey(*event)) QMainWindow::keyPressEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    acceptDrop(*event);
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (acceptDrop(*event)) opening_->openDropped(droppedBy(event->mimeData()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (quit_->mayClose()) return QMainWindow::closeEvent(event);
    event->ignore();
}

bool MainWindow::searchingTable() const {
    return shown_->table().searching();
}

bool MainWindow::cutting() const {
    return shown_->cutting().running();
}

ScissorTool& MainWindow::scissors() {
    return clips_->scissors();
}

SecondVolumeLoader& MainWindow::secondVolume() {
    return second_->loader();
}

}  // namespace macula::viewer
