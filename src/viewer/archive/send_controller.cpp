#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/archive/send_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <map>
#include <utility>

#include "net/sources/source_list.h"
#include "study/spool/spool.h"
#include "viewer/archive/archive_controller.h"
#include "viewer/archive/queue_dialog.h"
#include "viewer/archive/send_dialog.h"
#include "viewer/archive/waiting_bar.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/post.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/output/pictures_controller.h"
#include "viewer/output/presentations_controller.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/slices/measurements_controller.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::minutes kAsksEvery{5};

// Makes nothing: a program that never sends leaves no folder.
Result<std::vector<study::OutboxEntry>> entriesOfUser() {
    std::error_code failure;
    if (!std::filesystem::exists(study::outboxFolder(), failure)) return std::vector<study::OutboxEntry>();
    MACULA_TRY(const study::Outbox outbox, study::Outbox::open());
    return outbox.entries();
}

bool answers(const study::OutboxRecord& waiting, Progress& progress) {
    const auto opened = study::openArchiveOfUser(waiting);
    if (!opened) return false;
    const std::vector<net::TestStep> steps = (*opened)->test(progress);
    return !steps.empty() && std::ranges::all_of(steps, &net::TestStep::passed);
}

// The archives, by their names and addresses, each with an entry that waits for it.
std::map<std::pair<std::string, std::string>, study::OutboxRecord> archivesWaitedFor(
    const std::vector<study::OutboxEntry>& entries) {
    std::map<std::pair<std::string, std::string>, study::OutboxRecord> archives;
    for (const study::OutboxEntry& entry : entries)
        if (entry.state == study::OutboxState::waiting)
            archives[{entry.record.archive, entry.record.address}] = entry.record;
    return archives;
}

}  // namespace

SendController::SendController(const WindowContext& context, const Uses& uses)
    : QObject(&context.window),
      context_(context),
      uses_(uses),
      bar_(new WorkBar),
      waiting_(new WaitingBar),
      sending_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              bar_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended = [this](const auto& outcome) { tell(outcome); }}),
      reading_(this, {.ended =
                          [this](const auto& entries) {
                              if (!entries) return context_.notifications.showError(entries.error());
                              entries_ = *entries;
                              if (queue_) queue_->setEntries(entries_);
                              if (sending_.running()) return;  // it is read again at the end of that
                              if (offersNext_ || waiting_->isVisible()) waiting_->offer(entries_);
                              offersNext_ = false;
                          }}),
      asking_(this, {.ended = [this](const auto& archives) {
                  for (const std::string& each : archives ? *archives : std::vector<std::string>())
                      onAnswer(QString::fromStdString(each));
              }}) {
    connect(bar_, &WorkBar::cancelClicked, this, [this] {
        // Others were confirmed too.
        std::deque<Job> others = std::exchange(waitingJobs_, {});
        cancel();
        waitingJobs_ = std::move(others);
        beginNext();
    });
    connect(waiting_, &WaitingBar::sendAsked, this,
            [this] { sendQueued(entries_, study::Outbox::Which::waiting); });
    connect(waiting_, &WaitingBar::queueAsked, this, &SendController::showQueue);
    connect(&uses_.archives, &ArchiveController::answered, this, &SendController::onAnswer);
    connect(&asks_, &QTimer::timeout, this, &SendController::askArchives);
    asks_.start(kAsksEvery);
    QTimer::singleShot(0, this, [this] { readQueue(true); });
}

void SendController::addActions(QMenu& file) {
    QAction* send = file.addAction(tr("Se&nd to an Archive…"), this, &SendController::askWhatToSend);
    describe(*send, "send-to-archive",
             tr("Store the picture, the view, measurements, segments or DICOM files in a PACS"));
    queueAction_ = file.addAction(tr("&Waiting for Archives…"), this, &SendController::showQueue);
    describe(*queueAction_, "waiting-for-archives", tr("What was sent and is not stored there yet"));
}

void SendController::showNames(bool shown) {
    namesShown_ = shown;
    if (queue_) queue_->showNames(shown);
}

void SendController::setAsksEvery(std::chrono::milliseconds time) {
    asks_.start(time);
}

QString SendController::unfinished() const {
    if (!sending_.running()) return {};
    return tr("Objects are still being sent to an archive.");
}

// Of the study's own archive, else of the last one.
QString SendController::usualArchive(const QStringList& archives) const {
    const study::StudySource& open = uses_.opening.loader().source();
    const auto record = open ? study::useSpooled(*open) : std::nullopt;
    const QString source = record ? QString::fromStdString(record->source) : QString();
    return archives.contains(source) ? source : uses_.settings.settings().archive;
}

void SendController::askWhatToSend() {
    const auto sources = net::SourceList::read(net::SourceFiles::ofUser());
    if (!sources) return context_.notifications.showError(sources.error());
    if (sources->all().empty())
        return context_.notifications.refuse(
            tr("No archive has been set up yet."),
            tr("Set one up in the panel Archive, or ask your administrator."));
    SendOffer offer{.archives = {},
                    .archive = {},
                    .patient = context_.session.study().identity,
                    .whyNoObjects = {},
                    .screenPx = uses_.pictures.screenPx(),
                    .is3dShown = uses_.pictures.is3dShown(),
                    .isDeidentified = uses_.settings.settings().deidentifies};
    for (const net::Source& each : sources->all()) offer.archives.append(QString::fromStdString(each.name));
    offer.archive = usualArchive(offer.archives);
    // Takes what is on screen now: while a person answers, another study may open.
    ObjectsToSend onScreen;
    if (context_.session.hasStudy() && context_.session.study().found) {
        onScreen.picture = uses_.pictures.onScreen();
        onScreen.patient = offer.patient;
        const auto view = uses_.presentations.onScreen();
        if (view)
            onScreen.view = *view;
        else
            offer.whyNoView = inWindowsLanguage(view.error());
        if (const auto measurements = uses_.measurements.onScreen()) {
            onScreen.measurements = *measurements;
            offer.measurements = int(measurements->measurements.size());
        } else {
            offer.whyNoMeasurements = inWindowsLanguage(measurements.error());
        }
        if (const auto segmentation = uses_.segmentations.onScreen()) {
            onScreen.segmentation = *segmentation;
            offer.segments = int(segmentation->segments());
        } else {
            offer.whyNoSegments = inWindowsLanguage(segmentation.error());
        }
    } else {
        offer.whyNoObjects =
            tr("No DICOM study is open, so there is no patient to whom a picture could belong.");
    }
    context_.viewport.window().endDrag();
    auto* dialog = new SendDialog(offer, &context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &SendDialog::filesAsked, this, [this, dialog] { askForFiles(*dialog, false); });
    connect(dialog, &SendDialog::folderAsked, this, [this, dialog] { askForFiles(*dialog, true); });
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, onScreen = std::move(onScreen)] { send(*dialog, onScreen); });
    dialog->open();  // exec() would run a second event loop
}

void SendController::askForFiles(SendDialog& dialog, bool folder) {
    QFileDialog* files = folder ? context_.files.toOpenFolder(FolderKind::studies, tr("Send a folder"))
                                : context_.files.toOpen(FolderKind::studies, tr("Send DICOM files"));
    if (!folder) files->setFileMode(QFileDialog::ExistingFiles);
    files->setParent(&dialog, files->windowFlags());
    connect(files, &QFileDialog::filesSelected, &dialog, [&dialog](const QStringList& chosen) {
        std::vector<std::filesystem::path> paths;
        for (const QString& each : chosen) paths.emplace_back(each.toStdString());
        dialog.addFiles(std::move(paths));
    });
    context_.files.ask(files, FolderKind::studies, [](const QString&) {});
}

void SendController::send(const SendDialog& dialog, ObjectsToSend onScreen) {
    ObjectsToSend objects = std::move(onScreen);
    objects.archive = dialog.archive().toStdString();
    objects.files = dialog.files();
    if (!dialog.sendsView()) objects.view.reset();
    if (objects.view) objects.view->isDeidentified = dialog.isDeidentified();
    if (!dialog.sendsMeasurements()) objects.measurements.reset();
    if (objects.measurements) objects.measurements->isDeidentified = dialog.isDeidentified();
    if (!dialog.sendsSegments()) objects.segmentation.reset();
    if (objects.segmentation) objects.segmentation->isDeidentified = dialog.isDeidentified();
    if (!dialog.sendsPicture()) objects.picture.reset();
    if (objects.picture) {
        objects.picture->sizePx = {dialog.sizePx().width(), dialog.sizePx().height()};
        PicturesController::addOverlays(*objects.picture);
        objects.picture->isDeidentified = dialog.isDeidentified();
    }
    uses_.settings.keepArchive(dialog.archive());
    begin(tr("Sending to %1").arg(dialog.archive()),
          [objects = std::move(objects), device = context_.device](Progress& progress) {
              return sendObjects(objects, device, progress);
          });
}

void SendController::sendQueued(const std::vector<study::OutboxEntry>& entries, study::Outbox::Which which) {
    begin(tr("Sending to an archive"), [entries, which](Progress& progress) -> Result<ObjectsSent> {
        MACULA_TRY(study::Outbox outbox, study::Outbox::open());
        ObjectsSent outcome;
        for (const study::OutboxEntry& entry : entries) outcome.asked += entry.record.files.size();
        outcome.sent = study::sendQueued(outbox, entries, study::openArchiveOfUser, progress, which);
        return outcome;
    });
}

void SendController::begin(const QString& told, Work work) {
    // Also after a cancellation, which reports nothing else, the queue is read once the work has ended.
    waitingJobs_.push_back({told, [this, work = std::move(work)](Progress& progress) {
                                auto outcome = work(progress);
                                post(this, [this] { readQueue(true); });
                                return outcome;
                            }});
    if (!sending_.running()) beginNext();
}

void SendController::beginNext() {
    if (waitingJobs_.empty()) return;
    const Job job = std::move(waitingJobs_.front());
    waitingJobs_.pop_front();
    context_.notifications.hide();
    waiting_->hide();
    bar_->begin(job.told);
    if (queue_) queue_->setSending(true);
    sending_.start(job.work);
}

void SendController::cancel() {
    waitingJobs_.clear();
    if (!sending_.cancel()) return;
    bar_->hide();
    if (queue_) queue_->setSending(false);
    context_.notifications.showNote(tr("Sending was cancelled. What was not stored yet is not sent."));
    Q_EMIT written();
}

void SendController::tell(const Result<ObjectsSent>& outcome) {
    bar_->hide();
    if (queue_) queue_->setSending(false);
    if (!outcome) {
        context_.notifications.failUnlessCancelled(outcome.error());
    } else {
        const study::QueueSent& sent = outcome->sent;
        QStringList told;
        const QString archive = QString::fromStdString(outcome->archive);
        if (sent.stored > 0 || !sent.trouble)
            told.append(archive.isEmpty()
                            ? tr("%n objects are stored.", nullptr, int(sent.stored))
                            : tr("%n objects are stored in %1.", nullptr, int(sent.stored)).arg(archive));
        if (sent.trouble) told.append(inWindowsLanguage(*sent.trouble));
        if (sent.refused > 0)
            told.append(tr("The archive refused %n objects; File, Waiting for Archives says why.", nullptr,
                           int(sent.refused)));
        if (sent.left > 0) told.append(tr("%n objects wait in the queue.", nullptr, int(sent.left)));
        const bool isWhole = sent.left == 0 && sent.refused == 0;
        if (isWhole)
            context_.notifications.showDone(told.join(QLatin1Char(' ')), inWindowsLanguage(outcome->notes));
        else
            context_.notifications.fail({ErrorCode::archiveNotUsable,
                                         Text::verbatim(told.join(QLatin1Char(' ')).toStdString()),
                                         {},
                                         {}});
    }
    readQueue(true);
    beginNext();
    if (!sending_.running()) Q_EMIT written();
}

void SendController::readQueue(bool offers) {
    offersNext_ = offersNext_ || offers;
    reading_.start([](Progress&) { return entriesOfUser(); });
}

void SendController::showQueue() {
    if (!queue_) {
        context_.viewport.window().endDrag();
        queue_ = new QueueDialog(&context_.window);
        queue_->setAttribute(Qt::WA_DeleteOnClose);
        queue_->showNames(namesShown_);
        queue_->setEntries(entries_);
        queue_->setSending(sending_.running());
        connect(queue_, &QueueDialog::sendAsked, this, &SendController::sendChosen);
        connect(queue_, &QueueDialog::removeAsked, this, &SendController::remove);
    }
    queue_->show();
    queue_->raise();
    queue_->activateWindow();
    readQueue(false);
}

// The entries that were queued for an archive at another address are asked for by that address first.
void SendController::sendChosen(const std::vector<study::OutboxEntry>& entries) {
    const auto list = net::SourceList::read(net::SourceFiles::ofUser());
    const auto moved = list ? study::movedEntries(entries, *list) : std::vector<study::MovedEntry>();
    if (moved.empty()) return sendQueued(entries, study::Outbox::Which::refusedToo);
    QStringList told;
    for (const study::MovedEntry& each : moved) {
        const QString sentence = tr("%1 is at %2 now. When objects were sent to it, it was at %3.")
                                     .arg(harmless(QString::fromStdString(each.archive)),
                                          harmless(QString::fromStdString(each.address)),
                                          harmless(QString::fromStdString(each.before)));
        if (!told.contains(sentence)) told.append(sentence);
    }
    auto* box = new QMessageBox(QMessageBox::Question, tr("Send to Another Address"),
                                told.join(QLatin1Char('\n')), QMessageBox::Cancel, queue_);
    box->setObjectName(QStringLiteral("queue-moved"));
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Send only if it is the same archive."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Cancel);
    auto* send = box->addButton(tr("&Send There"), QMessageBox::AcceptRole);
    connect(send, &QPushButton::clicked, this, [this, entries, moved] {
        std::vector<study::OutboxEntry> now = entries;
        auto outbox = study::Outbox::open();
        const Result<void> done =
            outbox ? study::readdress(*outbox, moved, now) : Result<void>(outbox.error());
        if (!done) return context_.notifications.showError(done.error());
        sendQueued(now, study::Outbox::Which::refusedToo);
    });
    box->open();
}

void SendController::remove(const std::vector<study::OutboxEntry>& entries) {
    auto outbox = study::Outbox::open();
    if (!outbox) return context_.notifications.showError(outbox.error());
    for (const study::OutboxEntry& each : entries)
        if (const auto removed = outbox->remove(each.id); !removed)
            context_.notifications.showError(removed.error());
    readQueue(false);
}

bool SendController::waitsFor(const QString& archive) const {
    return std::ranges::any_of(entries_, [name = archive.toStdString()](const study::OutboxEntry& entry) {
        return entry.state == study::OutboxState::waiting && entry.record.archive == name;
    });
}

void SendController::askArchives() {
    if (sending_.running() || asking_.running() || waiting_->isVisible()) return;
    const auto archives = archivesWaitedFor(entries_);
    if (archives.empty()) return;
    asking_.start([archives](Progress& progress) -> Result<std::vector<std::string>> {
        std::vector<std::string> found;
        for (const auto& [place, waiting] : archives)
            if (!progress.cancelled() && answers(waiting, progress)) found.push_back(place.first);
        return found;
    });
}

// Never while it is being sent: what waits then is on its way.
void SendController::onAnswer(const QString& archive) {
    if (!sending_.running() && waitsFor(archive)) readQueue(true);
}

}  // namespace macula::viewer
