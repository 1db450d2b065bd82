// A thread of its own for a study store, so that drawing never waits for a disk.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/check.h"
#include "live/store/keeper_messages.h"
#include "session/store.h"

namespace macula::live {

// Opens the store, and does jobs with it in order: first those that somebody waits for.
//
// Any thread may call post, withStore, isIdle and waitUntilIdle; only the owner may call start and finish,
// and only jobs doBeside. The lock guards the queues alone: it is free while a job runs and while the store
// is opened, and no other lock is taken under it.
class StoreThread {
  public:
    using Job = std::function<void(session::Store&)>;
    enum class Urgency { canWait, isWaitedFor };

    // Starts nothing yet. `retention` as in StudyKeeper.
    StoreThread(session::StoreOptions options, std::optional<std::chrono::days> retention,
                KeeperMessages& messages)
        : options_(std::move(options)), retention_(retention), messages_(messages) {}
    StoreThread(const StoreThread&) = delete;
    StoreThread& operator=(const StoreThread&) = delete;
    ~StoreThread() { MACULA_CHECK(!thread_.joinable()); }  // jobs use what its owner may have destroyed

    // Call once, when everything that jobs use exists. If the store cannot be opened, `withoutStore` is
    // called on the thread, before the first job.
    void start(std::function<void()> withoutStore);
    // Does the jobs posted so far, however long that takes, and joins the thread. Call it while everything
    // that jobs use still exists. The store stays open until this is destroyed.
    void finish();

    // Without a store the job is dropped unrun.
    void post(Urgency urgency, Job job);
    // See StudyKeeper::withStore.
    using Use = std::function<void(session::Store*)>;
    void withStore(Use use);
    // Runs `work` on another thread, if one can be started; this one meanwhile does the jobs that callers
    // wait for. Throws what `work` throws. Only jobs that can wait may call it.
    void doBeside(const std::function<void()>& work);

    // Whether all jobs are done; waitUntilIdle() waits until they are.
    bool isIdle();
    void waitUntilIdle();

  private:
    bool hasJobs() const { return !waitedFor_.empty() || !canWait_.empty(); }
    void run(const std::stop_token& stop);
    // `lock` locks mutex_; it is free while the job runs.
    void doFirst(std::deque<Job>& jobs, std::unique_lock<std::mutex>& lock);
    void openStore();
    void forgetUnused();

    const session::StoreOptions options_;
    const std::optional<std::chrono::days> retention_;
    // The thread handles failed checks as the thread that made this does.
    const bool isBounded_ = CheckBoundary::isDrawn();
    KeeperMessages& messages_;
    std::function<void()> withoutStore_;

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable idle_;
    std::deque<Job> waitedFor_;  // in order, before canWait_
    std::deque<Job> canWait_;    // in order
    bool isBusy_ = false;

    std::optional<session::Store> store_;  // used by the thread alone

    std::jthread thread_;
};

}  // namespace macula::live
