// The settings page that shows and changes the keys.
#pragma once

#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QList>
#include <QMap>
#include <QPushButton>
#include <QString>
#include <QTreeWidget>
#include <QWidget>

#include "viewer/settings/key_book.h"

namespace macula::viewer {

// Changes only its own list of chosen keys, which the caller reads from own().
class KeysPage : public QWidget {
    Q_OBJECT

  public:
    KeysPage(QList<KeyEntry> entries, QMap<QString, QString> own, QWidget* parent = nullptr);

    const QMap<QString, QString>& own() const { return own_; }
    QString trouble() const { return trouble_->text(); }  // why the last key was refused; else empty

  private:
    void makeList();
    void search(const QString& words);
    void showCurrent();
    void take(const QKeySequence& key);
    void showKey(int index);
    int current() const;  // in entries_; -1: none

    QList<KeyEntry> entries_;
    QMap<QString, QString> own_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QKeySequenceEdit* key_;
    QPushButton* none_;
    QPushButton* usual_;
    QPushButton* allUsual_;
    QLabel* trouble_;
};

}  // namespace macula::viewer
