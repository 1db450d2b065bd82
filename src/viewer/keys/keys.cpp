#include "viewer/keys/keys.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMainWindow>
#include <QToolBar>
#include <algorithm>

#include "base/check.h"
#include "viewer/keys/slice_tool_keys.h"
#include "viewer/language/window_language.h"
#include "viewer/settings/key_book.h"

namespace macula::viewer {

QKeySequence keyOf(KeyAction action) {
    const auto row = std::ranges::find(kKeys, action, &KeyRow::action);
    MACULA_CHECK(row != kKeys.end());
    return QKeySequence(QString::fromLatin1(row->sequence), QKeySequence::PortableText);
}

QKeySequence keyOf(trace::Look look) {
    static_assert(trace::kLooks.size() == 6, "the rows of KeyAction::look and KeyAction::window name them");
    return QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + int(look)));
}

QKeySequence keyOf(const LayoutRow& row) {
    return QKeySequence(QString::fromLatin1(row.sequence), QKeySequence::PortableText);
}

QString pressedFor(const KeyRow& row) {
    const QString hand = QString::fromUtf8(row.hand);
    const QString key = QString::fromLatin1(row.sequence);
    return hand.isEmpty() || key.isEmpty() ? hand + key : hand + QStringLiteral(", ") + key;
}

std::vector<QKeySequence> keysOf(KeyAction action) {
    std::vector<QKeySequence> keys;
    switch (action) {
        case KeyAction::look:
            for (const trace::LookTraits& look : trace::kLooks) keys.push_back(keyOf(look.look));
            break;
        case KeyAction::panes:
            for (const LayoutRow& row : kLayouts) keys.push_back(keyOf(row));
            break;
        case KeyAction::sliceTool:
            for (const SliceToolRow& row : kSliceTools) keys.push_back(keyOf(row));
            break;
        case KeyAction::panels:
            for (const char* key : kPanelKeys) keys.push_back(QKeySequence(QString::fromLatin1(key)));
            break;
        default:
            if (const QKeySequence key = keyOf(action); !key.isEmpty()) keys.push_back(key);
    }
    return keys;
}

QString chosenFor(const KeyRow& row) {
    const KeyBook& book = KeyBook::ofProgram();
    QStringList keys;
    bool isChanged = false;
    for (const QKeySequence& usual : keysOf(row.action)) {
        const QKeySequence key = book.chosen(usual);
        isChanged = isChanged || key != usual;
        if (!key.isEmpty()) keys << key.toString(QKeySequence::NativeText);
    }
    const QString hand = inWindowsLanguage(Text(row.hand));
    // In a row without a sequence, `hand` names the keys.
    if (row.sequence[0] == '\0') return isChanged ? keys.join(QStringLiteral(", ")) : hand;
    if (!hand.isEmpty()) keys.prepend(hand);
    return keys.join(QStringLiteral(", "));
}

std::optional<KeyAction> actionOf(const QKeyEvent& event) {
    const QKeySequence pressed(event.key());
    const KeyBook& book = KeyBook::ofProgram();
    for (const KeyRow& row : kKeys) {
        if (row.sequence[0] != '\0' && book.chosen(keyOf(row.action)) == pressed) return row.action;
    }
    return std::nullopt;
}

std::optional<ViewDirection> viewDirectionOf(KeyAction action) {
    switch (action) {
        case KeyAction::anterior:
            return ViewDirection::anterior;
        case KeyAction::posterior:
            return ViewDirection::posterior;
        case KeyAction::left:
            return ViewDirection::left;
        case KeyAction::right:
            return ViewDirection::right;
        case KeyAction::superior:
            return ViewDirection::superior;
        case KeyAction::inferior:
            return ViewDirection::inferior;
        default:
            return std::nullopt;
    }
}

QAction* actionFor(const QKeyEvent& keys, const QMainWindow& window, const QToolBar& tools) {
    const QKeySequence pressed(keys.keyCombination());
    for (QAction* action : window.findChildren<QAction*>()) {
        const bool isHidden = !tools.isVisible() && tools.actions().contains(action);
        if (!action->shortcut().isEmpty() && action->shortcut() == pressed && action->isEnabled() &&
            !isHidden)
            return action;
    }
    return nullptr;
}

bool isForList(const QKeyEvent& key) {
    const QWidget* focus = QApplication::focusWidget();
    const bool isList = qobject_cast<const QComboBox*>(focus) != nullptr ||
                        qobject_cast<const QAbstractItemView*>(focus) != nullptr;
    return isList && (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier && key.key() >= Qt::Key_A &&
           key.key() <= Qt::Key_Z;
}

}  // namespace macula::viewer
