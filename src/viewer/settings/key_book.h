// Which keys a person has chosen instead of the usual ones of viewer/keys/keys.h.
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

// One thing that a key does.
struct KeyEntry {
    QString id;  // its usual key, as files have it, which no other has; "#" and the action's name without one
    QString title;  // "File: Save Picture…"
    QKeySequence usual;
    bool isOfPicture = false;  // only while a picture has the focus: one key, without Ctrl or Alt
};

// Code asks for usual keys and gives them to actions; the book knows the actions of a window by them, and
// gives each the one that was chosen. So whatever is added to a menu can be changed without being listed
// anywhere. One book for the program; on the UI thread.
class KeyBook : public QObject {
    Q_OBJECT

  public:
    static KeyBook& ofProgram();

    // By KeyEntry::id; the portable text of a key, empty for none. What is no key is left out.
    void setOwn(const QMap<QString, QString>& own);
    const QMap<QString, QString>& own() const { return own_; }

    QKeySequence chosen(const QKeySequence& usual) const;
    QKeySequence chosen(const KeyEntry& entry) const;

    // Writes `usual`, or the key that a person chose for it, beside the text of the action. The viewport
    // handles the key: it is no shortcut of the action.
    static void showPictureKey(QAction& action, const QKeySequence& usual);

    // All that can be changed, in the order of menus, then of tool bars. Those that it has not seen before
    // have their usual keys.
    static QList<KeyEntry> entriesOf(const QMainWindow& window);
    // Gives actions the keys that are chosen.
    void applyTo(QMainWindow& window) const;

  signals:
    void changed();

  private:
    KeyBook() = default;

    QMap<QString, QString> own_;
};

// Why the entry cannot have this key: a sentence; nothing where it can. `own` is what is chosen for others.
std::optional<QString> troubleWith(const QKeySequence& key, const KeyEntry& entry, const QList<KeyEntry>& all,
                                   const QMap<QString, QString>& own);
// Without those that trouble is with, as after a file was edited by hand.
QMap<QString, QString> withoutTrouble(const QMap<QString, QString>& own, const QList<KeyEntry>& all);
QKeySequence keyIn(const QMap<QString, QString>& own, const KeyEntry& entry);

}  // namespace macula::viewer
