// The keys that a person chose instead of those in viewer/keys/keys.h.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QObject>
#include <QString>
#include <optional>

class QMainWindow;

namespace macula::viewer {

// An action with a configurable key.
struct KeyEntry {
    QString id;     // unique: its usual key as files have it, else "#" and the action's name
    QString title;  // "File: Save Picture…"
    QKeySequence usual;
    bool isOfPicture = false;  // works while a picture has the focus: one key, no modifiers
};

// Code gives actions their usual keys. The book identifies the actions of a window by these keys, and
// replaces each with the chosen key, so that a new menu action is configurable without being listed. One book
// for the program; on the UI thread.
class KeyBook : public QObject {
    Q_OBJECT

  public:
    static KeyBook& ofProgram();

    // Maps KeyEntry::id to the portable text of a key, empty for no key. Invalid texts are left out.
    void setOwn(const QMap<QString, QString>& own);
    const QMap<QString, QString>& own() const { return own_; }

    QKeySequence chosen(const QKeySequence& usual) const;
    QKeySequence chosen(const KeyEntry& entry) const;

    // Writes `usual`, or the key that a person chose instead, beside the text of the action. The viewport
    // handles the key: it is not the action's shortcut.
    static void showPictureKey(QAction& action, const QKeySequence& usual);

    // All configurable entries, in the order of menus, then of tool bars. `usual` of an action not seen
    // before is its present key.
    static QList<KeyEntry> entriesOf(const QMainWindow& window);
    // Gives the window's actions the chosen keys.
    void applyTo(QMainWindow& window) const;

  Q_SIGNALS:
    void changed();

  private:
    KeyBook() = default;

    QMap<QString, QString> own_;
};

// Says in a sentence why the entry cannot have this key; nothing if it can. `own`: all chosen keys.
std::optional<QString> troubleWith(const QKeySequence& key, const KeyEntry& entry, const QList<KeyEntry>& all,
                                   const QMap<QString, QString>& own);
// `own` without invalid keys, such as from a file edited by hand.
QMap<QString, QString> withoutTrouble(const QMap<QString, QString>& own, const QList<KeyEntry>& all);
QKeySequence keyIn(const QMap<QString, QString>& own, const KeyEntry& entry);

}  // namespace macula::viewer
