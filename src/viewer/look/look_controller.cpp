#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/look/look_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenuBar>
#include <algorithm>
#include <array>

#include "scene/drawing/projection_windows.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/choice_menu.h"
#include "viewer/menus/controls.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

QString nameInMenu(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

}  // namespace

LookController::LookController(const WindowContext& context) : QObject(&context.window), context_(context) {}

void LookController::addMenu(QMenuBar& bar) {
    menu_ = new ChoiceMenu(tr("&Look"), &context_.window);
    bar.addMenu(menu_);
    for (const trace::LookTraits& look : trace::kLooks) {
        menu_
            ->addChoice(titleInWindowsLanguage(std::string(look.title)),
                        QStringLiteral("look-") + nameInMenu(look.name))
            ->setShortcut(keyOf(look.look));
    }
    addShading();
    addFilters();
    addToneMap();
    addWindow();
    followState(context_.session, this, [this] { showUsable(); });
    connect(&context_.session, &StudyEditor::studyShown, this, &LookController::showChosen);
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        const trace::Settings& now = context_.session.state().settings;
        if (now.look != before.settings.look || now.shading != before.settings.shading) showChosen();
    });
    connect(menu_, &ChoiceMenu::changed, this, [this](int index) {
        context_.session.change(tr("Look"), [index](scene::StudyState& next) {
            next.settings.look = trace::kLooks.at(std::size_t(index)).look;
        });
    });
}

void LookController::addShading() {
    menu_->addSeparator();
    shading_ = menu_->addAction(tr("&Shade Ray Cast"));
    shading_->setCheckable(true);
    shading_->setShortcut(keyOf(KeyAction::shade));
    describe(*shading_, "shade-ray-cast", tr("Light ray casts from the eye, as much as the preset says"));
    shading_->setChecked(true);
    connect(shading_, &QAction::triggered, this, [this](bool shaded) {
        context_.session.change(tr("Shading"), [shaded](scene::StudyState& next) {
            next.settings.shading = shaded ? trace::Shading::headlight : trace::Shading::none;
        });
    });
}

// The filters between voxels; for looks that show matter, not for projections.
void LookController::addFilters() {
    struct Choice {
        trace::Filter filter;
        QString text;
        QString hint;
    };
    const std::array choices{
        Choice{trace::Filter::trilinear, tr("&Linear"),
               tr("Values between eight voxels, as other viewers show them")},
        Choice{trace::Filter::smooth, tr("&Smooth"), tr("Fewest rings on skin and bone, and a voxel softer")},
        Choice{trace::Filter::sharp, tr("S&harp"),
               tr("Fine detail as with Linear, and somewhat fewer rings")}};
    auto* filters = new ChoiceMenu(tr("Between &Voxels"), menu_);
    for (const Choice& choice : choices)
        filters->addChoice(choice.text, QStringLiteral("between-voxels-") + nameInMenu(nameOf(choice.filter)))
            ->setToolTip(choice.hint);
    menu_->addMenu(filters);
    connect(filters, &ChoiceMenu::changed, this, [this, choices](int index) {
        context_.session.change(tr("Values between voxels"), [&](scene::StudyState& next) {
            next.settings.filter = choices[std::size_t(index)].filter;
        });
    });
    followState(context_.session, filters, [this, filters, choices] {
        const trace::Settings& settings = context_.session.state().settings;
        const auto shown = std::ranges::find(choices, settings.filter, &Choice::filter);
        filters->choose(shown == choices.end() ? -1 : int(shown - choices.begin()));
        for (QAction* action : filters->actions()) action->setEnabled(trace::showsMatter(settings.look));
    });
}

// How the screen shows light brighter than white; projections show values unchanged.
void LookController::addToneMap() {
    QAction* keepsHue = menu_->addAction(tr("Keep &Hues of Highlights"));
    keepsHue->setCheckable(true);
    describe(
        *keepsHue, "keep-hues",
        tr("What is too bright for the screen bleaches in its own hue; without it, contrast is higher. Not "
           "of projections"));
    connect(keepsHue, &QAction::triggered, this, [this](bool keeps) {
        context_.session.change(tr("Hues of highlights"), [keeps](scene::StudyState& next) {
            next.settings.toneMap = keeps ? trace::ToneMap::hue : trace::ToneMap::neutral;
        });
    });
    followState(context_.session, keepsHue, [this, keepsHue] {
        const trace::Settings& settings = context_.session.state().settings;
        keepsHue->setChecked(settings.toneMap == trace::ToneMap::hue);
        keepsHue->setEnabled(!trace::isProjection(settings.look));
    });
}

void LookController::addWindow() {
    resetWindow_ = menu_->addAction(tr("Reset &Window"), this, [this] {
        context_.session.change(tr("Window"), [](scene::StudyState& next) {
            next.windows.at(std::size_t(next.settings.look)).reset();
        });
    });
    resetWindow_->setShortcut(keyOf(KeyAction::resetWindow));
    describe(*resetWindow_, "reset-window", tr("Of the values: that of the series"));
    connect(&context_.viewport, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        const auto from = context_.shown.drawing().settings.window;
        if (!from || !context_.session.hasStudy()) return;
        context_.session.drag(tr("Window"), [&](scene::StudyState& next) {
            next.windows.at(std::size_t(next.settings.look)) =
                scene::dragged(*from, {byHeights.x(), byHeights.y()}, *context_.session.study().volume);
        });
    });
    connect(&context_.viewport.window(), &VulkanWindow::dragEnded, &context_.session, &StudyEditor::endDrag);
}

void LookController::showChosen() {
    const trace::Settings& settings = context_.session.state().settings;
    menu_->choose(int(settings.look));
    shading_->setChecked(settings.shading == trace::Shading::headlight);
}

void LookController::showUsable() {
    const trace::Look look = context_.session.state().settings.look;
    shading_->setEnabled(look == trace::Look::dvr);
    resetWindow_->setEnabled(trace::isProjection(look));
}

}  // namespace macula::viewer
