#include "viewer/slices/slice_menu.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <optional>

#include "pipeline/volume/window.h"
#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"
#include "slices/colour_table.h"
#include "viewer/keys/keys.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/key_book.h"
#include "viewer/slices/typed_window.h"

namespace macula::viewer {

namespace {

struct SliceMenuWords {
    Q_DECLARE_TR_FUNCTIONS(SliceMenu)
};

// Escapes ampersands, which would mark shortcut letters.
QString asTitle(const QString& name) {
    return harmless(name).replace(QLatin1Char('&'), QLatin1String("&&"));
}

// "W 1500 L -600 HU".
QString numbersOf(const DisplayWindow& window, const std::string& unit) {
    return asTitle(withLocalNumbers(QString::fromStdString(scene::windowText(window, unit))));
}

void setWindow(StudyEditor& session, const std::optional<DisplayWindow>& window) {
    session.change(SliceMenuWords::tr("Window"),
                   [&](scene::StudyState& next) { next.slices.window = window; });
}

void addWindows(QMenu& menu, const SliceMenuOf& of) {
    const Volume& volume = *of.session->study().measured();
    for (const scene::WindowPreset& preset : scene::windowPresets(volume)) {
        const DisplayWindow window = preset.window.value_or(seriesWindow(volume));
        QAction* action =
            menu.addAction(QStringLiteral("%1: %2\t%3")
                               .arg(asTitle(titleInWindowsLanguage(preset.name)),
                                    numbersOf(window, volume.unitName()), QString::number(preset.digit)));
        QObject::connect(action, &QAction::triggered, of.session,
                         [session = of.session, window = preset.window] { setWindow(*session, window); });
    }
}

// Asks for a name, and keeps the window under that name.
void askToKeepWindow(const SliceMenuOf& of, QWidget* parent) {
    auto* dialog = new QInputDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::TextInput);
    dialog->setWindowTitle(SliceMenuWords::tr("Keep This Window"));
    const std::string unit = of.session->study().measured()->unitName();
    dialog->setLabelText(SliceMenuWords::tr("Name of the window %1")
                             .arg(harmless(QString::fromStdString(scene::windowText(of.window, unit)))));
    QObject::connect(
        dialog, &QInputDialog::textValueSelected, of.own,
        [list = of.own, window = of.window, unit, parent](const QString& name) {
            const auto added = list->add({.name = name.toStdString(), .window = window, .unit = unit});
            if (added) return;
            auto* box = new QMessageBox(QMessageBox::NoIcon, SliceMenuWords::tr("Keep This Window"),
                                        inWindowsLanguage(added.error()), QMessageBox::Close, parent);
            box->setAttribute(Qt::WA_DeleteOnClose);
            box->open();
        });
    dialog->open();
}

void addOwnWindows(QMenu& menu, const SliceMenuOf& of, QWidget* parent) {
    const Volume& volume = *of.session->study().measured();
    const auto own = of.own->fitting(volume);
    menu.addSeparator();
    for (std::size_t i = 0; i < own.size(); ++i) {
        QString title = QStringLiteral("%1: %2").arg(asTitle(QString::fromStdString(own[i].name)),
                                                     numbersOf(own[i].window, volume.unitName()));
        if (i < 9) title += QStringLiteral("\tAlt+%1").arg(i + 1);
        QAction* action = menu.addAction(title);
        QObject::connect(action, &QAction::triggered, of.session,
                         [session = of.session, window = own[i].window] { setWindow(*session, window); });
    }
    QAction* keep = menu.addAction(SliceMenuWords::tr("&Keep This Window…"));
    describe(*keep, "keep-window",
             SliceMenuWords::tr("Under a name, for all studies with values of this unit"));
    QObject::connect(keep, &QAction::triggered, parent, [of, parent] { askToKeepWindow(of, parent); });
    if (own.empty()) return;
    QMenu* remove = menu.addMenu(SliceMenuWords::tr("&Remove a Window"));
    for (const scene::OwnWindow& window : own) {
        QAction* action = remove->addAction(asTitle(QString::fromStdString(window.name)));
        QObject::connect(action, &QAction::triggered, of.own,
                         [list = of.own, window] { list->remove(window); });
    }
}

QString titleOf(const std::optional<slices::ColourTable>& colours) {
    if (!colours || *colours == slices::ColourTable::grey) return SliceMenuWords::tr("Grey");
    return *colours == slices::ColourTable::hotIron ? SliceMenuWords::tr("Hot iron")
                                                    : SliceMenuWords::tr("Green");
}

void addColours(QMenu& menu, const SliceMenuOf& of) {
    QMenu* colours = menu.addMenu(SliceMenuWords::tr("&Colours"));
    colours->setObjectName(QStringLiteral("slice-colours"));
    const auto now = of.session->state().slices.colours;
    for (const std::optional<slices::ColourTable>& table :
         {std::optional<slices::ColourTable>(), std::optional(slices::ColourTable::hotIron),
          std::optional(slices::ColourTable::green)}) {
        QAction* action = colours->addAction(titleOf(table));
        action->setCheckable(true);
        action->setChecked(table == now);
        QObject::connect(action, &QAction::triggered, of.session, [session = of.session, table] {
            session->change(SliceMenuWords::tr("Colours"),
                            [&](scene::StudyState& next) { next.slices.colours = table; });
        });
    }
}

void addTypedWindow(QMenu& menu, const SliceMenuOf& of, QWidget* parent) {
    const QString key =
        KeyBook::ofProgram().chosen(keyOf(KeyAction::typedWindow)).toString(QKeySequence::NativeText);
    QAction* typed = menu.addAction(SliceMenuWords::tr("&Type a Window…\t%1").arg(key));
    describe(*typed, "type-window-here", SliceMenuWords::tr("Width and level as numbers"));
    QObject::connect(typed, &QAction::triggered, parent,
                     [session = of.session, parent] { askForWindow(*session, parent); });
}

void addPictures(QMenu& menu, const SliceMenuOf& of, QWidget* parent) {
    QAction* copy = menu.addAction(SliceMenuWords::tr("C&opy the Picture\tCtrl+C"));
    describe(*copy, "copy-slice",
             SliceMenuWords::tr("This pane as it is on screen, with its measurements and names"));
    QObject::connect(copy, &QAction::triggered, parent, of.copyPicture);
    QAction* save = menu.addAction(SliceMenuWords::tr("&Save the Picture…"));
    describe(*save, "save-slice",
             SliceMenuWords::tr("This pane as it is on screen, with its measurements and names"));
    QObject::connect(save, &QAction::triggered, parent, of.savePicture);
    QAction* planes = menu.addAction(SliceMenuWords::tr("Save a &Batch of Planes…"));
    describe(*planes, "save-planes",
             SliceMenuWords::tr("Planes like this one, or about a line, as a DICOM series that keeps its "
                                "place in the patient"));
    QObject::connect(planes, &QAction::triggered, parent, of.savePlanes);
}

}  // namespace

QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    if (of.editLabel) {
        QAction* label = menu->addAction(SliceMenuWords::tr("&Label…\tEnter"));
        describe(*label, "edit-label", SliceMenuWords::tr("Words beside this measurement"));
        QObject::connect(label, &QAction::triggered, parent, of.editLabel);
        if (of.isNode) {
            QAction* node = menu->addAction(SliceMenuWords::tr("Lymph &Node"));
            describe(*node, "lymph-node",
                     SliceMenuWords::tr("Its short axis counts in the follow-up, not its long one"));
            node->setCheckable(true);
            node->setChecked(*of.isNode);
            QObject::connect(node, &QAction::triggered, parent, of.setNode);
        }
        menu->addSeparator();
    }
    const QString key = KeyBook::ofProgram().chosen(keyOf(KeyAction::fit)).toString(QKeySequence::NativeText);
    QAction* fit = menu->addAction(SliceMenuWords::tr("&Fit the Pane\t%1").arg(key));
    describe(*fit, "fit-slice", SliceMenuWords::tr("The whole slice is seen, in the middle of the pane"));
    QObject::connect(fit, &QAction::triggered, parent, of.fit);
    menu->addSeparator();
    addWindows(*menu, of);
    addTypedWindow(*menu, of, parent);
    if (of.own != nullptr) addOwnWindows(*menu, of, parent);
    menu->addSeparator();
    addColours(*menu, of);
    addPictures(*menu, of, parent);
    return menu;
}

}  // namespace macula::viewer
