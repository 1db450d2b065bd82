#include "evaluate/store_round_trip.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/draft.h"
#include "base/elapsed.h"
#include "evaluate/measurement.h"
#include "evaluate/stored_scene.h"
#include "image/masked_metrics.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kSavesEvery = 10;  // frames
constexpr int kLaterSaves = 5;

Result<void> checkFolder(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || !fs::exists(fs::symlink_status(folder, error))) return {};
    if (fs::is_directory(folder, error) && fs::is_empty(folder, error) && !error) return {};
    return Error{ErrorCode::outputNotWritable, Text("What is measured needs a folder of its own."),
                 folder.string(), Text("Choose a new or an empty folder for --sessions.")};
}

struct Workplace {
    std::optional<Draft> draft;  // removes itself with its contents
    fs::path folder;             // of the store
};

Result<Workplace> makeWorkplace(const fs::path& wanted) {
    MACULA_TRY_VOID(checkFolder(wanted));
    if (!wanted.empty())
        return Workplace{.draft = {}, .folder = wanted.has_filename() ? wanted : wanted.parent_path()};
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    if (error)
        return Error{ErrorCode::outputNotWritable,
                     Text("There is no folder for temporary files."),
                     {},
                     Text("Set TMPDIR, or choose a folder with --sessions.")};
    removeAbandonedDrafts(temporary);
    MACULA_TRY(Draft draft, Draft::beside(temporary / "macula-bench-session", Draft::Kind::folder));
    fs::path folder = draft.path() / "sessions";
    return Workplace{.draft = std::move(draft), .folder = std::move(folder)};
}

// The first run of a model: learns, saves and puts it away.
class FirstRun {
  public:
    FirstRun(StoredScene& scene, const StoreRoundTripOptions& options, const std::vector<Camera>& cameras)
        : scene_(scene), options_(options), cameras_(cameras), progress_(scene.progress()) {}

    Result<void> learn() {
        keeper_ = scene_.makeKeeper();
        store_ = std::make_shared<WatchedStore>(*keeper_);
        MACULA_TRY(hybrid::LiveModel model, scene_.makeModel(store_));
        model_.emplace(std::move(model));
        progress_.beginStage(Text("Learning"), static_cast<std::size_t>(std::ceil(options_.learnS)));
        const auto start = Clock::now();
        scene_.look(*keeper_);
        MACULA_TRY_VOID(scene_.show(*model_));
        const auto isDone = [&] { return model_->canBeDrawn() && secondsSince(start) >= options_.learnS; };
        for (std::size_t told = 0; model_->hasWork() && !isDone();) {
            MACULA_TRY_VOID(scene_.work(*model_));
            for (; told < static_cast<std::size_t>(secondsSince(start)); ++told) progress_.advance();
        }
        seconds_ = secondsSince(start);
        if (model_->canBeDrawn()) return scene_.checkKeepers();
        if (model_->news().stage == hybrid::ModelStage::nothingToSee)
            return Error{ErrorCode::inputNotUsable,
                         Text("Nothing of the series can be seen."),
                         {},
                         Text("Choose another preset.")};
        return Error{ErrorCode::outOfMemory,
                     Text("There is no room on the device for a model."),
                     {},
                     Text("Close other programs, or choose another device.")};
    }

    LearntModel learnt() const {
        const std::optional<hybrid::PeripheralReport> report = model_->report();
        MACULA_CHECK(report.has_value());
        return {.seconds = seconds_,
                .stage = nameOf(model_->news().stage),
                .steps = report->training.steps,
                .splats = model_->shown()->size(),
                .views = report->views,
                .heldOut = report->heldOut,
                .trainedError = report->error,
                .shownError = report->shownError};
    }

    std::shared_ptr<const splat::Splats> shown() const { return model_->shown(); }

    Result<SavingTimes> save() {
        SavingTimes times;
        progress_.beginStage(Text("Saving while frames are drawn"),
                             cameras_.size() * static_cast<std::size_t>(2 * options_.blocks + 1));
        SavingTimes warmUp;
        MACULA_TRY_VOID(drawBlock(false, warmUp));
        MACULA_TRY(times.firstMs, saveAndWait());
        MACULA_TRY(times.firstBytes, storedBytes());
        for (int i = 0; i < options_.blocks; ++i) {
            MACULA_TRY_VOID(drawBlock(false, times));
            MACULA_TRY_VOID(drawBlock(true, times));
        }
        keeper_->waitUntilIdle();
        std::vector<double> later;
        for (int i = 0; i < kLaterSaves; ++i) {
            MACULA_TRY(const double ms, saveAndWait());
            later.push_back(ms);
        }
        times.laterMs = median(std::move(later));
        MACULA_TRY(times.laterBytes, storedBytes());
        return times;
    }

    Result<ClosingTimes> close() {
        ClosingTimes times;
        const auto start = Clock::now();
        model_->hide();
        store_->handOver();
        times.hideMs = msSince(start);
        model_.reset();
        store_.reset();
        keeper_.reset();
        times.savedMs = msSince(start);
        MACULA_TRY_VOID(scene_.checkKeepers());
        return times;
    }

  private:
    void askForSave() {
        model_->save();
        store_->handOver();
    }

    Result<double> saveAndWait() {
        const auto start = Clock::now();
        askForSave();
        keeper_->waitUntilIdle();
        const double ms = msSince(start);
        MACULA_TRY_VOID(scene_.checkKeepers());
        return ms;
    }

    Result<std::uint64_t> storedBytes() const {
        MACULA_TRY(session::Store store, scene_.openStore());
        MACULA_TRY(const session::ModelInfo info, storedModel(store));
        return info.bytes;
    }

    Result<void> drawBlock(bool isSaving, SavingTimes& times) {
        keeper_->waitUntilIdle();
        for (std::size_t i = 0; i < cameras_.size(); ++i) {
            if (progress_.cancelled()) return cancelledError();
            const bool asks = isSaving && i % kSavesEvery == 0;
            const auto start = Clock::now();
            if (asks) {
                askForSave();
                times.callsMs.push_back(msSince(start));
            }
            const bool isBeside = asks || (isSaving && !keeper_->isIdle());
            MACULA_TRY_VOID(scene_.draw(*model_, cameras_[i]));
            const double ms = msSince(start);
            if (!isSaving)
                times.without.ms.push_back(ms);
            else if (isBeside)
                times.beside.ms.push_back(ms);
            else
                ++times.framesBetween;
            progress_.advance();
        }
        return scene_.checkKeepers();
    }

    StoredScene& scene_;
    const StoreRoundTripOptions& options_;
    const std::vector<Camera>& cameras_;
    Progress& progress_;
    double seconds_ = 0.0;
    // In this order, because the model uses the store, which uses the keeper.
    std::unique_ptr<live::StudyKeeper> keeper_;
    std::shared_ptr<WatchedStore> store_;
    std::optional<hybrid::LiveModel> model_;
};

Result<StoreRoundTrip> measureModel(StoredScene& scene, const StoreRoundTripOptions& options) {
    StoreRoundTrip measured;
    MACULA_TRY(const std::vector<Camera> cameras, scene.turn(options.frames));
    FirstRun first(scene, options, cameras);
    MACULA_TRY_VOID(first.learn());
    MACULA_TRY(measured.saving, first.save());
    measured.learnt = first.learnt();
    const std::shared_ptr<const splat::Splats> before = first.shown();
    MACULA_TRY(measured.closing, first.close());
    Progress& progress = scene.progress();
    progress.beginStage(Text("Opening it again"), 3);
    MACULA_TRY(measured.reading, measureReading(scene));
    progress.advance();
    for (const bool isKeeperReady : {false, true}) {
        MACULA_TRY(const Reopening reopening,
                   measureReopening(scene, isKeeperReady, cameras.front(), *before));
        measured.reopenings.push_back(reopening);
        progress.advance();
    }
    return measured;
}

}  // namespace

Result<void> check(const BenchStudyOptions& study, const StoreRoundTripOptions& options) {
    MACULA_TRY(const auto lights, builtInLights(study.lights));
    MACULA_TRY_VOID(scene::checkPatientLights(trace::Environment::fromRig(*lights), study.lights));
    return checkFolder(options.folder);
}

Result<StoreRoundTrip> measureSession(const BenchStudy& study, const StoreRoundTripOptions& options,
                                      Progress& progress) {
    MACULA_TRY_VOID(scene::checkPatientLights(study.environment, study.lights));
    MACULA_TRY(scene::Drawing drawing, drawingOf(study));
    MACULA_TRY(const Workplace place, makeWorkplace(options.folder));
    StoreRoundTrip measured;
    {
        MACULA_TRY(live::SceneOnDevice onDevice, study.putOnDevice());
        StoredScene scene(study, std::move(drawing), std::move(onDevice), place.folder, progress);
        MACULA_TRY(measured, measureModel(scene, options));
    }
    if (options.large) {
        MACULA_TRY(const Draft draft, Draft::beside(place.folder, Draft::Kind::folder));
        MACULA_TRY(measured.store, measureStore(draft.path() / "store", {}, progress));
    }
    return measured;
}

double FrameTimes::percentileMs(double fraction) const {
    return image::percentile(ms, fraction);
}

double FrameTimes::maxMs() const {
    MACULA_CHECK(!ms.empty());
    return *std::ranges::max_element(ms);
}

std::array<std::size_t, kFrameBucketsMs.size() + 1> FrameTimes::histogram() const {
    std::array<std::size_t, kFrameBucketsMs.size() + 1> frames{};
    for (const double each : ms) {
        const auto bucket = std::ranges::lower_bound(kFrameBucketsMs, each);
        ++frames.at(static_cast<std::size_t>(std::distance(kFrameBucketsMs.begin(), bucket)));
    }
    return frames;
}

}  // namespace macula::evaluate
