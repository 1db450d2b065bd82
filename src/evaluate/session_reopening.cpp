#include "evaluate/session_reopening.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/fingerprint.h"
#include "evaluate/measurement.h"
#include "pipeline/hybrid/model/peripheral_file.h"

namespace macula::evaluate {

namespace {

using Clock = std::chrono::steady_clock;
using Answer = hybrid::StoredModel::Answer;

constexpr int kRepetitions = 5;

template <class T>
bool areSame(const std::vector<T>& a, const std::vector<T>& b) {
    return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

// Bit for bit.
bool areSame(const splat::Splats& a, const splat::Splats& b) {
    return a.originMm == b.originMm && a.axes == b.axes && a.colourSpace == b.colourSpace &&
           a.lowPass == b.lowPass && a.shDegree == b.shDegree && areSame(a.position, b.position) &&
           areSame(a.logScale, b.logScale) && areSame(a.rotation, b.rotation) &&
           areSame(a.opacityLogit, b.opacityLogit) && areSame(a.dc, b.dc) && areSame(a.sh, b.sh);
}

// When the model was first drawn, and when it could continue to learn.
struct Moments {
    std::optional<Clock::time_point> drawn;
    std::optional<Clock::time_point> learning;
};

Result<Moments> goOn(StoredScene& scene, hybrid::LiveModel& model, const WatchedStore& store,
                     const Camera& camera) {
    Moments moments;
    while (true) {
        if (model.report()) moments.learning = Clock::now();
        if (model.canBeDrawn() && !moments.drawn) {
            MACULA_TRY_VOID(scene.draw(model, camera));
            moments.drawn = Clock::now();
        }
        if (moments.learning) return moments;
        const bool isThere = store.last() == Answer::pending || store.last() == Answer::drawable;
        if (!isThere || !model.hasWork()) {
            MACULA_TRY_VOID(scene.checkKeepers());
            return nothingStored();
        }
        MACULA_TRY_VOID(scene.work(model));
    }
}

}  // namespace

Result<ReadingTimes> measureReading(const StoredScene& scene) {
    ReadingTimes times;
    std::optional<session::Store> store;
    MACULA_TRY(times.openStoreMs, timedMs([&]() -> Result<void> {
                   MACULA_TRY(session::Store opened, scene.openStore());
                   store.emplace(std::move(opened));
                   return {};
               }));
    MACULA_TRY(const session::ModelInfo info, storedModel(*store));
    times.blobBytes = info.bytes;
    MACULA_TRY(times.digestMs, medianMs(kRepetitions, [&]() -> Result<void> {
                   (void)fingerprint(*scene.study().volume);
                   return {};
               }));
    MACULA_TRY(const std::filesystem::path file, store->modelFile(info));
    MACULA_TRY(times.drawableMs, medianMs(kRepetitions, [&]() -> Result<void> {
                   std::ifstream stream(file, std::ios::binary);
                   MACULA_TRY([[maybe_unused]] const hybrid::DrawableModel drawable,
                              hybrid::readDrawable(stream, info.bytes));
                   return {};
               }));
    std::string blob;
    MACULA_TRY(times.blobMs, medianMs(kRepetitions, [&]() -> Result<void> {
                   MACULA_TRY(const session::LoadedModel loaded, store->readModel(info));
                   blob.assign(reinterpret_cast<const char*>(loaded.blob.data()), loaded.blob.size());
                   return {};
               }));
    MACULA_TRY(times.unpackMs, medianMs(kRepetitions, [&]() -> Result<void> {
                   std::istringstream stream(blob);
                   MACULA_TRY([[maybe_unused]] const hybrid::PeripheralFile whole,
                              hybrid::readPeripheral(stream, blob.size()));
                   return {};
               }));
    return times;
}

Result<Reopening> measureReopening(StoredScene& scene, bool isKeeperReady, const Camera& camera,
                                   const splat::Splats& before) {
    Reopening reopening{.isKeeperReady = isKeeperReady};
    const std::unique_ptr<live::StudyKeeper> keeper = scene.makeKeeper();
    if (isKeeperReady) (void)keeper->stateOf(scene.study().volume, StoredScene::kPatience);
    const auto store = std::make_shared<WatchedStore>(*keeper);
    MACULA_TRY(hybrid::LiveModel model, scene.makeModel(store));
    const auto start = Clock::now();
    scene.look(*keeper);
    MACULA_TRY_VOID(scene.show(model));
    MACULA_TRY(const Moments moments, goOn(scene, model, *store, camera));
    if (!moments.drawn || !store->wholeAt()) return nothingStored();
    const auto msTo = [&](Clock::time_point end) {
        return std::chrono::duration<double, std::milli>(end - start).count();
    };
    reopening.drawableMs = msTo(*store->drawableAt());
    reopening.firstPictureMs = msTo(*moments.drawn);
    reopening.wholeMs = msTo(*store->wholeAt());
    reopening.learningMs = msTo(*moments.learning);
    const hybrid::PeripheralReport report = *model.report();
    reopening.steps = report.training.steps;
    reopening.trainedError = report.error;
    reopening.shownError = report.shownError;
    reopening.isSame = areSame(*model.shown(), before);
    return reopening;
}

}  // namespace macula::evaluate
