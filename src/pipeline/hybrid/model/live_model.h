// The peripheral model of the scene on a screen. It is found and taught while nothing moves or between two
// frames, and drawn while the view moves. All work is done in slices, so that the thread stays responsive.
//
//     model.show(key, settings);                       // what the scene shows now
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
    // Makes the model of the scene of `beside`, which it traces with a view of its own. Models that are put
    // away go to the shelf, which may outlive the device, and to the store, which may be null.
    static Result<LiveModel> create(const std::shared_ptr<gpu::Device>& device,
                                    const trace::PathTracer& beside, std::shared_ptr<ModelShelf> shelf,
                                    std::shared_ptr<ModelStore> store, const LiveModelOptions& options);

    // Call when the scene shows what `key` names, in a path-traced look with these settings, and with lights
    // fixed to the patient. Does nothing if the key is the same. Otherwise puts the old model away at once,
    // and finds that of the key on the shelf or in the store, or begins one. A model is never drawn for
    // another key than its own. If the device has no room, the stage says so; other errors are returned.
    // `neighbour`: the splats of a model of nearly the same matter, with which a new model begins if neither
    // shelf nor store has anything of this key; their places and shapes stay until training moves them.
    // Null: it begins with points.
    Result<void> show(const std::string& key, const trace::Settings& settings,
                      std::shared_ptr<const splat::Splats> neighbour = nullptr);
    // Call when the screen shows nothing that has a model: puts the present one away, and draws none.
    void hide();
    // Puts the model away, and makes none until another key is shown; `stage` says why: noRoom or failed.
    void giveUp(ModelStage stage);
    // Call after the device was lost: puts away the model as it was at most a few seconds ago.
    void save();

    bool canBeDrawn() const {
        return stage_ == ModelStage::resuming || (taught_.exists() && stage_ != ModelStage::searching);
    }
    bool hasWork() const {
        return stage_ == ModelStage::searching || stage_ == ModelStage::resuming ||
               stage_ == ModelStage::learning;
    }
    // Works for about `budgetMs`, at least one dispatch of some 40 ms or one step; asks `keepGoing` between
    // these. Lack of memory ends the search or the learning, and is not an error.
    Result<void> work(double budgetMs, const std::function<bool()>& keepGoing);

    // The same between two frames of a picture in motion: only parts that, by their times so far, fit into
    // `leftMs`, and none that was never done before.
    Result<void> workWithin(double leftMs, const std::function<bool()>& keepGoing);

    // Learns from the picture on screen, which `tracer` has traced for its view `view` with `samples` per
    // pixel: once for each pose, and again with four times as many samples. Only while canBeDrawn(); waits
    // for the device. Does nothing if there is no room, or the picture has more than kMostPixelsToLearn.
    static constexpr std::int64_t kMostPixelsToLearn = 2560 * 1440;
    Result<void> learnFrom(trace::PathTracer& tracer, const trace::View& view, std::uint32_t samples);

    // Returns a linear, premultiplied picture on the device, valid until the next one, and finished when the
    // submitted work is. Multiply its light by gain() to make it as bright as traced pictures
    // (brightness_gauge.h). Gives the model up if memory does not suffice, and fails with outOfMemory.
    Result<const splat::DevicePicture*> draw(const Camera& camera, const glm::ivec2& sizePx,
                                             double nearMm = splat::RasterView{}.nearMm);
    // The Rasterizer::depths of that picture.
    const gpu::Buffer& drawnDepths() const { return taught_.drawn().depths(); }
    double gain() const { return taught_.drawn().gain(); }

    // The model that draw() draws; null when there is none.
    std::shared_ptr<const splat::Splats> shown() const;
    // All that the model needs to continue; null while nothing was learnt. Waits for the device.
    Result<std::shared_ptr<const PeripheralState>> state() const;
    ModelNews news() const;
    // Of the model that learns, if there is one.
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
    Result<void> tryShow(std::shared_ptr<const splat::Splats> neighbour);
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
    std::uint64_t stepsOfStored_ = 0;  // training steps of the model drawn while resuming
    ModelSearch search_;
    TaughtModel taught_;
};

}  // namespace macula::hybrid
