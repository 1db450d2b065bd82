#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/archive/archive_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <chrono>
#include <utility>

#include "dicom/best_volume.h"
#include "dicom/scan.h"
#include "viewer/archive/archive_panel.h"
#include "viewer/archive/archive_way.h"
#include "viewer/archive/found_study_list.h"
#include "viewer/archive/priors_controller.h"
#include "viewer/archive/read_marks.h"
#include "viewer/archive/series_pictures.h"
#include "viewer/archive/source_dialog.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kRenewedEvery{1000};

}  // namespace

ArchiveController::ArchiveController(const WindowContext& context, Parts parts)
    : QObject(&context.window),
      context_(context),
      parts_(parts),
      panel_(new ArchivePanel),
      fetcher_(new StudyFetcher(this)),
      priors_(new PriorsController(context, {.panel = *panel_,
                                             .settings = parts.settings,
                                             .fetcher = *fetcher_,
                                             .sources = [this] { return sources_ ? &*sources_ : nullptr; },
                                             .folders = [this] { return foldersHere(); }})),
      series_(new SeriesPictures(panel_->series(), this)),
      search_(this, {.ended =
                         [this](const Result<study::Listing>& listing) {
                             panel_->setSearching(false);
                             if (!listing) return;
                             shownListing_ = *listing;
                             panel_->setListing(*listing, true);
                             tellWhoAnswered(*listing);
                         }}),
      renewal_(this, {.ended =
                          [this](const Result<study::Listing>& listing) {
                              if (!listing) return;
                              shownListing_ = *listing;
                              panel_->renewListing(*listing);
                          }}),
      look_(this, {.ended = [this](const Result<std::filesystem::path>& folder) {
                if (folder && !folder->empty()) showPart(*folder);
            }}) {
    connectPanel();
    connectFetcher();
    renewalTimer_.setSingleShot(true);
    connect(&renewalTimer_, &QTimer::timeout, this, &ArchiveController::renewListing);
    context_.notes.setSource(NoteOn::archive, [this] { return notes(); });
    readSources();
}

void ArchiveController::connectPanel() {
    connect(panel_, &ArchivePanel::searchAsked, this, &ArchiveController::search);
    connect(panel_, &ArchivePanel::setUpAsked, this, &ArchiveController::setUp);
    connect(panel_, &ArchivePanel::cancelAsked, this, [this] {
        if (!search_.cancel()) return;
        ++searches_;
        panel_->setSearching(false);
        panel_->setRemark(tr("The search was stopped."));
    });
    for (FoundStudyList* list : {&panel_->found(), &panel_->priors()}) {
        connect(list, &FoundStudyList::openAsked, this, &ArchiveController::open);
        connect(list, &FoundStudyList::besideAsked, this, &ArchiveController::openBeside);
        connect(list, &FoundStudyList::fetchAsked, this,
                [this](const study::ListedStudy& listed) { fetch(listed, FetchFor::keep); });
    }
    connect(&panel_->found(), &FoundStudyList::selectionChanged, this, &ArchiveController::showSeries);
    panel_->found().setColumns(parts_.settings.settings().archiveColumns);
    connect(&panel_->found(), &FoundStudyList::columnsChanged, this,
            [this] { parts_.settings.keepArchiveColumns(panel_->found().columns()); });
}

void ArchiveController::showSeries() {
    if (sources_) series_->select(panel_->found().selected(), *sources_);
}

void ArchiveController::connectFetcher() {
    connect(fetcher_, &StudyFetcher::arrived, this, &ArchiveController::lookAt);
    connect(fetcher_, &StudyFetcher::ended, this, &ArchiveController::finish);
    connect(fetcher_, &StudyFetcher::cancelled, this, [this] {
        look_.cancel();
        panel_->setRemark(
            tr("Fetching was cancelled. What came is kept; opening the study again goes on from there."));
        context_.notes.show();
    });
}

void ArchiveController::addAction(QMenu& file) {
    QAction* open = file.addAction(tr("Open from an &Archive…"), this, [this] {
        if (!shown_->isChecked()) shown_->trigger();
        readSources();
        panel_->focusSearch();
    });
    open->setShortcut(keyOf(KeyAction::openArchive));
    open->setToolTip(tr("Search a PACS, and fetch a study from it"));
    read_ = file.addAction(tr("Study Is &Read"), this,
                           [this](bool isRead) { marks_->setRead(uidOnScreen(), isRead); });
    describe(*read_, "study-is-read", tr("Mark the open study as read, in the lists of studies"));
    read_->setCheckable(true);
    showReadMark();
}

void ArchiveController::setMarks(ReadMarks* marks) {
    marks_ = marks;
    panel_->found().setMarks(marks);
    panel_->priors().setMarks(marks);
    connect(marks, &ReadMarks::changed, this, &ArchiveController::showReadMark);
    connect(marks, &ReadMarks::failed, this, [this] {
        context_.notifications.fail({.code = ErrorCode::outputNotWritable,
                                     .message = Text("The mark could not be kept."),
                                     .where = {},
                                     .hint = Text("Is the disk full?")});
    });
}

void ArchiveController::onImagesShown(const std::optional<study::Identity>& identity) {
    uidOfImages_ = identity ? identity->studyInstanceUid : std::string();
    if (marks_ != nullptr && !uidOfImages_.empty()) marks_->noteOpened(uidOfImages_);
    showReadMark();
}

const std::string& ArchiveController::uidOnScreen() const {
    return uidOfImages_.empty() ? context_.session.study().identity.studyInstanceUid : uidOfImages_;
}

void ArchiveController::showReadMark() {
    if (read_ == nullptr) return;
    const std::string& uid = uidOnScreen();
    read_->setEnabled(marks_ != nullptr && !uid.empty());
    read_->setChecked(marks_ != nullptr && marks_->of(uid) == ReadMark::read);
}

void ArchiveController::showNames(bool shown) {
    panel_->showNames(shown);
}

void ArchiveController::onStudyShown() {
    panel_->found().setCanOpenBeside(true);
    // The loader's is what was asked for last, which may not have opened, and none for another series.
    const study::StudySource& source = parts_.opening.loader().source();
    const std::string& uid = context_.session.study().identity.studyInstanceUid;
    if (source || uid != shownUid_) shownSource_ = source;
    shownUid_ = uid;
    context_.notes.show();
    if (marks_ != nullptr) marks_->noteOpened(uid);
    showReadMark();
    priors_->onStudyShown(shownSource_);
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
    series_->forgetArchives();
    showSeries();
}

void ArchiveController::search(const net::StudyQuery& query) {
    if (!sources_) return;
    const SearchedPlaces where = panel_->places();
    study::PlacesToSearch places{.archives = {}, .isHereToo = where.isHereToo, .folders = {}};
    for (const QString& name : where.archives) places.archives.push_back(namedArchive(*sources_, name));
    if (where.isHereToo) places.folders = foldersHere();
    searched_ = where.archives;
    query_ = where.isHereToo ? std::optional(query) : std::nullopt;
    shownListing_.reset();
    renewal_.cancel();
    panel_->setListing({}, false);
    panel_->setSearching(true);
    const NewestPosted<study::Listing> soFar(this,
                                             [this, number = ++searches_](const study::Listing& listing) {
                                                 if (number == searches_ && search_.running())
                                                     panel_->setListing(listing, false);
                                             });
    search_.start([places = std::move(places), query, soFar](Progress& progress) -> Result<study::Listing> {
        return study::searchStudies(places, query, progress, soFar);
    });
}

// Studies that others send are listed while they arrive, where the last search looked on this machine too.
void ArchiveController::onStudiesReceived() {
    if (!renewalTimer_.isActive()) renewalTimer_.start(kRenewedEvery);
}

void ArchiveController::renewListing() {
    if (!query_ || !shownListing_ || search_.running()) return;
    if (renewal_.running()) return onStudiesReceived();
    renewal_.start([listing = *shownListing_, query = *query_](Progress& progress) -> Result<study::Listing> {
        return study::withStudiesHere(listing, query, progress.token());
    });
}

void ArchiveController::tellWhoAnswered(const study::Listing& listing) {
    for (const QString& name : std::as_const(searched_)) {
        const bool isSilent = std::ranges::any_of(listing.silent, [&](const study::SilentArchive& each) {
            return QString::fromStdString(each.name) == name;
        });
        if (!isSilent) Q_EMIT answered(name);
    }
}

// Those that were opened before, and those that are watched.
std::vector<std::filesystem::path> ArchiveController::foldersHere() const {
    std::vector<std::filesystem::path> folders = parts_.recent.paths();
    for (const QString& each : parts_.settings.settings().watchedFolders) {
        const std::filesystem::path folder = each.toStdString();
        if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
    }
    return folders;
}

void ArchiveController::open(const study::ListedStudy& listed) {
    if (!listed.folder.empty() && (listed.isWhole || listed.archive.empty())) {
        panel_->setRemark(QString());
        return parts_.opening.open(listed.folder);
    }
    fetch(listed, FetchFor::show);
}

void ArchiveController::openBeside(const study::ListedStudy& listed) {
    if (!listed.folder.empty() && (listed.isWhole || listed.archive.empty()))
        return opensBeside_(listed.folder);
    fetch(listed, FetchFor::beside);
}

void ArchiveController::fetchFrom(const QString& from, const net::FoundStudy& study) {
    readSources();  // a link may mean one that was set up since
    fetch({.study = study, .archive = from.toStdString(), .folder = {}, .isWhole = false}, FetchFor::show);
}

// From the archive that named it: a UID means nothing to another one.
void ArchiveController::fetch(const study::ListedStudy& listed, FetchFor purpose) {
    if (!sources_) return;
    auto way = wayTo(*sources_, QString::fromStdString(listed.archive));
    if (!way) return context_.notifications.fail(way.error());
    if (purpose == FetchFor::show) {
        look_.cancel();
        coming_ = {.studyInstanceUid = listed.study.studyInstanceUid,
                   .openBefore = parts_.opening.loader().source(),
                   .folder = {},
                   .lookedAt = 0};
    }
    panel_->setRemark(QString());
    const std::string open =
        context_.session.hasStudy() ? context_.session.study().identity.studyInstanceUid : std::string();
    fetcher_->fetch({listed.study, *std::move(way), purpose, open});
}

// Reading headers takes a part of the time in which they come: each time there are twice as many images, all
// looks together read each header twice. What cannot be shown yet is no error.
void ArchiveController::lookAt(const FetchOrder& order, const study::Arrival& arrival) {
    if (order.purpose != FetchFor::show || order.study.studyInstanceUid != coming_.studyInstanceUid) return;
    if (look_.running() || parts_.opening.loader().loading()) return;
    if (arrival.instances < 2 * coming_.lookedAt) return;
    coming_.lookedAt = arrival.instances;
    coming_.folder = arrival.folder;
    look_.start([folder = arrival.folder](Progress& progress) -> Result<std::filesystem::path> {
        MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(folder, progress));
        return dicom::bestVolume(scan) ? folder : std::filesystem::path();
    });
}

void ArchiveController::showPart(const std::filesystem::path& folder) {
    const FetchOrder* order = fetcher_->current();
    const bool isComing = order != nullptr && order->purpose == FetchFor::show &&
                          order->study.studyInstanceUid == coming_.studyInstanceUid;
    if (isComing && !isOtherOpen()) parts_.opening.open(folder);
}

bool ArchiveController::isOtherOpen() const {
    const study::StudySource& open = parts_.opening.loader().source();
    return open != coming_.openBefore && open != study::StudySource(coming_.folder);
}

void ArchiveController::finish(const FetchOrder& order, const Result<study::FetchedStudy>& fetched) {
    if (order.purpose == FetchFor::show) look_.cancel();
    priors_->refresh();
    if (!fetched) {
        panel_->setRemark(inWindowsLanguage(fetched.error()));
        if (order.purpose != FetchFor::keep) context_.notifications.failUnlessCancelled(fetched.error());
        context_.notes.show();
        return;
    }
    QStringList told{tr("%n images fetched", nullptr, int(fetched->counts.kept))};
    for (const Message& message : fetched->messages) told.append(inWindowsLanguage(message));
    if (order.purpose == FetchFor::show) return showWhole(*fetched, std::move(told));
    const bool isOpenStill =
        context_.session.hasStudy() && context_.session.study().identity.studyInstanceUid == order.besideOf;
    if (order.purpose == FetchFor::beside && isOpenStill) opensBeside_(fetched->folder);
    if (order.purpose == FetchFor::beside && !isOpenStill)
        told.append(tr("Another study was opened meanwhile. Beside shows this one next to it."));
    panel_->setRemark(told.join(QStringLiteral("\n")));
}

void ArchiveController::showWhole(const study::FetchedStudy& fetched, QStringList told) {
    if (coming_.folder.empty()) coming_.folder = fetched.folder;
    if (isOtherOpen())
        told.append(tr("Another study was opened meanwhile. Open shows this one."));
    else
        parts_.opening.open(fetched.folder);
    panel_->setRemark(told.join(QStringLiteral("\n")));
}

// A part of a study must not pass for all of it.
QStringList ArchiveController::notes() const {
    const auto record = shownSource_ ? study::useSpooled(*shownSource_) : std::nullopt;
    if (!record || record->isComplete) return {};
    if (fetcher_->running() && fetcher_->current()->study.studyInstanceUid == record->studyInstanceUid)
        return {tr("Images of this study are still arriving from the archive.")};
    if (record->source.empty())
        return {tr("Somebody sent this study without saying how many images it has: some may be missing.")};
    return {
        tr("This study is not known to be complete: images that the archive has may be missing. Fetch it "
           "again.")};
}

}  // namespace macula::viewer
