// Stores models and study states between runs of the program, on a thread of its own, so that drawing never
// waits for a disk.
//
//     keeper->willShow(name, volume, drawing);             // this is about to be shown
//     while (keeper->find(name).answer == pending) ... // LiveModel does
//     keeper->keep(state);                             // and again as it learns
//
// If the store cannot be used, the keeper finds and stores nothing, and tells the listener why, once.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "base/check.h"
#include "base/result.h"
#include "base/volume.h"
#include "live/frame/scene_keeper.h"
#include "live/model/part_digests.h"
#include "pipeline/splat/files/packed_pictures.h"
#include "session/store.h"
#include "study/open/found_volumes.h"

namespace macula::live {

// Receives messages for the user: a sentence and advice. No patient data, except in `where`.
using KeeperListener = std::function<void(const Error&)>;

// look, find, keep and keepState return at once; any thread may call them.
class StudyKeeper final : public SceneKeeper {
  public:
    // `listener` is called on the keeper's thread. `retention`: before anything else, deletes for good what
    // was not opened for so long (Store::purgeUnused); none: deletes nothing.
    StudyKeeper(session::StoreOptions options, KeeperListener listener,
                std::optional<std::chrono::days> retention = std::nullopt);
    // Finishes the work that was handed over before, however long that takes.
    ~StudyKeeper() override;

    void willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                  const scene::Drawing& drawing) override;
    hybrid::StoredModel find(const std::string& name) override;
    // Stores only under names passed to willShow(), and never replaces a model that has taken more steps.
    void keep(std::shared_ptr<const hybrid::PeripheralState> state) override;

    // The stored state of a volume being opened, as toJson(StudyState) wrote it. Nothing if there is none, or
    // if it does not come in time, which the listener is told. Waits for the disk, at most `patience`, and
    // for the digest of the volume. Throws nothing.
    std::optional<std::string> stateOf(const std::shared_ptr<const Volume>& volume,
                                       std::chrono::milliseconds patience);
    // Replaces the stored state. What another window stored since `base` was stored or read stays:
    // mergedState. `base` is such a text; after each save the keeper sets it to `json`. Pass the same one
    // while a window has the study open, and do not touch it after the first call. Null: nothing of the old
    // state stays.
    void keepState(std::shared_ptr<const Volume> volume, std::string json,
                   std::shared_ptr<std::string> base = {});
    // Waits, at most `patience`, until the states handed over are stored, or storing them has failed; false
    // if that was too short. Models may still be pending.
    bool waitUntilStatesAreKept(std::chrono::milliseconds patience);
    // See volumesSeenBefore. `answer` is called on the keeper's thread; never if there is no store or it
    // fails.
    void askWhatWasSeen(std::shared_ptr<const study::FoundVolumes> found,
                        std::function<void(std::set<std::size_t>)> answer);

    // Runs `use` once on the keeper's thread, in the order of these calls; with null if there is no store.
    // `use` throws nothing but for lack of memory.
    using StoreUse = std::function<void(session::Store*)>;
    void withStore(StoreUse use);

    // Whether all handed-over work is done; waitUntilIdle() waits for it. For tests and measurements.
    bool isIdle();
    void waitUntilIdle();

    // Digests of volumes, masks and segments. Any thread may use them.
    PartDigests& digests() { return digests_; }

  private:
    struct Named {  // a scene as the store knows it
        session::ModelKey key;
        session::OpenedVolume volume;
    };
    struct Scene {
        std::shared_ptr<const Volume> volume;  // null, and no drawing, once `named` is set
        scene::Drawing drawing;
        hybrid::StoredModel found{};
        std::optional<Named> named{};  // made on the keeper's thread
    };
    using Job = std::function<void(session::Store&)>;

    enum class Urgency { canWait, isWaitedFor };

    void post(Urgency urgency, Job job);
    bool hasJobs() const { return !waitedFor_.empty() || !canWait_.empty(); }
    void run(const std::stop_token& stop);
    // `lock` locks mutex_; it is free while the job runs.
    void doFirst(std::deque<Job>& jobs, std::unique_lock<std::mutex>& lock);
    // Runs `work` on another thread, if one can be started; this one meanwhile does the jobs that callers
    // wait for. Throws what `work` throws.
    void doBeside(const std::function<void()>& work);
    void openStore();
    void forgetUnused();
    void tell(const Error& error);
    void tellOfNoMemory(const char* sentence) noexcept;
    void tellOfFault(const CheckFailure& failure) noexcept;
    std::optional<Named> nameForStore(const std::string& name);
    void answer(const std::string& name, hybrid::StoredModel found);
    void record(session::Store& store, const session::OpenedVolume& volume);
    void searchFor(session::Store& store, const std::string& name);
    hybrid::StoredModel resume(session::Store& store, const session::ModelInfo& info,
                               const std::string& name);
    hybrid::StoredModel beginWithKin(session::Store& store, const session::ModelKey& key);
    void save(session::Store& store, const std::string& name);

    const session::StoreOptions options_;
    const KeeperListener listener_;
    const std::optional<std::chrono::days> retention_;
    // The keeper's thread handles failed checks as the thread that made the keeper does.
    const bool isBounded_ = CheckBoundary::isDrawn();

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable idle_;
    std::deque<Job> waitedFor_;  // in order, before canWait_
    std::deque<Job> canWait_;    // in order
    bool isBusy_ = false;
    bool hasNoStore_ = false;              // the store could not be opened
    std::map<std::string, Scene> scenes_;  // by name
    std::list<std::string> names_;         // of scenes; the last one passed to willShow() comes last
    std::map<std::string, std::shared_ptr<const hybrid::PeripheralState>> toKeep_;  // the newest, by name

    // Used by the keeper's thread alone.
    std::optional<session::Store> store_;
    std::optional<session::OpenMark> open_;  // keeps the shown model from eviction
    std::set<std::string> recorded_;         // digests of volumes recorded as opened
    std::set<std::string> told_;             // sentences the listener has heard
    splat::PackedPictures packed_;           // of the last saved model; only jobs of canWait_ use it

    PartDigests digests_;  // of parts in memory

    std::jthread thread_;  // last, because it uses all of the above
};

}  // namespace macula::live
