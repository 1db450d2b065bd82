// Keeps models and the states of studies between runs of the program, on a thread of its own: nobody who
// draws waits for a disk.
//
//     keeper->look(name, volume, drawing);             // this is about to be shown
//     while (keeper->find(name).answer == pending) ... // LiveModel does
//     keeper->keep(state);                             // and again as it learns
//
// Where the store cannot be used, nothing is found and nothing kept, and the listener hears why, once.
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

namespace macula::app {

// What the keeper has to tell a person: a sentence, and what to do. No patient data but for `where`.
using KeeperListener = std::function<void(const Error&)>;

// look, find, keep and keepState return at once; any thread may call any of them.
class ModelKeeper final : public SceneKeeper {
  public:
    // `listener` is called on the keeper's thread. `retention`: what was not opened for so long is deleted
    // for good (Store::purgeUnused), before anything is looked for; none: nothing is.
    ModelKeeper(session::StoreOptions options, KeeperListener listener,
                std::optional<std::chrono::days> retention = std::nullopt);
    // Saves what was handed over first: as long as that takes.
    ~ModelKeeper() override;

    void look(const std::string& name, std::shared_ptr<const Volume> volume, const Drawing& drawing) override;
    hybrid::StoredModel find(const std::string& name) override;
    // Only under names that were looked for, and in place of no model that has taken more steps.
    void keep(std::shared_ptr<const hybrid::PeripheralState> state) override;

    // Of a volume that is opened now: the state that was kept last, as toJson(StudyState) gave it; nothing
    // where there is none, or it is not found in time, which the listener hears. Waits for the disk, at most
    // `patience` and for the digest of the volume. Throws nothing.
    std::optional<std::string> stateOf(const std::shared_ptr<const Volume>& volume,
                                       std::chrono::milliseconds patience);
    // In place of the one that is kept, of which stays what another window has put there since `base` was
    // kept or read: mergedState. `base` is a text like `json`, which follows what could be kept: the same one
    // for as long as a window has the study open, and the keeper's alone from the first call on. Null:
    // nothing stays.
    void keepState(std::shared_ptr<const Volume> volume, std::string json,
                   std::shared_ptr<std::string> base = {});
    // Until states that were handed over are kept, but at most so long: false where one is not by then.
    // Models may follow.
    bool waitUntilStatesAreKept(std::chrono::milliseconds patience);
    // See volumesSeenBefore. `answer` is called on the keeper's thread, and not at all where nothing can be
    // told.
    void askWhatWasSeen(std::shared_ptr<const FoundVolumes> found,
                        std::function<void(std::set<std::size_t>)> answer);

    // For what else is stored: called once, on the keeper's thread, in the order of these calls; with null
    // where there is no store. It throws nothing but for a lack of memory.
    using StoreUse = std::function<void(session::Store*)>;
    void withStore(StoreUse use);

    // Whether all that was handed over is done, and until it is. For tests and for those who measure.
    bool isIdle();
    void waitUntilIdle();

    // Of what models are of: volumes, masks and segments. Of any thread.
    PartDigests& digests() { return digests_; }

  private:
    struct Named {  // as the store knows it
        session::ModelKey key;
        session::OpenedVolume volume;
    };
    struct Scene {
        std::shared_ptr<const Volume> volume;  // null, and no drawing, once it is named for the store
        Drawing drawing;
        hybrid::StoredModel found{};
        std::optional<Named> named{};  // made on the keeper's thread
    };
    using Job = std::function<void(session::Store&)>;

    enum class Urgency { canWait, isWaitedFor };

    void post(Urgency urgency, Job job);
    bool hasJobs() const { return !waitedFor_.empty() || !canWait_.empty(); }
    void run(const std::stop_token& stop);
    // The lock is of mutex_, and free while it is done.
    void doFirst(std::deque<Job>& jobs, std::unique_lock<std::mutex>& lock);
    // On another thread, where one can be made; meanwhile this one does what is waited for. Throws what
    // `work` throws.
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
    // The keeper's thread keeps to what whoever made it wants of failed checks.
    const bool isBounded_ = CheckBoundary::isDrawn();

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable idle_;
    std::deque<Job> waitedFor_;  // in their order, before
    std::deque<Job> canWait_;    // these
    bool isBusy_ = false;
    bool hasNoStore_ = false;              // it could not be opened
    std::map<std::string, Scene> scenes_;  // by name
    std::list<std::string> names_;         // those of scenes_, the one looked for last stands last
    std::map<std::string, std::shared_ptr<const hybrid::PeripheralState>> toKeep_;  // the newest, by name

    // Of the keeper's thread alone.
    std::optional<session::Store> store_;
    std::optional<session::OpenMark> open_;  // the model that is shown is not evicted
    std::set<std::string> recorded_;         // digests of volumes
    std::set<std::string> told_;             // sentences
    splat::PackedPictures packed_;  // of the model that was saved last; no job that is waited for has it

    PartDigests digests_;  // of what is open

    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace macula::app
