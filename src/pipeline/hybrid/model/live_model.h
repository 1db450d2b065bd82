// The peripheral model of what is on a screen: found, taught while nothing moves, or in the time between two
// frames, and drawn while something does. All of it in slices, so that whoever has the thread keeps it.
//
//     model.show(key, settings);                       // what the scene shows now, or showed before
//     if (model.hasWork()) model.work(20.0, keepGoing);
//     if (model.canBeDrawn()) picture = model.draw(camera, sizePx);
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/model/live_model_options.h"
#include "pipeline/hybrid/model/model_archive.h"
#include "pipeline/hybrid/model/model_news.h"
#include "pipeline/hybrid/model/model_search.h"
#include "pipeline/hybrid/model/model_shelf.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/hybrid/model/taught_model.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// Used by one thread at a time, the one that uses the device.
class LiveModel {
  public:
    // The model of the scene that `beside` shows; it traces a view of its own of that scene. Models that are
    // put away go to the shelf, which may outlive the device, and to the store, which may be null.
    static Result<LiveModel> create(const std::shared_ptr<gpu::Device>& device,
                                    const trace::PathTracer& beside, std::shared_ptr<ModelShelf> shelf,
                                    std::shared_ptr<ModelStore> store, const LiveModelOptions& options);

    // The scene shows what is called `key`, in a path-traced look with these settings, in light that stays
    // where it is: nothing happens when it did already. Else the model of before is put away at once, and
    // that of the key comes from the shelf or the store, or is searched for. No model is ever drawn for
    // another key than its own. Where the device has no room, the stage says so; other errors are told.
    Result<void> show(const std::string& key, const trace::Settings& settings);
    // The screen shows nothing that has a model: the one there is is put on the shelf, and none is drawn.
    void hide();
    // Drops the model of this key until another key is shown; `stage` says why: noRoom or failed. What was
    // learnt goes to the shelf.
    void giveUp(ModelStage stage);
    // Puts what was learnt until a few seconds ago on the shelf, after the device was lost.
    void save();

    bool canBeDrawn() const {
        return stage_ == ModelStage::resuming || (taught_.exists() && stage_ != ModelStage::searching);
    }
    bool hasWork() const {
        return stage_ == ModelStage::searching || stage_ == ModelStage::resuming ||
               stage_ == ModelStage::learning;
    }
    // A slice: about `budgetMs`, at least one dispatch of some 40 ms or one step; `keepGoing` is asked
    // between these. Running out of memory ends the search or the learning, and is no error.
    Result<void> work(double budgetMs, const std::function<bool()>& keepGoing);

    // The same between two frames of a picture in motion: only what is expected to be done in `leftMs`, by
    // what it took so far; nothing that was never done.
    Result<void> workWithin(double leftMs, const std::function<bool()>& keepGoing);

    // Takes in what `tracer` has traced of its view, which is `view`, with `samples` of each pixel, for a
    // person who looks at it: the model learns all of that, once for each pose, and again with four times as
    // many samples. While it can be drawn; waits. Where there is no room for it, or the picture has more than
    // kMostPixelsToLearn, nothing happens.
    static constexpr std::int64_t kMostPixelsToLearn = 2560 * 1440;
    Result<void> learnFrom(trace::PathTracer& tracer, const trace::View& view, std::uint32_t samples);

    // Linear, premultiplied; on the device until the next is drawn, done when what was submitted is. Its
    // light is to be multiplied by gain() to be as bright as what is traced (brightness_gauge.h). Where it
    // cannot be drawn for lack of memory it is given up, outOfMemory.
    Result<const splat::DevicePicture*> draw(const Camera& camera, const glm::ivec2& sizePx,
                                             double nearMm = splat::RasterView{}.nearMm);
    // Of that picture: Rasterizer::depths.
    const gpu::Buffer& drawnDepths() const { return taught_.drawn().depths(); }
    double gain() const { return taught_.drawn().gain(); }

    // The model that draw() draws; null when there is none.
    std::shared_ptr<const splat::Splats> shown() const;
    // All that it goes on with; null while nothing was learnt. Waits.
    Result<std::shared_ptr<const PeripheralState>> state() const;
    ModelNews news() const;
    // Of the model that learns; nothing while there is none.
    std::optional<PeripheralReport> report() const;
    const std::string& key() const { return key_; }

  private:
    LiveModel(const std::shared_ptr<gpu::Device>& device, trace::PathTracer tracer,
              std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
              const LiveModelOptions& options);

    void putAway();
    Result<void> askStore(const std::function<bool()>& goesOn);
    Result<void> takeFromStore(const StoredModel& stored);
    Result<void> drawStored(const StoredModel& stored);
    Result<void> goOnWith(const PeripheralState& state, ModelOrigin origin);
    void beginWithPoints(ModelOrigin origin);
    void end(ModelStage stage);
    Result<void> tryShow();
    Result<void> searchSome(double budgetMs, const std::function<bool()>& goesOn);
    Result<void> takeFirstSteps(double budgetMs, const std::function<bool()>& goesOn);
    Result<void> learnSome(const std::function<bool()>& goesOn);
    Result<void> withoutRoom(Result<void> done);
    bool isSharp() const;

    LiveModelOptions options_;
    trace::PathTracer tracer_;
    ModelArchive archive_;
    std::string key_;  // empty: nothing is shown
    trace::Settings settings_;
    ModelStage stage_ = ModelStage::none;
    ModelOrigin origin_ = ModelOrigin::none;
    std::uint64_t stepsOfStored_ = 0;  // of what is drawn while it resumes
    ModelSearch search_;
    TaughtModel taught_;
};

}  // namespace macula::hybrid
