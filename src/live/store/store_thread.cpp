#include "live/store/store_thread.h"

#include <exception>
#include <system_error>
#include <utility>

#include "base/give_way.h"
#include "base/log.h"
#include "live/store/purge_plan.h"

namespace macula::live {

void StoreThread::start(std::function<void()> withoutStore) {
    withoutStore_ = std::move(withoutStore);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void StoreThread::finish() {
    thread_.request_stop();
    thread_.join();
}

void StoreThread::post(Urgency urgency, Job job) {
    {
        const std::lock_guard lock(mutex_);
        (urgency == Urgency::isWaitedFor ? waitedFor_ : canWait_).push_back(std::move(job));
    }
    wake_.notify_one();
}

void StoreThread::run(const std::stop_token& stop) {
    std::optional<CheckBoundary> boundary;
    if (isBounded_) boundary.emplace();
    giveWay(GiveWay::toTheFrame);
    openStore();
    forgetUnused();
    if (!store_) withoutStore_();
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return hasJobs(); })) {
        isBusy_ = true;
        doFirst(waitedFor_.empty() ? canWait_ : waitedFor_, lock);
        isBusy_ = false;
        if (!hasJobs()) idle_.notify_all();
    }
}

void StoreThread::doFirst(std::deque<Job>& jobs, std::unique_lock<std::mutex>& lock) {
    Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    try {
        if (store_) job(*store_);
    } catch (const std::exception&) {
        messages_.tellOfNoMemory(
            [] { return Text("There is not enough memory to keep this study's model."); });
    } catch (const CheckFailure& failure) {
        messages_.tellOfFault(failure);
    }
    job = nullptr;
    lock.lock();
}

void StoreThread::doBeside(const std::function<void()>& work) {
    bool isDone = false;
    std::exception_ptr thrown;
    std::jthread thread;
    try {
        thread = std::jthread([&] {
            giveWay(GiveWay::toAll);
            std::optional<CheckBoundary> boundary;
            if (isBounded_) boundary.emplace();
            try {
                work();
            } catch (...) {
                thrown = std::current_exception();
            }
            const std::lock_guard lock(mutex_);
            isDone = true;
            wake_.notify_one();
        });
    } catch (const std::system_error&) {
        return work();  // no thread can be started: callers wait for longer
    }
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [&] { return isDone || !waitedFor_.empty(); });
        if (isDone) break;
        doFirst(waitedFor_, lock);
    }
    if (thrown) std::rethrow_exception(thrown);
}

void StoreThread::openStore() {
    try {
        Result<session::Store> opened = session::Store::open(options_);
        if (!opened) return messages_.tell(opened.error());
        store_.emplace(*std::move(opened));
        if (store_->notes().setAside)
            messages_.tell({ErrorCode::inputNotUsable,
                            Text("The file of stored sessions was damaged. It was set aside, and what could "
                                 "be read of it was rescued."),
                            store_->notes().setAside->folder.string(),
                            Text("`macula sessions verify` says what is there.")});
    } catch (const std::exception&) {
        messages_.tellOfNoMemory([] { return Text("Stored sessions could not be opened."); });
    } catch (const CheckFailure& failure) {
        store_.reset();
        messages_.tellOfFault(failure);
    }
}

void StoreThread::forgetUnused() {
    if (!store_ || !retention_) return;
    try {
        const auto purged = store_->purgeUnused(*retention_, session::DamagedFiles::keep);
        if (!purged) return messages_.tell(purged.error());
        if (purged->studies + purged->volumes > 0)
            log::info("Stored sessions: {} studies and {} volumes were not opened for {} days, and deleted.",
                      purged->studies, purged->volumes, retention_->count());
        if (purged->clock != session::ClockDoubt::none) messages_.tell(keptForClock(purged->clock));
    } catch (const std::exception&) {
        messages_.tellOfNoMemory([] { return Text("What was not opened for long could not be deleted."); });
    } catch (const CheckFailure& failure) {
        messages_.tellOfFault(failure);
    }
}

void StoreThread::withStore(Use use) {
    // The destructor reports that there is no store: without one the job is dropped unrun, and this with it.
    struct Once {
        explicit Once(Use given) : use(std::move(given)) {}
        Once(const Once&) = delete;
        Once& operator=(const Once&) = delete;
        Use use;
        ~Once() {
            if (use) use(nullptr);
        }
    };
    post(Urgency::isWaitedFor, [once = std::make_shared<Once>(std::move(use))](session::Store& store) {
        std::exchange(once->use, nullptr)(&store);
    });
}

bool StoreThread::isIdle() {
    const std::lock_guard lock(mutex_);
    return !hasJobs() && !isBusy_;
}

void StoreThread::waitUntilIdle() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return !hasJobs() && !isBusy_; });
}

}  // namespace macula::live
