// Fills the menus and bars.
#include <QAction>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

#include "viewer/archive/archive_controller.h"
#include "viewer/archive/send_controller.h"
#include "viewer/browser/browser_controller.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/clip/clips_controller.h"
#include "viewer/documents/documents_controller.h"
#include "viewer/documents/key_images_controller.h"
#include "viewer/dose/dose_controller.h"
#include "viewer/editor/undo_actions.h"
#include "viewer/followup/follow_up_controller.h"
#include "viewer/hanging/hanging_controller.h"
#include "viewer/headset/headset_controller.h"
#include "viewer/keys/keys.h"
#include "viewer/lights/lights_controller.h"
#include "viewer/links/links_controller.h"
#include "viewer/links/manifests_controller.h"
#include "viewer/look/look_controller.h"
#include "viewer/look/view3d_controller.h"
#include "viewer/output/models_controller.h"
#include "viewer/output/movies_controller.h"
#include "viewer/output/pictures_controller.h"
#include "viewer/output/planes_controller.h"
#include "viewer/output/presentations_controller.h"
#include "viewer/output/views_controller.h"
#include "viewer/panes/panels_controller.h"
#include "viewer/pick/pick_controller.h"
#include "viewer/presets/presets_controller.h"
#include "viewer/quality/quality_control.h"
#include "viewer/quality/quality_controller.h"
#include "viewer/receive/receive_controller.h"
#include "viewer/second/second_volume_controller.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/segmenting/segmenting_controller.h"
#include "viewer/settings/key_book.h"
#include "viewer/slices/measurements_controller.h"
#include "viewer/status/status_widgets.h"
#include "viewer/volume/table_controller.h"
#include "viewer/window/help_boxes.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::makeMenus() {
    makeFileMenu();
    makeEditMenu();
    makeViewMenu();
    presets_->addMenu(*menuBar());
    look_->addMenu(*menuBar());
    clips_->addMenu(*menuBar(), table_->action());

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&Keys and Mouse"), this, [this] { showKeys(this); })
        ->setShortcut(keyOf(KeyAction::help));
    help->addAction(tr("&About Macula"), this, [this] { showAbout(this); });
}

void MainWindow::makeFileMenu() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->setToolTipsVisible(true);
    opening_->addActions(*file);
    documents_->addAction(*file);
    archive_->addAction(*file);
    file->addMenu(&browser_->recent());
    watch_->addMenu(*file);
    receive_->addAction(*file);
    opening_->addPhantomAction(*file);
    second_->addFileActions(*file);
    file->addSeparator();
    views_->addActions(*file);
    presentations_->addActions(*file);
    file->addSeparator();
    pictures_->addActions(*file);
    planes_->addAction(*file);
    measurements_->addFileActions(*file);
    segmentations_->addFileAction(*file);
    segmenting_->addFileActions(*file);
    movies_->addActions(*file);
    models_->addActions(*file);
    presets_->addFileAction(*file);
    file->addSeparator();
    send_->addActions(*file);
    file->addSeparator();
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(keyOf(KeyAction::quit));
}

void MainWindow::makeEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addAction(&undo_->undo());
    edit->addAction(&undo_->redo());
    edit->addSeparator();
    browser_->addFindAction(*edit);
    edit->addSeparator();
    measurements_->addEditActions(*edit);
    pick_->addAction(*edit);
    followUp_->addAction(*edit);
    edit->addSeparator();
    settings_->addAction(*edit)->setShortcut(keyOf(KeyAction::settings));
}

void MainWindow::makeViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view3d_->addCamera(*view);
    states_->addActions(*view);
    view->addSeparator();
    panes_->addActions(*view);
    hanging_->addMenu(*view);
    second_->addViewActions(*view);
    dose_->addViewActions(*view);
    keyImages_->addActions(*view);
    view->addSeparator();
    view->addMenu(tr("Pane&ls"))->addActions(panels_->actions());
    view->addSeparator();
    names_ = view->addAction(tr("Patient and study over the picture"));
    KeyBook::showPictureKey(*names_, keyOf(KeyAction::names));
    names_->setObjectName(QStringLiteral("names"));
    names_->setCheckable(true);
    names_->setChecked(true);
    connect(names_, &QAction::triggered, this, &MainWindow::showNames);
    view3d_->addMarks(*view);
    view3d_->addGaze(*view);
    quality_->addActions(*view);
    headset_->addAction(*view);
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Look"));
    bar->setMovable(false);
    presets_->addBox(*bar);
    lights_->addList(*bar);
    bar->addWidget(new QLabel(QStringLiteral("   "), bar));
    browser_->addVolumes(*bar);
    bar->addWidget(new QLabel(QStringLiteral("  "), bar));
    status_->addDescription(*bar);
    bar->addWidget(&quality_->control());
}

void MainWindow::makeStatusBar() {
    for (WorkBar* bar : {opening_->bar(), archive_->bar(), links_->bar(), manifests_->bar(), table_->bar(),
                         segmentations_->loadingBar(), segmenting_->bar(), pictures_->bar(), planes_->bar(),
                         send_->bar(), movies_->bar(), models_->bar(), quality_->bar(), clips_->bar()})
        statusBar()->addWidget(bar);
    status_->addTo(*statusBar());
    statusBar()->addPermanentWidget(receive_->label());
}

}  // namespace macula::viewer
