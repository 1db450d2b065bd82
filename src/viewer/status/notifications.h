// What the window tells in its message bar, by whichever feature.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include "base/result.h"

namespace macula::viewer {

class MessageBar;

// One message at a time; a new one takes the place of the one before. Lives on the UI thread.
class Notifications : public QObject {
    Q_OBJECT

  public:
    explicit Notifications(QObject* parent = nullptr);

    MessageBar& bar() const { return *bar_; }  // it belongs to the widget that shows it
    QString text() const;                      // empty without a message, or after it was dismissed

    void showError(const Error& error);
    void showNote(const QString& text);
    void hide();
    void fail(const Error& error) { fail(error, error); }
    void fail(const Error& error, const Error& shown);  // emits `failed` with the first
    void failUnlessCancelled(const Error& error);       // of work that a person may cancel in silence
    // What was done: `told`, and how it differs from what was asked for.
    void showDone(const QString& told, const QStringList& notes);
    void showNotesOf(const QStringList& notes);  // no notes: hides the bar
    void showOutcome(const Result<void>& written, const QString& told);
    void showOutcome(const Result<void>& done);  // hides the bar after success
    void refuse(const QString& why, const QString& hint);
    // What a person asked for needs an open study: says so without one, and returns whether there is one.
    bool refuseUnless(bool isOpen, const QString& whyNot);

  Q_SIGNALS:
    void failed(const macula::Error& error);  // of work: scripts and tests listen

  private:
    MessageBar* bar_;
};

}  // namespace macula::viewer
