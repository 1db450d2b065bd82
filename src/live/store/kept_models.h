// The peripheral models that a StudyKeeper finds and stores.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "live/store/keeper_messages.h"
#include "live/store/opened_record.h"
#include "live/store/store_thread.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/splat/files/packed_pictures.h"
#include "scene/drawing/drawing.h"
#include "session/store.h"

namespace macula::live {

// Translates between names of scenes and keys of the store.
//
// Any thread may call willShow, find and keep, which return at once; what they post runs on the store's
// thread. The lock guards the scenes alone: it is not held while the store is used or a job is posted.
class KeptModels {
  public:
    KeptModels(StoreThread& thread, KeeperMessages& messages, OpenedRecord& opened, PartDigests& digests)
        : thread_(thread), messages_(messages), opened_(opened), digests_(digests) {}

    // See SceneKeeper.
    void willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                  const scene::Drawing& drawing);
    hybrid::StoredModel find(const std::string& name);
    // See StudyKeeper::keep.
    void keep(std::shared_ptr<const hybrid::PeripheralState> state);

    // There is no store: from now on finds nothing, and holds on to no models, because nobody would save
    // them.
    void doWithoutStore();

  private:
    struct Named {  // a scene as the store knows it
        session::ModelKey key;
        session::OpenedVolume volume;
    };
    struct Scene {
        std::shared_ptr<const Volume> volume;  // null once `named` is set; `drawing` is empty then
        scene::Drawing drawing;
        hybrid::StoredModel found{};
        std::optional<Named> named{};  // made on the keeper's thread
    };

    // On the keeper's thread: -----------------------------------------------------------------------------
    std::optional<Named> nameForStore(const std::string& name);
    void answer(const std::string& name, hybrid::StoredModel found);
    void searchFor(session::Store& store, const std::string& name);
    hybrid::StoredModel resume(session::Store& store, const session::ModelInfo& info,
                               const std::string& name);
    hybrid::StoredModel beginWithKin(session::Store& store, const session::ModelKey& key);
    void save(session::Store& store, const std::string& name);

    StoreThread& thread_;
    KeeperMessages& messages_;
    OpenedRecord& opened_;
    PartDigests& digests_;

    std::mutex mutex_;
    bool isWithoutStore_ = false;
    std::map<std::string, Scene> scenes_;  // by name
    std::list<std::string> names_;         // names of scenes; the last one passed to willShow() comes last
    std::map<std::string, std::shared_ptr<const hybrid::PeripheralState>> toKeep_;  // the newest, by name

    // Used by the keeper's thread alone.
    std::optional<session::OpenMark> open_;  // keeps the shown model from eviction
    splat::PackedPictures packed_;           // those of the last saved model; only jobs that can wait use it
};

}  // namespace macula::live
