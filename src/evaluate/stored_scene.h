// The scene of the measurement of stored models, with its keepers and live models.
#pragma once

#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "live/device/scene_on_device.h"
#include "live/store/study_keeper.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/hybrid/model/model_store.h"
#include "scene/drawing/drawing.h"
#include "session/store.h"

namespace macula::evaluate {

// Stands between a live model and its keeper: notes when the keeper found what, and passes states on only in
// handOver(), so that no save happens unmeasured. Used by the thread that draws.
class WatchedStore final : public hybrid::ModelStore {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Answer = hybrid::StoredModel::Answer;

    // The keeper must outlive this object.
    explicit WatchedStore(live::StudyKeeper& keeper) : keeper_(keeper) {}

    hybrid::StoredModel find(const std::string& key) override;
    void keep(std::shared_ptr<const hybrid::PeripheralState> state) override;

    // Passes the newest state to the keeper, even if it has it already: it is then written again.
    void handOver();

    Answer last() const { return last_; }
    // When there was first something drawable, and when the whole state.
    std::optional<Time> drawableAt() const { return drawableAt_; }
    std::optional<Time> wholeAt() const { return wholeAt_; }

  private:
    live::StudyKeeper& keeper_;
    std::shared_ptr<const hybrid::PeripheralState> newest_;
    Answer last_ = Answer::pending;
    std::optional<Time> drawableAt_;
    std::optional<Time> wholeAt_;
};

// Must outlive its keepers and models.
class StoredScene {
  public:
    static constexpr const char* kName = "measured";
    static constexpr std::chrono::minutes kPatience{10};  // to measure even a slow disk

    // `folder` is that of the store. Keeps references to `study` and `progress`.
    StoredScene(const BenchStudy& study, scene::Drawing drawing, live::SceneOnDevice scene,
                std::filesystem::path folder, Progress& progress);

    const BenchStudy& study() const { return study_; }
    Progress& progress() { return progress_; }

    std::unique_ptr<live::StudyKeeper> makeKeeper();
    // Fails with the first error of a keeper.
    Result<void> checkKeepers() const;
    void look(live::StudyKeeper& keeper) const;

    // Makes a model with an empty shelf of its own.
    Result<hybrid::LiveModel> makeModel(std::shared_ptr<WatchedStore> store) const;
    Result<void> show(hybrid::LiveModel& model) const;
    Result<void> work(hybrid::LiveModel& model) const;  // a slice; fails with `cancelled`
    // Draws in the size of the study's view, and waits until the device has finished.
    Result<void> draw(hybrid::LiveModel& model, const Camera& camera) const;

    // Cameras of one turn around the patient, with the visible matter as large as it fits.
    Result<std::vector<Camera>> turn(int cameras) const;

    Result<session::Store> openStore() const;

  private:
    const BenchStudy& study_;
    const scene::Drawing drawing_;
    const live::SceneOnDevice scene_;
    const std::filesystem::path folder_;
    Progress& progress_;
    mutable std::mutex mutex_;
    std::optional<Error> told_;  // the first error
};

// The only model of the store; fails with nothingStored if there is none.
Result<session::ModelInfo> storedModel(session::Store& store);
Error nothingStored();

}  // namespace macula::evaluate
