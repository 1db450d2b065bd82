// Runs work on a thread of its own, without blocking the UI thread.
#pragma once

#include <QObject>
#include <cstdint>
#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <thread>
#include <utility>

#include "base/give_way.h"
#include "base/progress.h"
#include "base/result.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

// One job at a time, on a thread of its own; a new job replaces the one before, which reports nothing more.
// Call all members on the thread of `home`, which also gets all callbacks.
template <class Value>
class BackgroundJob {
  public:
    using Work = std::function<Result<Value>(Progress&)>;
    struct Listener {
        std::function<void(const ProgressUpdate&)> progressed = [](const ProgressUpdate&) {};
        std::function<void(const Result<Value>&)> ended;
    };

    // `home` owns this.
    BackgroundJob(QObject* home, Listener listener) : home_(home), listener_(std::move(listener)) {}
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;
    // Cancels, and waits for the threads to notice.
    ~BackgroundJob() {
        for (const Thread& thread : threads_) thread.token.cancel();
        threads_.clear();
    }

    // Reports outOfMemory when `work` throws or no thread can be made.
    void start(Work work) {
        cancel();
        const std::uint64_t id = ++lastId_;
        current_ = id;
        Thread& made = threads_.emplace_back();
        made.id = id;
        try {
            made.thread = std::jthread([this, id, token = made.token, work = std::move(work)] {
                giveWay(GiveWay::toTheFrame);
                Progress progress(
                    [this, id](const ProgressUpdate& update) {
                        tell([this, id, update] {
                            if (id == current_) listener_.progressed(update);
                        });
                    },
                    token);
                tell([this, id, outcome = outcomeOf(work, progress)] { finish(id, outcome); });
            });
        } catch (const std::exception&) {
            // Posted as if the job had begun: the caller has not yet announced the start.
            tell([this, id] { finish(id, noMemory()); });
        }
    }

    // The job reports nothing more. Returns whether one was running.
    bool cancel() {
        for (const Thread& thread : threads_) thread.token.cancel();
        return std::exchange(current_, 0) != 0;
    }

    bool running() const { return current_ != 0; }
    bool atRest() const { return threads_.empty(); }  // cancelled jobs have ended, too

  private:
    struct Thread {
        std::uint64_t id = 0;
        CancelToken token;
        std::jthread thread;
    };

    static Error noMemory() {
        return {
            ErrorCode::outOfMemory, Text("There is not enough memory."), {}, Text("Close other programs.")};
    }

    // Callers of libraries catch their exceptions, so one that arrives here means out of memory.
    static Result<Value> outcomeOf(const Work& work, Progress& progress) {
        try {
            return work(progress);
        } catch (const std::exception&) {
            return noMemory();
        }
    }

    void tell(std::function<void()> call) { post(home_, std::move(call)); }

    void finish(std::uint64_t id, const Result<Value>& outcome) {
        // Posting this was the thread's last action: joining takes no time.
        threads_.remove_if([id](const Thread& thread) { return thread.id == id; });
        if (id != current_) return;
        current_ = 0;
        listener_.ended(outcome);
    }

    QObject* home_;
    Listener listener_;
    std::list<Thread> threads_;  // the current one, and cancelled ones that still run
    std::uint64_t current_ = 0;
    std::uint64_t lastId_ = 0;
};

}  // namespace macula::viewer
