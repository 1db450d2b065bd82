#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/archive/archive_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "dicom/best_volume.h"
#include "dicom/scan.h"
#include "net/connect.h"
#include "viewer/archive/archive_panel.h"
#include "viewer/archive/source_dialog.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

struct Way {
    net::Source source;
    net::Secrets secrets;
};

Result<Way> wayTo(const net::SourceList& sources, const QString& name) {
    MACULA_TRY(net::Source source, sources.find(name.toStdString()));
    MACULA_TRY(net::Secrets secrets, sources.secretsOf(source));
    return Way{std::move(source), std::move(secrets)};
}

}  // namespace

ArchiveController::ArchiveController(const WindowContext& context, OpeningController& opening)
    : QObject(&context.window),
      context_(context),
      opening_(opening),
      panel_(new ArchivePanel),
      bar_(new WorkBar),
      search_(this, {.ended =
                         [this](const Result<net::StudyAnswers>& answers) {
                             panel_->setSearching(false);
                             if (answers) {
                                 panel_->setAnswers(*answers);
                                 Q_EMIT answered(searched_);
                             } else {
                                 panel_->setRemark(inWindowsLanguage(answers.error()));
                             }
                         }}),
      fetch_(this, {.progressed =
                        [this](const ProgressUpdate& update) {
                            bar_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                        },
                    .ended = [this](const Result<study::FetchedStudy>& fetched) { showWhole(fetched); }}),
      look_(this, {.ended = [this](const Result<std::filesystem::path>& folder) {
                if (folder && !folder->empty()) showPart(*folder);
            }}) {
    connect(panel_, &ArchivePanel::searchAsked, this, &ArchiveController::search);
    connect(panel_, &ArchivePanel::openAsked, this, &ArchiveController::fetch);
    connect(panel_, &ArchivePanel::setUpAsked, this, &ArchiveController::setUp);
    connect(bar_, &WorkBar::cancelClicked, this, &ArchiveController::cancel);
    context_.notes.setSource(NoteOn::archive, [this] { return notes(); });
    readSources();
}

void ArchiveController::cancel() {
    if (!fetch_.cancel()) return;
    look_.cancel();
    bar_->hide();
    panel_->setRemark(
        tr("Fetching was cancelled. What came is kept; opening the study again goes on from there."));
    context_.notes.show();
}

void ArchiveController::addAction(QMenu& file) {
    QAction* open = file.addAction(tr("Open from an &Archive…"), this, [this] {
        if (!shown_->isChecked()) shown_->trigger();
        readSources();
        panel_->focusSearch();
    });
    open->setShortcut(keyOf(KeyAction::openArchive));
    open->setToolTip(tr("Search a PACS, and fetch a study from it"));
}

void ArchiveController::showNames(bool shown) {
    panel_->showNames(shown);
}

void ArchiveController::readSources() {
    auto read = net::SourceList::read(net::SourceFiles::ofUser());
    if (!read) {
        panel_->setRemark(inWindowsLanguage(read.error()));
        return;
    }
    sources_ = *std::move(read);
    panel_->setSources(sources_->all());
}

void ArchiveController::setUp() {
    if (!sources_) return;
    context_.viewport.window().endDrag();
    SourceDialog dialog(*sources_, &context_.window);
    dialog.exec();
    readSources();
}

void ArchiveController::search(const net::StudyQuery& query) {
    if (!sources_) return;
    auto way = wayTo(*sources_, panel_->source());
    if (!way) return panel_->setRemark(inWindowsLanguage(way.error()));
    searched_ = panel_->source();
    panel_->setSearching(true);
    panel_->setRemark(tr("Searching…"));
    search_.start([way = *std::move(way), query](Progress& progress) -> Result<net::StudyAnswers> {
        MACULA_TRY(const auto archive, net::archiveOf(way.source, way.secrets));
        return archive->findStudies(query, progress);
    });
}

void ArchiveController::fetch(const net::FoundStudy& study) {
    if (!sources_ || (fetch_.running() && coming_.studyInstanceUid == study.studyInstanceUid)) return;
    // The one that was searched, whichever is chosen by now: a UID means nothing to another one.
    auto way = wayTo(*sources_, searched_);
    if (!way) return panel_->setRemark(inWindowsLanguage(way.error()));
    look_.cancel();
    coming_ = {.number = coming_.number + 1,
               .studyInstanceUid = study.studyInstanceUid,
               .openBefore = opening_.loader().source()};
    panel_->setRemark(QString());
    bar_->begin(tr("Fetching a study"));
    const NewestPosted<study::Arrival> arrived(
        this, [this, number = coming_.number](const study::Arrival& arrival) { lookAt(number, arrival); });
    const study::FetchRequest request{.studyInstanceUid = study.studyInstanceUid,
                                      .chosen = study::identityOf(study)};
    fetch_.start(
        [way = *std::move(way), request, arrived](Progress& progress) -> Result<study::FetchedStudy> {
            MACULA_TRY(const auto archive, net::archiveOf(way.source, way.secrets));
            MACULA_TRY(study::Spool spool, study::Spool::open());
            return study::fetchStudy(*archive, way.source.name, request, spool, progress, arrived);
        });
}

// Reading headers takes a part of the time in which they come: each time there are twice as many images, all
// looks together read each header twice. What cannot be shown yet is no error.
void ArchiveController::lookAt(std::uint64_t number, const study::Arrival& arrival) {
    if (number != coming_.number || !fetch_.running() || look_.running() || opening_.loader().loading())
        return;
    if (arrival.instances < 2 * coming_.lookedAt) return;
    coming_.lookedAt = arrival.instances;
    coming_.folder = arrival.folder;
    look_.start([folder = arrival.folder](Progress& progress) -> Result<std::filesystem::path> {
        MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(folder, progress));
        return dicom::bestVolume(scan) ? folder : std::filesystem::path();
    });
}

void ArchiveController::showPart(const std::filesystem::path& folder) {
    if (fetch_.running() && !isOtherOpen()) opening_.open(folder);
}

bool ArchiveController::isOtherOpen() const {
    const study::StudySource& open = opening_.loader().source();
    return open != coming_.openBefore && open != study::StudySource(coming_.folder);
}

void ArchiveController::showWhole(const Result<study::FetchedStudy>& fetched) {
    bar_->hide();
    look_.cancel();
    if (!fetched) {
        panel_->setRemark(inWindowsLanguage(fetched.error()));
        context_.notifications.failUnlessCancelled(fetched.error());
        context_.notes.show();
        return;
    }
    if (coming_.folder.empty()) coming_.folder = fetched->folder;
    QStringList told{tr("%n images fetched", nullptr, int(fetched->counts.kept))};
    for (const Message& message : fetched->messages) told.append(inWindowsLanguage(message));
    if (isOtherOpen())
        told.append(tr("Another study was opened meanwhile. Open shows this one."));
    else
        opening_.open(fetched->folder);
    panel_->setRemark(told.join(QStringLiteral("\n")));
}

// A part of a study must not pass for all of it.
QStringList ArchiveController::notes() const {
    const study::StudySource& open = opening_.loader().source();
    const auto record = open ? study::useSpooled(*open) : std::nullopt;
    if (!record || record->isComplete) return {};
    if (fetch_.running() && *open == coming_.folder)
        return {tr("Images of this study are still arriving from the archive.")};
    return {
        tr("This study is not known to be complete: images that the archive has may be missing. Fetch it "
           "again.")};
}

}  // namespace macula::viewer
