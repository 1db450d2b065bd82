// The window's message bar, which all features share.
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
    void fail(const Error& error, const Error& shown);  // emits `failed` with `error`, shows `shown`
    void failUnlessCancelled(const Error& error);       // shows nothing if a person cancelled
    // Shows the sentence `told` about finished work, and how the result differs from the request.
    void showDone(const QString& told, const QStringList& notes);
    void showNotesOf(const QStringList& notes);  // no notes: hides the bar
    void showOutcome(const Result<void>& written, const QString& told);
    void showOutcome(const Result<void>& done);  // hides the bar after success
    void refuse(const QString& why, const QString& hint);
    // For an action that needs an open study: without one, shows `whyNot`. Returns `isOpen`.
    bool refuseUnless(bool isOpen, const QString& whyNot);

  Q_SIGNALS:
    void failed(const macula::Error& error);  // work has failed: scripts and tests listen

  private:
    MessageBar* bar_;
};

}  // namespace macula::viewer
