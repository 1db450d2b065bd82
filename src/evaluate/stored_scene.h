// The scene whose model is kept while that is measured: keepers and live models of it.
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

// Between a live model and its keeper: notes when what was found, and hands states over only when it is told
// to, so that nothing is saved while nobody measures it. Of the thread that draws.
class WatchedStore final : public hybrid::ModelStore {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Answer = hybrid::StoredModel::Answer;

    // The keeper must outlive this.
    explicit WatchedStore(live::StudyKeeper& keeper) : keeper_(keeper) {}

    hybrid::StoredModel find(const std::string& key) override;
    void keep(std::shared_ptr<const hybrid::PeripheralState> state) override;

    // The newest state; also one that was handed over before, which is written anew all the same.
    void handOver();

    Answer last() const { return last_; }
    // The first time that there was anything to be drawn, and all of it.
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
    static constexpr std::chrono::minutes kPatience{10};  // a slow disk is measured, not given up

    // `folder` is that of the store. Keeps references.
    StoredScene(const BenchStudy& study, scene::Drawing drawing, live::SceneOnDevice scene,
                std::filesystem::path folder, Progress& progress);

    const BenchStudy& study() const { return study_; }
    Progress& progress() { return progress_; }

    std::unique_ptr<live::StudyKeeper> makeKeeper();
    // Fails with the first thing that keepers had to tell.
    Result<void> checkKeepers() const;
    void look(live::StudyKeeper& keeper) const;

    // With a shelf of its own, on which there is nothing.
    Result<hybrid::LiveModel> makeModel(std::shared_ptr<WatchedStore> store) const;
    Result<void> show(hybrid::LiveModel& model) const;
    Result<void> work(hybrid::LiveModel& model) const;  // a slice; `cancelled`
    // Of the size of the study's view; waits until the device has drawn it.
    Result<void> draw(hybrid::LiveModel& model, const Camera& camera) const;

    // One turn around the patient, whatever is seen as large as it fits.
    Result<std::vector<Camera>> turn(int cameras) const;

    Result<session::Store> openStore() const;

  private:
    const BenchStudy& study_;
    const scene::Drawing drawing_;
    const live::SceneOnDevice scene_;
    const std::filesystem::path folder_;
    Progress& progress_;
    mutable std::mutex mutex_;
    std::optional<Error> told_;  // the first
};

// The one model that the store has; fails with nothingStored.
Result<session::ModelInfo> storedModel(session::Store& store);
Error nothingStored();

}  // namespace macula::evaluate
