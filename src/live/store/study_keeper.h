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
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/result.h"
#include "base/volume.h"
#include "live/frame/scene_keeper.h"
#include "live/model/part_digests.h"
#include "live/store/keeper_messages.h"
#include "live/store/kept_models.h"
#include "live/store/kept_states.h"
#include "live/store/opened_record.h"
#include "live/store/store_thread.h"
#include "session/store.h"
#include "study/open/found_volumes.h"

namespace macula::live {

// willShow, find, keep and keepState return at once; any thread may call them.
class StudyKeeper final : public SceneKeeper {
  public:
    // `listener` is called on the keeper's thread. `retention`: first deletes, for good, everything that was
    // not opened for so long (Store::purgeUnused); none: deletes nothing.
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
    // if it does not come in time, which the listener hears. Waits for the digest of the volume, and for the
    // disk, at most `patience`. Throws nothing.
    std::optional<std::string> stateOf(const std::shared_ptr<const Volume>& volume,
                                       std::chrono::milliseconds patience) {
        return states_.stateOf(volume, patience);
    }
    // Replaces the stored state, but keeps what another window has stored since `base` (mergedState). `base`
    // is the text that this window read or stored last; after each save the keeper sets it to `json`. Pass
    // the same pointer while a window has the study open, and do not touch the text after the first call.
    // Null: nothing of the old state stays.
    void keepState(std::shared_ptr<const Volume> volume, std::string json,
                   std::shared_ptr<std::string> base = {}) {
        states_.keepState(std::move(volume), std::move(json), std::move(base));
    }
    // Waits, at most `patience`, until the states handed over are stored, or storing them has failed; false
    // if that was too short. Models may still be pending.
    bool waitUntilStatesAreKept(std::chrono::milliseconds patience);
    // See volumesSeenBefore. `answer` is called on the keeper's thread; never if there is no store or it
    // fails.
    void askWhatWasSeen(std::shared_ptr<const study::FoundVolumes> found,
                        std::function<void(std::set<std::size_t>)> answer);

    // Runs `use` once on the keeper's thread, in the order of these calls; with null if there is no store.
    // `use` may throw only for lack of memory.
    using StoreUse = StoreThread::Use;
    void withStore(StoreUse use) { thread_.withStore(std::move(use)); }

    // Whether all handed-over work is done; waitUntilIdle() waits for it. For tests and measurements.
    bool isIdle() { return thread_.isIdle(); }
    void waitUntilIdle() { thread_.waitUntilIdle(); }

    // Digests of volumes, masks and segments. Any thread may use them.
    PartDigests& digests() { return digests_; }

  private:
    KeeperMessages messages_;
    PartDigests digests_;  // digests of parts in memory
    // Joined before anything here is destroyed. The store closes after models_ has closed its mark of the
    // open model, because that comes later here.
    StoreThread thread_;
    OpenedRecord opened_;
    KeptModels models_;
    KeptStates states_;
};

}  // namespace macula::live
