#include "viewer/look/background_menu.h"

#include <QColorDialog>
#include <algorithm>
#include <array>
#include <cstdint>

namespace macula::viewer {

namespace {

// In the order of the entries.
constexpr std::array<std::optional<scene::BackgroundColour>, 4> kOffered{
    std::nullopt, scene::kBlackBackground, scene::BackgroundColour{128, 128, 128},
    scene::BackgroundColour{255, 255, 255}};

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
    other->setObjectName(QStringLiteral("background-other"));
    other->setToolTip(tr("Of what lies behind the patient in the 3D picture, and in pictures saved of it"));
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

}  // namespace macula::viewer
