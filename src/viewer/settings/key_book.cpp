#include "viewer/settings/key_book.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QToolBar>
#include <QVariant>
#include <algorithm>
#include <array>

namespace macula::viewer {

namespace {

constexpr const char* kUsualKeys = "usual-keys";    // an action's usual keys; the first is its id
constexpr const char* kPictureKey = "picture-key";  // its usual key, if the viewport handles that
constexpr const char* kPlainText = "text-without-key";

struct Words {
    Q_DECLARE_TR_FUNCTIONS(KeyBook)
};

QString portable(const QKeySequence& key) {
    return key.toString(QKeySequence::PortableText);
}

QKeySequence fromPortable(const QString& text) {
    return QKeySequence(text, QKeySequence::PortableText);
}

// The keys that the action was made with, noted the first time it is seen.
QList<QKeySequence> usualKeysOf(QAction& action) {
    const QVariant noted = action.property(kUsualKeys);
    if (noted.isValid()) return noted.value<QList<QKeySequence>>();
    const QList<QKeySequence> keys = action.shortcuts();
    action.setProperty(kUsualKeys, QVariant::fromValue(keys));
    return keys;
}

QString plainText(const QAction& action) {
    const QVariant noted = action.property(kPlainText);
    QString text = noted.isValid() ? noted.toString() : action.text();
    static const QString kEscaped = QStringLiteral("&&");
    QString plain;
    for (const QString& part : text.section(QLatin1Char('\t'), 0, 0).split(kEscaped))
        plain += (plain.isNull() ? QString() : QStringLiteral("&")) + QString(part).remove(QLatin1Char('&'));
    return plain;
}

std::optional<KeyEntry> entryOf(QAction& action, const QString& where) {
    KeyEntry entry{.title = where + QStringLiteral(": ") + plainText(action)};
    if (const QVariant key = action.property(kPictureKey); key.isValid()) {
        entry.usual = key.value<QKeySequence>();
        entry.isOfPicture = true;
    } else if (const QList<QKeySequence> keys = usualKeysOf(action); !keys.isEmpty()) {
        entry.usual = keys.front();
    }
    if (entry.usual == QKeySequence(Qt::Key_Escape)) return std::nullopt;  // cancels things in every program
    if (!entry.usual.isEmpty()) {
        entry.id = portable(entry.usual);
    } else if (!action.objectName().isEmpty()) {
        entry.id = QLatin1Char('#') + action.objectName();
    } else {
        return std::nullopt;  // nothing could identify it in the next run
    }
    return entry;
}

void forEachIn(const QMenu& menu, const QString& where, const auto& visit) {
    for (QAction* action : menu.actions()) {
        if (action->isSeparator()) continue;
        if (const QMenu* inner = action->menu()) {
            forEachIn(*inner, where + QStringLiteral(", ") + plainText(*action), visit);
        } else {
            visit(*action, where);
        }
    }
}

// Visits only the actions of a tool bar that have a key: others are in a menu too, or are controls.
void forEachAction(const QMainWindow& window, const auto& visit) {
    QSet<const QAction*> seen;
    const auto once = [&](QAction& action, const QString& where) {
        if (seen.contains(&action)) return;
        seen.insert(&action);
        visit(action, where);
    };
    for (QAction* action : window.menuBar()->actions()) {
        if (const QMenu* menu = action->menu()) forEachIn(*menu, plainText(*action), once);
    }
    for (const QToolBar* bar : window.findChildren<QToolBar*>()) {
        for (QAction* action : bar->actions()) {
            if (!usualKeysOf(*action).isEmpty()) once(*action, bar->windowTitle());
        }
    }
}

void writeBeside(QAction& action, const QKeySequence& key) {
    const QString plain = action.property(kPlainText).toString();
    action.setText(key.isEmpty() ? plain
                                 : plain + QLatin1Char('\t') + key.toString(QKeySequence::NativeText));
}

// Keys that panes, lists and fields use themselves.
bool isTakenByPanes(const QKeyCombination& key) {
    constexpr std::array kTaken{Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,      Qt::Key_Down,
                                Qt::Key_Home,   Qt::Key_End,   Qt::Key_PageUp,  Qt::Key_PageDown,
                                Qt::Key_Space,  Qt::Key_Tab,   Qt::Key_Backtab, Qt::Key_Escape,
                                Qt::Key_Return, Qt::Key_Enter, Qt::Key_Delete,  Qt::Key_Backspace,
                                Qt::Key_Insert, Qt::Key_Plus,  Qt::Key_Minus,   Qt::Key_Equal};
    const Qt::KeyboardModifiers others = key.keyboardModifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others != Qt::NoModifier) return false;
    return std::ranges::find(kTaken, key.key()) != kTaken.end() ||
           (key.key() >= Qt::Key_0 && key.key() <= Qt::Key_9);
}

}  // namespace

KeyBook& KeyBook::ofProgram() {
    static KeyBook book;
    return book;
}

void KeyBook::setOwn(const QMap<QString, QString>& own) {
    QMap<QString, QString> usable;
    for (auto key = own.begin(); key != own.end(); ++key) {
        if (key.value().isEmpty() || fromPortable(key.value()).count() == 1)
            usable.insert(key.key(), key.value());
    }
    if (usable == own_) return;
    own_ = usable;
    Q_EMIT changed();
}

QKeySequence KeyBook::chosen(const QKeySequence& usual) const {
    const auto own = own_.constFind(portable(usual));
    return own == own_.constEnd() ? usual : fromPortable(*own);
}

QKeySequence KeyBook::chosen(const KeyEntry& entry) const {
    return keyIn(own_, entry);
}

void KeyBook::showPictureKey(QAction& action, const QKeySequence& usual) {
    action.setProperty(kPictureKey, QVariant::fromValue(usual));
    action.setProperty(kPlainText, action.text());
    writeBeside(action, ofProgram().chosen(usual));
}

QList<KeyEntry> KeyBook::entriesOf(const QMainWindow& window) {
    QList<KeyEntry> entries;
    forEachAction(window, [&](QAction& action, const QString& where) {
        if (auto entry = entryOf(action, where)) entries << *std::move(entry);
    });
    return entries;
}

void KeyBook::applyTo(QMainWindow& window) const {
    forEachAction(window, [&](QAction& action, const QString& where) {
        const auto entry = entryOf(action, where);
        if (!entry) return;
        if (entry->isOfPicture) return writeBeside(action, chosen(*entry));
        const QList<QKeySequence> usual = usualKeysOf(action);
        const QList<QKeySequence> wanted =
            own_.contains(entry->id) ? QList<QKeySequence>{chosen(*entry)} : usual;
        if (action.shortcuts() != wanted) action.setShortcuts(wanted);
    });
}

QKeySequence keyIn(const QMap<QString, QString>& own, const KeyEntry& entry) {
    const auto key = own.constFind(entry.id);
    return key == own.constEnd() ? entry.usual : fromPortable(*key);
}

std::optional<QString> troubleWith(const QKeySequence& key, const KeyEntry& entry, const QList<KeyEntry>& all,
                                   const QMap<QString, QString>& own) {
    if (key.isEmpty()) return std::nullopt;
    if (key.count() > 1) return Words::tr("Only one key at a time can be taken, with Ctrl, Shift or Alt.");
    const QString name = key.toString(QKeySequence::NativeText);
    if (isTakenByPanes(key[0]))
        return Words::tr("%1 is used in panes, lists and fields. Take another key.").arg(name);
    if (entry.isOfPicture && key[0].keyboardModifiers() != Qt::NoModifier)
        return Words::tr(
            "This works in the picture, with one key alone. Take one without Ctrl, Shift or "
            "Alt.");
    for (const KeyEntry& other : all) {
        if (other.id != entry.id && keyIn(own, other) == key)
            return Words::tr("%1 is the key of “%2”. Change that one first, or take another key.")
                .arg(name, other.title);
    }
    return std::nullopt;
}

QMap<QString, QString> withoutTrouble(const QMap<QString, QString>& own, const QList<KeyEntry>& all) {
    QMap<QString, QString> usable = own;
    for (const KeyEntry& entry : all) {
        if (usable.contains(entry.id) && troubleWith(keyIn(usable, entry), entry, all, usable))
            usable.remove(entry.id);
    }
    return usable;
}

}  // namespace macula::viewer
