#include "viewer/slices/slice_menu.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QMessageBox>

#include "pipeline/volume/window.h"
#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"
#include "viewer/keys/keys.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/settings/key_book.h"

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
    keep->setObjectName(QStringLiteral("keep-window"));
    keep->setToolTip(SliceMenuWords::tr("Under a name, for all studies with values of this unit"));
    QObject::connect(keep, &QAction::triggered, parent, [of, parent] { askToKeepWindow(of, parent); });
    if (own.empty()) return;
    QMenu* remove = menu.addMenu(SliceMenuWords::tr("&Remove a Window"));
    for (const scene::OwnWindow& window : own) {
        QAction* action = remove->addAction(asTitle(QString::fromStdString(window.name)));
        QObject::connect(action, &QAction::triggered, of.own,
                         [list = of.own, window] { list->remove(window); });
    }
}

}  // namespace

QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    if (of.editLabel) {
        QAction* label = menu->addAction(SliceMenuWords::tr("&Label…\tEnter"));
        label->setObjectName(QStringLiteral("edit-label"));
        label->setToolTip(SliceMenuWords::tr("Words beside this measurement"));
        QObject::connect(label, &QAction::triggered, parent, of.editLabel);
        menu->addSeparator();
    }
    if (of.fit) {
        const QString key =
            KeyBook::ofProgram().chosen(keyOf(KeyAction::fit)).toString(QKeySequence::NativeText);
        QAction* fit = menu->addAction(SliceMenuWords::tr("&Fit the Pane\t%1").arg(key));
        fit->setObjectName(QStringLiteral("fit-slice"));
        fit->setToolTip(SliceMenuWords::tr("The whole slice is seen, in the middle of the pane"));
        QObject::connect(fit, &QAction::triggered, parent, of.fit);
        menu->addSeparator();
    }
    addWindows(*menu, of);
    if (of.own != nullptr) addOwnWindows(*menu, of, parent);
    return menu;
}

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

}  // namespace macula::viewer
