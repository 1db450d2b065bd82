// Where a live model (live_model.h) is kept: the shelf of this run of the program, and the store.
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

    // Between these the store is being asked, and has not given its last answer.
    void beginAsking();
    void endAsking() { askingSince_.reset(); }
    bool isAsking() const { return askingSince_.has_value(); }
    // Waits for an answer that is news: not pending, and not drawable if the model is drawn already. Returns
    // nothing if `goesOn`, asked in between, says no; and, after a while, even a pending answer if other work
    // waits (`hasOther`).
    std::optional<StoredModel> answer(const std::string& key, bool isDrawn, bool hasOther,
                                      const std::function<bool()>& goesOn);

    // Holds a whole model, which the store gives only once, until training continues with it.
    void holdWhole(const StoredModel& stored) { whole_ = stored; }
    void dropWhole() { whole_.reset(); }
    const std::optional<StoredModel>& whole() const { return whole_; }
    // So that a lost or full device does not cost a model that the store has given.
    void putWholeOnShelf();

    // Puts a model on the shelf, and gives it to the store if it has changed.
    void put(PeripheralState state, double gain);
    // Gives the model to the store from time to time, so that little is lost if the program is killed. Uses
    // lastGood(), which is on the host already, so no frame waits.
    void putSometimes(const PeripheralModel& model, double gain);
    // Call when the model has just come from shelf or store: it need not be stored again.
    void noteResumed(const PeripheralModel& model, double gain);
    // Call before another model.
    void forget();

  private:
    // Changes whenever a model does.
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
    Kept kept_;  // the model that the store was last given
    std::chrono::steady_clock::time_point keptAt_;
};

}  // namespace macula::hybrid
