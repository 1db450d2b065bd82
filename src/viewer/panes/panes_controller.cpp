#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/panes/panes_controller.h"

#include <QBuffer>
#include <QImage>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>

#include "base/atomic_file.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/panes/tool_box.h"
#include "viewer/second/slice_pair.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/slices/slice_view.h"
#include "viewer/slices/slice_windowing.h"
#include "viewer/slices/typed_window.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

Pane paneOf(slices::Orientation orientation) {
    constexpr std::array kByOrientation{Pane::axial, Pane::coronal, Pane::sagittal};
    return kByOrientation.at(std::size_t(orientation));
}

}  // namespace

PanesController::PanesController(const WindowContext& context) : QObject(&context.window), context_(context) {
    makeSlices();
    grid_ = new PaneGrid({.axial = pairs_[std::size_t(slices::Orientation::axial)],
                          .volume = &context_.viewport,
                          .coronal = pairs_[std::size_t(slices::Orientation::coronal)],
                          .sagittal = pairs_[std::size_t(slices::Orientation::sagittal)]},
                         &context_.window);
    connect(grid_, &PaneGrid::layoutAsked, this, &PanesController::changeLayout);
    connect(grid_, &PaneGrid::activePaneChanged, this, [this] {
        if (const auto active = grid_->activePane()) lastPane_ = active;
    });
    makeTools();
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (context_.session.state().layout != before.layout) showLayout();
    });
}

void PanesController::makeSlices() {
    for (const auto orientation :
         {slices::Orientation::axial, slices::Orientation::coronal, slices::Orientation::sagittal}) {
        auto* pair = new SlicePair(context_.session, orientation);
        pairs_.at(std::size_t(orientation)) = pair;
        SliceView* pane = &pair->study();
        slices_.at(std::size_t(orientation)) = pane;
        connect(pane, &SliceView::maximizeAsked, this,
                [this, orientation] { grid_->maximize(paneOf(orientation)); });
        connect(&pair->second(), &SliceView::maximizeAsked, pane, &SliceView::maximizeAsked);
        connect(pane, &SliceView::savePictureAsked, this, &PanesController::askWhereToSave);
        connect(pane, &SliceView::cineChanged, this, [this, pane](bool plays) {
            if (plays) {
                for (SliceView* other : slices_)
                    if (other != pane) other->setCine(false);
            }
            tools_->setCine(std::ranges::any_of(slices_, &SliceView::isCineOn));
        });
    }
}

void PanesController::makeTools() {
    tools_ = new ToolBox(context_.session, &context_.window);
    context_.window.addToolBar(Qt::LeftToolBarArea, tools_);
    connect(tools_, &ToolBox::toolChosen, this, [this](SliceTool tool) {
        for (SlicePair* pair : pairs_) {
            pair->study().setTool(tool);
            pair->second().setTool(tool);
        }
    });
    connect(tools_, &ToolBox::cineToggled, this, &PanesController::setCine);
    connect(tools_, &ToolBox::thicknessEntered, this, &PanesController::focusPicture);
}

void PanesController::shareOwnWindows(const std::optional<std::filesystem::path>& folder) {
    auto* windows = new OwnWindowList(folder, this);
    for (SliceView* pane : slices_) pane->setOwnWindows(windows);
    connect(windows, &OwnWindowList::failed, &context_.notifications, &Notifications::showError);
}

void PanesController::addActions(QMenu& view) {
    for (const LayoutRow& row : kLayouts) {
        QAction* action = view.addAction(inWindowsLanguage(Text(row.title)), this,
                                         [this, layout = row.layout] { changeLayout(layout); });
        action->setShortcut(keyOf(row));
    }
    QAction* typed = view.addAction(tr("Type a &Window…"), this, [this] {
        // Images that are no volume may hide the slices.
        if (grid_->isVisible()) askForWindow(context_.session, &context_.window);
    });
    describe(*typed, "type-window", tr("Width and level of the slices as numbers"));
    typed->setShortcut(keyOf(KeyAction::typedWindow));
    typed->setEnabled(false);
    connect(&context_.session, &StudyEditor::studyShown, typed,
            [this, typed] { typed->setEnabled(context_.session.hasStudy()); });
}

// The name says nothing of the patient; the picture does if the pane does.
void PanesController::askWhereToSave(const QImage& picture) {
    auto* dialog =
        context_.files.toSave(FolderKind::pictures, tr("Save the picture of the slice"),
                              tr("Picture (*.png)"), QStringLiteral("png"), QStringLiteral("slice.png"));
    context_.files.ask(dialog, FolderKind::pictures, [this, picture](const QString& path) {
        QByteArray png;
        QBuffer buffer(&png);
        buffer.open(QIODevice::WriteOnly);
        if (!picture.save(&buffer, "PNG"))
            return context_.notifications.fail({.code = ErrorCode::outOfMemory,
                                                .message = Text("There is no memory for this picture."),
                                                .where = {},
                                                .hint = {}});
        if (const Result<void> written = writeTextAtomically(path.toStdString(), png.toStdString()); !written)
            return context_.notifications.fail(written.error());
        context_.notifications.showNote(tr("The picture is written to %1.").arg(path));
    });
}

void PanesController::changeLayout(scene::Layout layout) {
    context_.session.change(tr("Panes"), [layout](scene::StudyState& next) { next.layout = layout; });
}

// Starts or stops cine in the active slice pane, else in the first visible one.
void PanesController::setCine(bool plays) {
    const auto active = grid_->activePane();
    SliceView* chosen = nullptr;
    for (SliceView* pane : slices_) {
        const Pane place = paneOf(pane->orientation());
        if (grid_->isShown(place) && (!chosen || active == place)) chosen = pane;
    }
    for (SliceView* pane : slices_) pane->setCine(plays && pane == chosen);
    tools_->setCine(plays && chosen != nullptr);
}

bool PanesController::isVolumeShown() const {
    return grid_->isShown(Pane::volume);
}

void PanesController::showLayout() {
    const scene::Layout layout = context_.session.state().layout;
    grid_->setLayout(layout);
    tools_->setVisible(layout != scene::Layout::volume);  // the tools are for slices
    Q_EMIT layoutShown();
}

void PanesController::favour(std::optional<slices::Orientation> orientation) {
    grid_->favour(orientation ? std::optional(paneOf(*orientation)) : std::nullopt);
}

void PanesController::focusPicture() {
    Pane pane = lastPane_.value_or(Pane::volume);
    if (!grid_->isShown(pane))
        pane = *std::ranges::find_if(kPanes, [this](Pane each) { return grid_->isShown(each); });
    grid_->focusPane(pane);
}

void PanesController::showNames(bool shown) {
    for (SlicePair* pair : pairs_) pair->showNames(shown);
}

}  // namespace macula::viewer
