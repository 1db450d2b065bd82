#include "viewer/slices/slice_popups.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <functional>
#include <utility>

#include "base/utf8.h"
#include "pipeline/volume/window.h"
#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"
#include "scene/state/slices_json.h"
#include "viewer/keys/keys.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/settings/key_book.h"

namespace macula::viewer {

namespace {

// Of the label's editor.
constexpr int kWidthPx = 180;
constexpr int kMarginPx = 4;

struct SliceMenuOf {
    StudyEditor* session = nullptr;   // with an open study
    OwnWindowList* own = nullptr;     // null: no own windows
    DisplayWindow window = {};        // the current window
    std::function<void()> editLabel;  // edits the label of the measurement there; empty: no entry
    std::function<void()> fit = {};   // fits the pane that was clicked; empty: no entry
};

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

// Deletes itself when it is closed.
QMenu* makeSliceMenu(const SliceMenuOf& of, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    if (of.editLabel) {
        QAction* label = menu->addAction(SliceMenuWords::tr("&Label…\tEnter"));
        describe(*label, "edit-label", SliceMenuWords::tr("Words beside this measurement"));
        QObject::connect(label, &QAction::triggered, parent, of.editLabel);
        menu->addSeparator();
    }
    if (of.fit) {
        const QString key =
            KeyBook::ofProgram().chosen(keyOf(KeyAction::fit)).toString(QKeySequence::NativeText);
        QAction* fit = menu->addAction(SliceMenuWords::tr("&Fit the Pane\t%1").arg(key));
        describe(*fit, "fit-slice", SliceMenuWords::tr("The whole slice is seen, in the middle of the pane"));
        QObject::connect(fit, &QAction::triggered, parent, of.fit);
        menu->addSeparator();
    }
    addWindows(*menu, of);
    if (of.own != nullptr) addOwnWindows(*menu, of, parent);
    return menu;
}

}  // namespace

LabelEditor::LabelEditor(QWidget* pane, QPoint place, const QString& text)
    : QLineEdit(text, pane), before_(text) {
    setObjectName(QStringLiteral("label-editor"));
    setAccessibleName(tr("Label of the measurement"));
    setToolTip(tr("Label of the measurement. Enter keeps it, Esc leaves it as it was"));
    setPlaceholderText(tr("Label"));
    setMaxLength(int(scene::kLongestLabelBytes));
    resize(std::min(kWidthPx, pane->width() - 2 * kMarginPx), sizeHint().height());
    move(std::clamp(place.x(), kMarginPx, std::max(kMarginPx, pane->width() - width() - kMarginPx)),
         std::clamp(place.y(), kMarginPx, std::max(kMarginPx, pane->height() - height() - kMarginPx)));
    selectAll();
    show();
    setFocus();
}

// Takes all keys: letters of tools and digits of windows are text here.
void LabelEditor::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return finish(true);
    if (event->key() == Qt::Key_Escape) return finish(false);
    QLineEdit::keyPressEvent(event);
    event->accept();
}

void LabelEditor::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason) finish(true);  // its own context menu does not count
}

void LabelEditor::finish(bool isAccepted) {
    if (std::exchange(isDone_, true)) return;
    const std::string typed = text().trimmed().toStdString();
    const QString kept = QString::fromStdString(std::string(startOf(typed, scene::kLongestLabelBytes)));
    const bool hadFocus = hasFocus();
    hide();
    deleteLater();
    if (hadFocus) parentWidget()->setFocus();
    if (isAccepted && kept != before_) Q_EMIT accepted(kept);
}

void SlicePopups::openMenu(const QPointF& place) {
    const SliceRequest* shown = parts_.picture.shownRequest();
    if (shown == nullptr || parts_.measurements.isDrawing() || !shown->showsStudy()) return;
    const bool isMeant = parts_.hand.selectAt(place, *shown);
    parts_.hand.drop();
    std::function<void()> edit;
    if (isMeant) edit = [this, index = *parts_.measurements.selected()] { editLabel(index); };
    QMenu* menu = makeSliceMenu({.session = &parts_.session,
                                 .own = parts_.windowing.own(),
                                 .window = parts_.content.studyWindow(),
                                 .editLabel = std::move(edit),
                                 .fit = [this] { parts_.zoom.fit(); }},
                                &pane_);
    menu->installEventFilter(this);
    menu->popup(pane_.mapToGlobal(place.toPoint()));
    pane_.update();
}

// The second click of a right double-click reaches the menu that the first click opened.
bool SlicePopups::eventFilter(QObject* watched, QEvent* event) {
    auto* menu = qobject_cast<QMenu*>(watched);
    const bool isDouble = event->type() == QEvent::MouseButtonDblClick &&
                          static_cast<const QMouseEvent*>(event)->button() == Qt::RightButton;
    if (menu == nullptr || !isDouble) return QObject::eventFilter(watched, event);
    menu->close();
    parts_.zoom.fit();
    return true;
}

void SlicePopups::editLabel(std::size_t measurement) {
    const auto& measurements = parts_.session.state().measurements;
    const SliceRequest* shown = parts_.picture.shownRequest();
    if (shown == nullptr || measurement >= measurements.size()) return;
    const slices::Measurement edited = measurements[measurement];
    const glm::dvec2 px = shown->frame.pictureFromWorld(handlesOf(edited).front()) / shown->pixelRatio;
    const QString before = QString::fromStdString(edited.label);
    auto* editor = new LabelEditor(&pane_, QPointF(px.x, px.y).toPoint(), before);
    connect(editor, &LabelEditor::accepted, this, [this, edited](const QString& text) {
        parts_.session.change(tr("Label"), [&](scene::StudyState& next) {
            const auto found = std::ranges::find(next.measurements, edited);
            if (found != next.measurements.end()) found->label = text.toStdString();
        });
    });
}

void SlicePopups::closeLabel() {
    delete pane_.findChild<LabelEditor*>();
}

}  // namespace macula::viewer
