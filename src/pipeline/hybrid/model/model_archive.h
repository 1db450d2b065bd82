// Where a live model (live_model.h) is found again: the shelf of this run of the program, and the store.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "pipeline/hybrid/model/live_model_options.h"
#include "pipeline/hybrid/model/model_shelf.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/hybrid/model/peripheral_model.h"

namespace macula::hybrid {

// Used by one thread at a time.
class ModelArchive {
  public:
    // The store may be null.
    ModelArchive(std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
                 const LiveModelOptions& options);

    std::shared_ptr<const PeripheralState> shelved(const std::string& key) { return shelf_->find(key); }
    bool hasStore() const { return store_ != nullptr; }
    StoredModel stored(const std::string& key) { return store_->find(key); }

    // The store is asked, and has not given its last answer yet.
    void beginAsking();
    void endAsking() { askingSince_.reset(); }
    bool isAsking() const { return askingSince_.has_value(); }
    // Waits for an answer that is news, where it is drawn or not; nothing when `goesOn`, which is asked in
    // between, says no. After a while it gives a pending answer too, if `hasOther` work waits.
    std::optional<StoredModel> answer(const std::string& key, bool isDrawn, bool hasOther,
                                      const std::function<bool()>& goesOn);

    // A whole model that came from the store, which gives it once, until it is gone on with.
    void holdWhole(const StoredModel& stored) { whole_ = stored; }
    void dropWhole() { whole_.reset(); }
    const std::optional<StoredModel>& whole() const { return whole_; }
    // A device that is lost or full is no reason to begin anew.
    void putWholeOnShelf();

    // To the shelf, and to the store what is news to it.
    void put(PeripheralState state, double gain);
    // So that a program that is killed loses little: to the store, now and then. lastGood() is on the host
    // already: no frame waits for it.
    void putSometimes(const PeripheralModel& model, double gain);
    // The model has just come from there.
    void noteResumed(const PeripheralModel& model, double gain);
    // Another model is next.
    void forget();

  private:
    // What tells a model from itself some time before.
    struct Kept {
        std::uint64_t steps = 0;
        std::uint64_t generation = 0;
        double gain = 1.0;
        bool operator==(const Kept&) const = default;
    };
    void giveToStore(std::shared_ptr<const PeripheralState> state);

    std::shared_ptr<ModelShelf> shelf_;
    std::shared_ptr<ModelStore> store_;
    std::chrono::milliseconds mostWait_;
    std::chrono::milliseconds leastBetween_;
    std::optional<std::chrono::steady_clock::time_point> askingSince_;
    std::optional<StoredModel> whole_;
    Kept kept_;  // what the store was given last
    std::chrono::steady_clock::time_point keptAt_;
};

}  // namespace macula::hybrid
