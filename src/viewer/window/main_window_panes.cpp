// Panes and panels: the volume, slices of it, and what changes how they are shown.
#include <QDockWidget>
#include <QTabBar>
#include <QToolBar>
#include <algorithm>
#include <array>
#include <utility>

#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_browser.h"
#include "viewer/clip/clip_panel.h"
#include "viewer/editor/undo_actions.h"
#include "viewer/keys/keys.h"
#include "viewer/lights/lights_desk.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/panes/tool_box.h"
#include "viewer/presets/preset_gallery.h"
#include "viewer/second/slice_pair.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/slices/slice_view.h"
#include "viewer/transfer/transfer_function_editor.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

Pane paneOf(slices::Orientation orientation) {
    constexpr std::array kByOrientation{Pane::axial, Pane::coronal, Pane::sagittal};
    return kByOrientation.at(std::size_t(orientation));
}

}  // namespace

void MainWindow::makePanes() {
    for (const auto orientation :
         {slices::Orientation::axial, slices::Orientation::coronal, slices::Orientation::sagittal}) {
        auto* pair = new SlicePair(session_, orientation);
        pairs_.at(std::size_t(orientation)) = pair;
        SliceView* pane = &pair->study();
        slices_.at(std::size_t(orientation)) = pane;
        connect(pane, &SliceView::maximizeAsked, this,
                [this, orientation] { panes_->maximize(paneOf(orientation)); });
        connect(pane, &SliceView::cineChanged, this, [this, pane](bool plays) {
            if (plays) {
                for (SliceView* other : slices_)
                    if (other != pane) other->setCine(false);
            }
            tools_->setCine(std::ranges::any_of(slices_, &SliceView::isCineOn));
        });
    }
    panes_ = new PaneGrid({.axial = pairs_[std::size_t(slices::Orientation::axial)],
                           .volume = viewport_,
                           .coronal = pairs_[std::size_t(slices::Orientation::coronal)],
                           .sagittal = pairs_[std::size_t(slices::Orientation::sagittal)]},
                          this);
    connect(panes_, &PaneGrid::layoutAsked, this, [this](scene::Layout layout) {
        session_.change(tr("Panes"), [layout](scene::StudyState& next) { next.layout = layout; });
    });
    connect(panes_, &PaneGrid::activePaneChanged, this, [this] {
        if (const auto active = panes_->activePane()) lastPane_ = active;
    });
    tools_ = new ToolBox(session_, this);
    addToolBar(Qt::LeftToolBarArea, tools_);
    connect(tools_, &ToolBox::toolChosen, this, [this](SliceTool tool) {
        for (SliceView* pane : slices_) pane->setTool(tool);
    });
    connect(tools_, &ToolBox::cineToggled, this, &MainWindow::setCine);
    connect(tools_, &ToolBox::thicknessEntered, this, &MainWindow::focusPicture);
    undo_ = new UndoActions(session_, this);
    // A search that would end after it would undo the undoing.
    for (QAction* action : {&undo_->undo(), &undo_->redo()})
        connect(action, &QAction::triggered, table_, &TableRemoval::cancel);
}

// Of the pane that has the focus; else of the first that is shown.
void MainWindow::setCine(bool plays) {
    const auto active = panes_->activePane();
    SliceView* chosen = nullptr;
    for (SliceView* pane : slices_) {
        const Pane place = paneOf(pane->orientation());
        if (panes_->isShown(place) && (!chosen || active == place)) chosen = pane;
    }
    for (SliceView* pane : slices_) pane->setCine(plays && pane == chosen);
    tools_->setCine(plays && chosen != nullptr);
}

void MainWindow::makePanels() {
    transfer_ = new TransferFunctionEditor(session_);
    connect(transfer_, &TransferFunctionEditor::saveAsked, gallery_, &PresetGallery::askToSaveCurve);
    segmentsPanel_ = new SegmentationPanel(session_, *segments_);
    browser_ = new StudyBrowser;
    const auto add = [this](Qt::DockWidgetArea area, QWidget* panel, const QString& title, const char* name,
                            const char* key) {
        auto* dock = new QDockWidget(title, this);
        dock->setObjectName(QString::fromLatin1(name));
        dock->setWidget(panel);
        // Floating ones would hide the volume's native window from its own events on some desktops.
        dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
        addDockWidget(area, dock);
        dock->hide();
        dock->toggleViewAction()->setShortcut(QKeySequence(QString::fromLatin1(key)));
        panels_ << dock->toggleViewAction();
        return dock;
    };
    browserShown_ = add(Qt::LeftDockWidgetArea, browser_, tr("Studies"), "studies-panel", kPanelKeys[0])
                        ->toggleViewAction();
    QDockWidget* first =
        add(Qt::RightDockWidgetArea, transfer_, tr("Transfer Function"), "transfer-panel", kPanelKeys[1]);
    QDockWidget* second =
        add(Qt::RightDockWidgetArea, makeClipColumn(), tr("Clip"), "clip-panel", kPanelKeys[2]);
    addClipPanel(*second);
    splitDockWidget(first, second, Qt::Vertical);
    QDockWidget* presets =
        add(Qt::RightDockWidgetArea, gallery_, tr("Presets"), "presets-panel", kPanelKeys[3]);
    QDockWidget* segments =
        add(Qt::RightDockWidgetArea, segmentsPanel_, tr("Segmentations"), "segments-panel", "F11");
    QDockWidget* lights =
        add(Qt::RightDockWidgetArea, lightsDesk_->column(), tr("Lights"), "lights-panel", kPanelKeys[4]);
    connect(lights, &QDockWidget::visibilityChanged, lightsDesk_, &LightsDesk::setPanelOpen);
    // Two that are seldom wanted at once share a place once both are shown. Not before: the window would make
    // room for what is hidden.
    const auto sharePlace = [this](QDockWidget* one, QDockWidget* other) {
        for (auto [asked, partner] : {std::pair(one, other), std::pair(other, one)}) {
            connect(asked->toggleViewAction(), &QAction::triggered, asked,
                    [this, asked = asked, partner = partner](bool shown) {
                        if (!shown) return;
                        if (!partner->isHidden()) tabifyDockWidget(partner, asked);
                        asked->raise();
                    });
            connect(asked, &QDockWidget::visibilityChanged, this, &MainWindow::explainTabs,
                    Qt::QueuedConnection);
        }
    };
    sharePlace(first, presets);
    sharePlace(second, segments);
    sharePlace(second, lights);
    sharePlace(segments, lights);
}

void MainWindow::explainTabs() {
    for (QTabBar* bar : findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        bar->setToolTip(tr("Panels that share this place"));
}

void MainWindow::showPanes() {
    const scene::Layout layout = session_.state().layout;
    panes_->setLayout(layout);
    tools_->setVisible(layout != scene::Layout::volume);  // they are of slices
    tellOfPicture();
}

void MainWindow::favourPane(std::optional<slices::Orientation> orientation) {
    panes_->favour(orientation ? std::optional(paneOf(*orientation)) : std::nullopt);
}

void MainWindow::focusPicture() {
    Pane pane = lastPane_.value_or(Pane::volume);
    if (!panes_->isShown(pane))
        pane = *std::ranges::find_if(kPanes, [this](Pane each) { return panes_->isShown(each); });
    panes_->focusPane(pane);
}

void MainWindow::showNames(bool shown) {
    viewport_->showNames(shown);
    for (SlicePair* pair : pairs_) pair->showNames(shown);
    browser_->showNames(shown);
    recent_->showNames(shown);
    segmentsPanel_->showNames(shown);
    names_->setChecked(shown);
    showStudyTexts();
}

}  // namespace macula::viewer
