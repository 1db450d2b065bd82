#include "viewer/watch/folder_look.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/give_way.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

using Clock = study::WatchedFolder::Clock;
using namespace std::chrono_literals;

constexpr int kPauseTimesLook = 20;  // a look takes at most a twentieth of the time
constexpr std::chrono::milliseconds kPatience = 30s;
constexpr std::chrono::milliseconds kPatienceAtTheEnd = 2s;

}  // namespace

struct FolderLook::Shared {
    std::mutex mutex;
    std::condition_variable ended;
    bool isRunning = false;
    FolderLook* home = nullptr;  // null: destroyed
    CancelToken cancel;
    study::WatchedFolder folder;  // of the thread, while it runs

    Shared(const QString& path, std::chrono::milliseconds quiet) : folder(path.toStdString(), quiet) {}
};

FolderLook::FolderLook(const QString& folder, WatchPace pace, QObject* parent)
    : QObject(parent), folder_(folder), pace_(pace), shared_(std::make_shared<Shared>(folder, pace.quiet)) {
    shared_->home = this;
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &FolderLook::onTimer);
    timer_.start(0);
}

FolderLook::~FolderLook() {
    shared_->cancel.cancel();
    std::unique_lock lock(shared_->mutex);
    shared_->home = nullptr;
    shared_->ended.wait_for(lock, kPatienceAtTheEnd, [this] { return !shared_->isRunning; });
}

void FolderLook::onTimer() {
    if (isLooking_) return setAbsent(true);
    look();
}

void FolderLook::look() {
    try {
        {
            const std::lock_guard lock(shared_->mutex);
            shared_->isRunning = true;
        }
        isLooking_ = true;
        std::thread([shared = shared_] { lookOn(shared); }).detach();
        timer_.start(kPatience);
    } catch (const std::exception&) {
        // No thread can be made now.
        const std::lock_guard lock(shared_->mutex);
        shared_->isRunning = false;
        isLooking_ = false;
        timer_.start(pace_.every);
    }
}

FolderLook::Looked FolderLook::lookedAt(study::WatchedFolder& folder, const CancelToken& cancel) {
    const Clock::time_point begun = Clock::now();
    Looked looked;
    try {
        Progress progress({}, cancel);
        auto arrived = folder.look(begun, progress);
        looked.isAbsent = !arrived && arrived.error().code != ErrorCode::cancelled;
        if (arrived) looked.studies = *std::move(arrived);
    } catch (const std::exception&) {
        looked.isAbsent = true;  // there is not enough memory for it now
    }
    looked.took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun);
    return looked;
}

void FolderLook::lookOn(const std::shared_ptr<Shared>& shared) {
    giveWay(GiveWay::toAll);
    Looked looked = lookedAt(shared->folder, shared->cancel);
    const std::lock_guard lock(shared->mutex);
    shared->isRunning = false;
    if (FolderLook* home = shared->home)
        post(home, [home, looked = std::move(looked)] { home->take(looked); });
    shared->ended.notify_all();
}

void FolderLook::take(const Looked& looked) {
    isLooking_ = false;
    ++looks_;
    timer_.start(std::max(pace_.every, kPauseTimesLook * looked.took));
    setAbsent(looked.isAbsent);
    for (const study::ArrivedStudy& study : looked.studies) Q_EMIT arrived(study);
}

void FolderLook::setAbsent(bool isAbsent) {
    if (isAbsent_ == isAbsent) return;
    isAbsent_ = isAbsent;
    Q_EMIT absenceChanged();
}

}  // namespace macula::viewer
