#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/links/links_controller.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QStringList>

#include "viewer/archive/archive_controller.h"
#include "viewer/language/window_language.h"
#include "viewer/links/link_choice.h"
#include "viewer/links/link_question.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

LinksController::LinksController(const WindowContext& context, ArchiveController& archive)
    : QObject(&context.window),
      context_(context),
      archive_(archive),
      bar_(new WorkBar),
      search_(this, {.progressed =
                         [this](const ProgressUpdate& update) {
                             bar_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                         },
                     .ended = [this](const Result<study::LinkedStudies>& found) { showFound(found); }}) {
    connect(bar_, &WorkBar::cancelClicked, this, [this] {
        search_.cancel();
        bar_->hide();
    });
}

void LinksController::open(const QString& link) {
    if (question_ != nullptr) {
        question_->raise();
        question_->activateWindow();
        return context_.notifications.refuse(
            tr("Another link came while a question about a link was open, and was not followed."),
            tr("Answer the question, then click on the link again."));
    }
    context_.viewport.window().endDrag();
    const auto asked = study::studyLinkOf(link.toStdString());
    if (!asked) return context_.notifications.fail(asked.error());
    const auto sources = net::SourceList::read(net::SourceFiles::ofUser());
    if (!sources) return context_.notifications.fail(sources.error());
    const auto from = study::sourcesFor(*asked, *sources);
    if (!from) return context_.notifications.fail(from.error());
    question_ = askToFetch(&context_.window, *asked, *from, showsNames_,
                           [this, asked = *asked, sources = *sources] { search(asked, sources); });
}

void LinksController::search(const study::StudyLink& link, const net::SourceList& sources) {
    bar_->begin(tr("Asking for the study"));
    isByUid_ = !link.studyInstanceUids.empty();
    search_.start([link, sources](Progress& progress) { return study::findLinked(link, sources, progress); });
}

void LinksController::showFound(const Result<study::LinkedStudies>& found) {
    bar_->hide();
    if (!found) return context_.notifications.failUnlessCancelled(found.error());
    // With remarks, as of an archive that could not be asked, the right one may be another.
    if (found->studies.size() == 1 && (isByUid_ || found->remarks.empty())) {
        if (!found->remarks.empty())
            context_.notifications.showNote(inWindowsLanguage(found->remarks).join(QStringLiteral(" ")));
        return fetch(found->studies.front());
    }
    auto* choice = new LinkChoice(*found, showsNames_, &context_.window);
    choice->setAttribute(Qt::WA_DeleteOnClose);
    connect(choice, &LinkChoice::chosen, this, &LinksController::fetch);
    question_ = choice;
    choice->open();
}

void LinksController::fetch(const study::LinkedStudy& study) {
    archive_.fetchFrom(QString::fromStdString(study.archive), study.study);
}

}  // namespace macula::viewer
