#include "viewer/status/notifications.h"

#include "viewer/status/status_widgets.h"

namespace macula::viewer {

Notifications::Notifications(QObject* parent) : QObject(parent), bar_(new MessageBar) {}

QString Notifications::text() const {
    return bar_->isVisible() ? bar_->text() : QString();
}

void Notifications::showError(const Error& error) {
    bar_->showError(error);
}

void Notifications::showNote(const QString& text) {
    bar_->showNote(text);
}

void Notifications::hide() {
    bar_->hide();
}

void Notifications::fail(const Error& error, const Error& shown) {
    bar_->showError(shown);
    Q_EMIT failed(error);
}

void Notifications::failUnlessCancelled(const Error& error) {
    if (error.code != ErrorCode::cancelled) fail(error);
}

void Notifications::showDone(const QString& told, const QStringList& notes) {
    bar_->showNote((QStringList{told} + notes).join(QLatin1Char(' ')));
}

void Notifications::showNotesOf(const QStringList& notes) {
    if (notes.isEmpty()) {
        bar_->hide();
    } else {
        bar_->showNote(notes.join(QLatin1Char(' ')));
    }
}

void Notifications::showOutcome(const Result<void>& written, const QString& told) {
    if (written) {
        bar_->showNote(told);
    } else {
        bar_->showError(written.error());
    }
}

void Notifications::showOutcome(const Result<void>& done) {
    if (done) {
        bar_->hide();
    } else {
        bar_->showError(done.error());
    }
}

void Notifications::refuse(const QString& why, const QString& hint) {
    bar_->showError(
        {ErrorCode::usage, Text::verbatim(why.toStdString()), {}, Text::verbatim(hint.toStdString())});
}

bool Notifications::refuseUnless(bool isOpen, const QString& whyNot) {
    if (!isOpen) refuse(whyNot, tr("Open a study first."));
    return isOpen;
}

}  // namespace macula::viewer
