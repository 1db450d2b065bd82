#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/look/view3d_controller.h"

#include <QAction>
#include <QColorDialog>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "scene/camera/view_directions.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/key_book.h"
#include "viewer/status/study_notes.h"
#include "viewer/status/visibility_note.h"
#include "viewer/transfer/transfer_drag.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

// In the order of the entries.
constexpr std::array<std::optional<scene::BackgroundColour>, 4> kOffered{
    std::nullopt, scene::kBlackBackground, scene::BackgroundColour{128, 128, 128},
    scene::BackgroundColour{255, 255, 255}};

QString withCapital(const std::string& name) {
    QString title = titleInWindowsLanguage(name);
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

}  // namespace

BackgroundMenu::BackgroundMenu(StudyEditor& session, QWidget* parent)
    : ChoiceMenu(tr("Back&ground"), parent), session_(session) {
    setObjectName(QStringLiteral("background-menu"));
    addChoice(tr("&Nearly Black"), QStringLiteral("background-usual"))
        ->setToolTip(tr("As when nobody has chosen; saved pictures are black then"));
    addChoice(tr("&Black"), QStringLiteral("background-black"));
    addChoice(tr("&Grey"), QStringLiteral("background-grey"));
    addChoice(tr("&White"), QStringLiteral("background-white"));
    addSeparator();
    QAction* other = addAction(tr("&Other Colour…"), this, &BackgroundMenu::askForColour);
    describe(*other, "background-other",
             tr("Of what lies behind the patient in the 3D picture, and in pictures saved of it"));
    connect(this, &ChoiceMenu::changed, this, &BackgroundMenu::onChosen);
    connect(&session_, &StudyEditor::changed, this, &BackgroundMenu::showChosen);
    connect(&session_, &StudyEditor::studyShown, this, &BackgroundMenu::showChosen);
    showChosen();
}

void BackgroundMenu::onChosen(int index) {
    use(kOffered.at(std::size_t(index)));
}

void BackgroundMenu::askForColour() {
    const scene::BackgroundColour now = session_.state().background.value_or(scene::kBlackBackground);
    auto* dialog = new QColorDialog(QColor(now.r, now.g, now.b), parentWidget());
    dialog->setObjectName(QStringLiteral("background-colour-dialog"));
    dialog->setWindowTitle(tr("Colour of the background"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
        if (!colour.isValid()) return;
        use(scene::BackgroundColour{std::uint8_t(colour.red()), std::uint8_t(colour.green()),
                                    std::uint8_t(colour.blue())});
    });
    dialog->open();
}

void BackgroundMenu::use(std::optional<scene::BackgroundColour> colour) {
    session_.change(tr("Background"), [&](scene::StudyState& next) { next.background = colour; });
}

void BackgroundMenu::showChosen() {
    const auto* const at = std::ranges::find(kOffered, session_.state().background);
    choose(at == kOffered.end() ? -1 : int(at - kOffered.begin()));
}

View3dController::View3dController(const WindowContext& context, const TransferFunctionEditor& transfer)
    : QObject(&context.window), context_(context) {
    auto* drag = new TransferDrag(context_.session, transfer, this);
    connect(&context_.viewport, &Viewport::transferDragged, drag, &TransferDrag::drag);
    connect(&context_.viewport.window(), &VulkanWindow::dragEnded, drag, &TransferDrag::end);
    connect(drag, &TransferDrag::told, this,
            [this](const QString& what) { context_.window.statusBar()->showMessage(what); });
    connect(&context_.shown, &ShownVolume::changed, this, &View3dController::redraw);
}

void View3dController::redraw() {
    scene::Drawing now = context_.shown.drawing();
    const auto& volume = context_.session.study().volume;
    context_.notes.showIfOther(
        NoteOn::visibility, volume ? visibilityNote(now, *volume, context_.session.catalogue()) : QString());
    if (context_.viewport.showsOtherPhase()) now = context_.shown.drawingOfPhase();
    context_.viewport.setDrawing(std::move(now));
}

void View3dController::addCamera(QMenu& view) {
    for (const KeyRow& row : kKeys) {
        if (const auto direction = viewDirectionOf(row.action)) {
            QAction* side = view.addAction(withCapital(scene::nameOf(*direction)), this,
                                           [this, from = *direction] { context_.viewport.showFrom(from); });
            KeyBook::showPictureKey(*side, keyOf(row.action));
        }
    }
    view.addSeparator();
    QAction* fit = view.addAction(tr("Fit what is visible"), this, [this] { context_.viewport.fit(); });
    KeyBook::showPictureKey(*fit, keyOf(KeyAction::fit));
}

void View3dController::addMarks(QMenu& view) {
    const auto add = [&](const QString& title, KeyAction key, const char* name, const QString& about) {
        QAction* action = view.addAction(title + QLatin1Char('\t') + keyOf(key).toString());
        action->setCheckable(true);
        describe(*action, name, about);
        return action;
    };
    QAction* marks =
        add(tr("Cube and scale"), KeyAction::marks, "cube-and-scale",
            tr("From where the patient is seen, and how long a centimetre is: with parallel rays "
               "everywhere, else at the depth of what the camera turns around"));
    QAction* parallel = add(tr("Parallel rays"), KeyAction::parallel, "parallel-rays",
                            tr("The same millimetres for each pixel at every depth"));
    const auto ask = [this](bool shown) {
        context_.session.change(tr("Cube and scale"),
                                [shown](scene::StudyState& next) { next.showsMarks = shown; });
    };
    connect(marks, &QAction::triggered, this, ask);
    connect(&context_.viewport, &Viewport::marksAsked, this, ask);
    const auto show = [this, marks] {
        const bool shown = context_.session.state().showsMarks;
        marks->setChecked(shown);
        context_.viewport.showMarks(shown);
    };
    followState(context_.session, this, show);
    view.addMenu(new BackgroundMenu(context_.session, &context_.window));
    connect(parallel, &QAction::triggered, &context_.viewport, &Viewport::setParallel);
    connect(&context_.viewport, &Viewport::parallelChanged, parallel, &QAction::setChecked);
}

void View3dController::addGaze(QMenu& view) {
    QAction* gaze = view.addAction(tr("Trace where the pointer is, while moving"));
    gaze->setCheckable(true);
    gaze->setChecked(true);
    connect(gaze, &QAction::triggered, &context_.viewport, &Viewport::setGazeFollowsPointer);
}

}  // namespace macula::viewer
