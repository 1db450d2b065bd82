#include "viewer/status/study_notes.h"

#include <utility>

#include "viewer/status/status_widgets.h"
#include "viewer/status/study_texts.h"

namespace macula::viewer {

StudyNotes::StudyNotes(QObject* parent) : QObject(parent), bar_(new MessageBar) {}

QString StudyNotes::text() const {
    return bar_->isVisible() ? bar_->text() : QString();
}

bool StudyNotes::set(NoteOn what, const QStringList& notes) {
    return std::exchange(notes_.at(std::size_t(what)), notes) != notes;
}

bool StudyNotes::set(NoteOn what, const QString& note) {
    return set(what, note.isEmpty() ? QStringList() : QStringList{note});
}

void StudyNotes::ask(NoteOn what, std::function<QStringList()> source) {
    sources_.at(std::size_t(what)) = std::move(source);
}

void StudyNotes::show() {
    QStringList all;
    for (std::size_t kind = 0; kind < kKinds; ++kind)
        all += sources_.at(kind) ? sources_.at(kind)() : notes_.at(kind);
    if (all.isEmpty()) {
        bar_->hide();
    } else {
        bar_->showNote(withoutRepeats(all).join(QLatin1Char(' ')));
    }
}

void StudyNotes::showIfOther(NoteOn what, const QString& note) {
    if (set(what, note)) show();
}

}  // namespace macula::viewer
