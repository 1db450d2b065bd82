#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/clip/clips_controller.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "viewer/clip/clip_editing.h"
#include "viewer/clip/clip_handles_tool.h"
#include "viewer/clip/clip_panel.h"
#include "viewer/clip/cut_tools.h"
#include "viewer/clip/named_clips.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/keys/keys.h"
#include "viewer/menus/choice_menu.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/work_status.h"

namespace macula::viewer {

ClipsController::ClipsController(const WindowContext& context, const std::array<SliceView*, 3>& slices,
                                 VoxelCutting& cutting)
    : QObject(&context.window),
      context_(context),
      slices_(slices),
      editing_(new ClipEditing(context.session, this)),
      scissors_(new ScissorTool(*editing_, this)),
      handles_(new ClipHandlesTool(context.session, *editing_, this)),
      bar_(new WorkBar) {
    connectTools();
    showWork(cutting, *bar_, tr("Cutting"), context_.notifications);
}

void ClipsController::connectTools() {
    connect(editing_, &ClipEditing::changed, this, [this] {
        for (SliceView* pane : slices_) pane->showClip(editing_->showsOnSlices(), editing_->hasHandles());
        context_.viewport.updateToolMarks();
    });
    connect(&context_.session, &StudyEditor::changed, &context_.viewport, &Viewport::updateToolMarks);
    connect(&context_.viewport, &Viewport::cameraRested, editing_,
            [this] { editing_->setCamera(toCamera(context_.viewport.camera())); });
    connect(scissors_, &ScissorTool::drawn, &context_.viewport, &Viewport::updateToolMarks);
    connect(scissors_, &ScissorTool::refused, &context_.notifications, &Notifications::showError);
}

// Scrolls, because it is too tall for a small screen.
QWidget* ClipsController::makePanel() {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ClipPanel(context_.session, column));
    auto* tools = new CutTools(context_.session, *editing_, column);
    layout->addWidget(tools);
    layout->addWidget(new NamedClips(context_.session, column));
    layout->addStretch(1);
    connect(tools, &CutTools::scissorsAsked, scissors_, &ScissorTool::setOut);
    connect(scissors_, &ScissorTool::taken, tools, &CutTools::setScissorsOut);
    auto* scrolls = new QScrollArea;
    scrolls->setObjectName(QStringLiteral("clip-scrolls"));
    scrolls->setFrameShape(QFrame::NoFrame);
    scrolls->setFocusPolicy(Qt::NoFocus);  // its contents have the focus
    scrolls->setWidgetResizable(true);
    scrolls->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolls->setWidget(column);
    scrolls->setMinimumWidth(column->minimumSizeHint().width() +
                             scrolls->verticalScrollBar()->sizeHint().width());
    return scrolls;
}

void ClipsController::setDock(QDockWidget& dock) {
    connect(&dock, &QDockWidget::visibilityChanged, editing_, &ClipEditing::setPanelOpen);
}

void ClipsController::addMenu(QMenuBar& bar, QAction& first) {
    menu_ = new ChoiceMenu(tr("&Clip"), &context_.window);
    bar.addMenu(menu_);
    menu_->addAction(&first);
    menu_->addSeparator();
    addTools();
    addEyeCut();
    menu_->addSeparator();
    addPresets();
}

void ClipsController::addTools() {
    QAction* handles = menu_->addAction(tr("&Handles in the Pictures"));
    handles->setObjectName(QStringLiteral("handles-of-clip"));
    handles->setCheckable(true);
    handles->setShortcut(keyOf(KeyAction::clipHandles));
    handles->setToolTip(tr("Drag faces, planes and balls of the clip where they are seen"));
    connect(handles, &QAction::toggled, editing_, &ClipEditing::setHandlesAskedFor);
    QAction* scissors = menu_->addAction(tr("&Scissors"));
    scissors->setObjectName(QStringLiteral("scissors"));
    scissors->setCheckable(true);
    scissors->setShortcut(keyOf(KeyAction::scissors));
    scissors->setToolTip(
        tr("Draw around something in the 3D picture: it is removed. With Shift, all else is"));
    connect(scissors, &QAction::toggled, scissors_, &ScissorTool::setOut);
    connect(scissors_, &ScissorTool::taken, scissors, &QAction::setChecked);
}

void ClipsController::addEyeCut() {
    QAction* eye = menu_->addAction(tr("Cut from the &Eye"));
    eye->setObjectName(QStringLiteral("cut-from-eye"));
    eye->setCheckable(true);
    eye->setToolTip(tr("Remove all that lies before a plane across the line of sight"));
    const auto showEye = [this, eye] { eye->setChecked(context_.session.state().cuts.eye.has_value()); };
    connect(eye, &QAction::triggered, this, [this, showEye](bool cuts) {
        const Result<void> done = editing_->setEyeCut(cuts);
        if (!done) context_.notifications.showError(done.error());
        showEye();
    });
    connect(&context_.session, &StudyEditor::changed, eye, showEye);
    connect(&context_.session, &StudyEditor::studyShown, eye, showEye);
}

void ClipsController::addPresets() {
    const auto& clips = context_.session.catalogue().clips;
    menu_->addChoice(tr("&No Clip"), QStringLiteral("no-clip"))->setShortcut(keyOf(KeyAction::noClip));
    for (const auto& clip : clips) {
        menu_->addChoice(titleOr(clip->title, clip->name),
                         QStringLiteral("clip-") + QString::fromStdString(clip->name));
    }
    connect(&context_.session, &StudyEditor::studyShown, this, &ClipsController::showChosen);
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        const scene::StudyState& now = context_.session.state();
        if (now.clip != before.clip || now.cuts != before.cuts) showChosen();
    });
    connect(menu_, &ChoiceMenu::changed, this, [this](int index) {
        context_.session.change(tr("Clip"), [&](scene::StudyState& next) {
            next.clip.reset();
            if (index == 0) next.cuts = {};
            if (index > 0)  // 0 is no clip
                next.clip = *context_.session.catalogue().clips.at(std::size_t(index) - 1);
        });
    });
}

// Entry 0 is "No Clip", which also removes a clip that is not in the menu; for such a clip no entry is
// checked.
void ClipsController::showChosen() {
    const scene::StudyState& state = context_.session.state();
    const auto& clips = context_.session.catalogue().clips;
    if (!state.clip && state.cuts.isNothing()) return menu_->choose(0);
    const auto shown =
        std::ranges::find_if(clips, [&](const auto& clip) { return state.clip && *clip == *state.clip; });
    menu_->choose(shown == clips.end() ? -1 : int(shown - clips.begin()) + 1);
}

}  // namespace macula::viewer
