// Clips in the pictures: handles, the cut from the eye, the scissors, and what they leave of the voxels.
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "viewer/clip/clip_editing.h"
#include "viewer/clip/clip_handles_tool.h"
#include "viewer/clip/clip_panel.h"
#include "viewer/clip/cut_tools.h"
#include "viewer/clip/named_clips.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/keys/keys.h"
#include "viewer/lights/lights_desk.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::makeClipTools() {
    clipEditing_ = new ClipEditing(session_, this);
    scissors_ = new ScissorTool(*clipEditing_, this);
    viewport_->setTools(
        {scissors_, &lightsDesk_->tool(), new ClipHandlesTool(session_, *clipEditing_, this)});
    connect(clipEditing_, &ClipEditing::changed, this, [this] {
        for (SliceView* pane : slices_)
            pane->showClip(clipEditing_->showsOnSlices(), clipEditing_->hasHandles());
        viewport_->updateToolMarks();
    });
    connect(&session_, &StudyEditor::changed, viewport_, &Viewport::updateToolMarks);
    connect(viewport_, &Viewport::cameraRested, clipEditing_,
            [this] { clipEditing_->setCamera(toCamera(viewport_->camera())); });
    connect(scissors_, &ScissorTool::drawn, viewport_, &Viewport::updateToolMarks);
    connect(scissors_, &ScissorTool::refused, this,
            [this](const Error& error) { messages_->showError(error); });
    connectCutting();
}

bool MainWindow::cutting() const {
    return cutting_->running();
}

void MainWindow::connectCutting() {
    cutting_ = &shown_->cutting();
    cuttingBar_ = new WorkBar;
    connect(cutting_, &VoxelCutting::began, this, [this] {
        messages_->hide();
        cuttingBar_->begin(tr("Cutting"));
    });
    connect(cutting_, &VoxelCutting::progressed, cuttingBar_, &WorkBar::setProgress);
    connect(cuttingBar_, &WorkBar::cancelClicked, cutting_, &VoxelCutting::cancel);
    connect(cutting_, &VoxelCutting::ended, cuttingBar_, &QWidget::hide);
    connect(cutting_, &VoxelCutting::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

// More than fits on a small screen.
QWidget* MainWindow::makeClipColumn() {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    clipPanel_ = new ClipPanel(session_, column);
    cutTools_ = new CutTools(session_, *clipEditing_, column);
    layout->addWidget(clipPanel_);
    layout->addWidget(cutTools_);
    layout->addWidget(new NamedClips(session_, column));
    layout->addStretch(1);
    connect(cutTools_, &CutTools::scissorsAsked, scissors_, &ScissorTool::setOut);
    connect(scissors_, &ScissorTool::taken, cutTools_, &CutTools::setScissorsOut);
    auto* scrolls = new QScrollArea;
    scrolls->setObjectName(QStringLiteral("clip-scrolls"));
    scrolls->setFrameShape(QFrame::NoFrame);
    scrolls->setFocusPolicy(Qt::NoFocus);  // what is in it has the focus
    scrolls->setWidgetResizable(true);
    scrolls->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolls->setWidget(column);
    scrolls->setMinimumWidth(column->minimumSizeHint().width() +
                             scrolls->verticalScrollBar()->sizeHint().width());
    return scrolls;
}

void MainWindow::addClipPanel(QDockWidget& dock) {
    connect(&dock, &QDockWidget::visibilityChanged, clipEditing_, &ClipEditing::setPanelOpen);
}

void MainWindow::addClipActions(QMenu& menu) {
    menu.addSeparator();
    QAction* handles = menu.addAction(tr("&Handles in the Pictures"));
    handles->setObjectName(QStringLiteral("handles-of-clip"));
    handles->setCheckable(true);
    handles->setShortcut(keyOf(KeyAction::clipHandles));
    handles->setToolTip(tr("Drag faces, planes and balls of the clip where they are seen"));
    connect(handles, &QAction::toggled, clipEditing_, &ClipEditing::setHandlesAskedFor);
    QAction* scissors = menu.addAction(tr("&Scissors"));
    scissors->setObjectName(QStringLiteral("scissors"));
    scissors->setCheckable(true);
    scissors->setShortcut(keyOf(KeyAction::scissors));
    scissors->setToolTip(
        tr("Draw around something in the 3D picture: it is removed. With Shift, all else is"));
    connect(scissors, &QAction::toggled, scissors_, &ScissorTool::setOut);
    connect(scissors_, &ScissorTool::taken, scissors, &QAction::setChecked);
    QAction* eye = menu.addAction(tr("Cut from the &Eye"));
    eye->setObjectName(QStringLiteral("cut-from-eye"));
    eye->setCheckable(true);
    eye->setToolTip(tr("Remove all that lies before a plane across the line of sight"));
    connect(eye, &QAction::triggered, this, [this, eye](bool cuts) {
        const Result<void> done = clipEditing_->setEyeCut(cuts);
        if (!done) messages_->showError(done.error());
        eye->setChecked(session_.state().cuts.eye.has_value());
    });
    const auto showEye = [this, eye] { eye->setChecked(session_.state().cuts.eye.has_value()); };
    connect(&session_, &StudyEditor::changed, eye, showEye);
    connect(&session_, &StudyEditor::studyShown, eye, showEye);
}

}  // namespace macula::viewer
