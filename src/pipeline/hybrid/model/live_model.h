// The peripheral model of what is on a screen: found, taught while nothing moves, or in the time between two
// frames, and drawn while something does. All of it in slices, so that whoever has the thread keeps it.
//
//     model.show(key, settings);                       // what the scene shows now, or showed before
//     if (model.hasWork()) model.work(20.0, keepGoing);
//     if (model.canBeDrawn()) picture = model.draw(camera, sizePx);
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/brightness_gauge.h"
#include "pipeline/hybrid/model/learning_pace.h"
#include "pipeline/hybrid/model/model_news.h"
#include "pipeline/hybrid/model/model_shelf.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/hybrid/model/peripheral_model.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

struct LiveModelOptions {
    PeripheralOptions model;            // wanted.sizePx: of the pictures that it learns from
    trace::SurfacePointOptions points;  // count: at most model.firstCapacity
    std::uint32_t samplesPerPixel = 2;  // of these pictures
    std::uint64_t roughSteps = 0;       // first steps of training, which take
    int roughSidePx = 0;                // pictures of such sides
    std::size_t views = 48;             // pictures in all
    // Of training: at least so many, and so many more that training takes as long as tracing does.
    std::uint64_t stepsBetweenViews = 8;
    std::uint64_t mostStepsBetweenViews = 24;
    std::uint64_t stepsBeforeShown = 40;               // of training, on the small pictures of the gauge
    std::chrono::milliseconds mostWaitForStore{2000};  // then it begins without
    std::chrono::milliseconds leastBetweenKeeping{20000};
    std::optional<double> dispatchMs = {};  // of tracing its views; nothing: as PathTracer has it
};
// What is fast enough on the device to be taught beside a picture that converges.
LiveModelOptions liveModelOptions(const gpu::Device& device);

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
        return stage_ == ModelStage::resuming || (model_ && stage_ != ModelStage::searching);
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
    const gpu::Buffer& drawnDepths() const { return painter_->depthsOnDevice(); }
    double gain() const { return gain_; }

    // The model that draw() draws; null when there is none.
    std::shared_ptr<const splat::Splats> shown() const;
    // All that it goes on with; null while nothing was learnt. Waits.
    Result<std::shared_ptr<const PeripheralState>> state() const;
    ModelNews news() const;
    // Of the model that learns; nothing while there is none.
    std::optional<PeripheralReport> report() const;
    const std::string& key() const { return key_; }

  private:
    LiveModel(std::shared_ptr<gpu::Device> device, trace::PathTracer tracer,
              std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
              const LiveModelOptions& options);

    // What tells a model from itself some time before.
    struct Kept {
        std::uint64_t steps = 0;
        std::uint64_t generation = 0;
        double gain = 1.0;
        bool operator==(const Kept&) const = default;
    };

    void putAway();
    void keepWhole();
    void giveToStore(std::shared_ptr<const PeripheralState> state);
    void put(PeripheralState state);
    void keepSometimes();
    Result<void> askStore(const std::function<bool()>& goesOn);
    Result<void> takeFromStore(const StoredModel& stored);
    Result<void> drawStored(const StoredModel& stored);
    Result<void> goOnWith(const PeripheralState& state, ModelOrigin origin);
    void beginWithPoints(ModelOrigin origin);
    Result<void> makeDrawable();
    void end(ModelStage stage);
    Result<void> tryShow();
    Result<void> searchSome(double budgetMs, const std::function<bool()>& goesOn);
    Result<void> takeFirstSteps(double budgetMs, const std::function<bool()>& goesOn);
    Result<void> beginSearch();
    Result<void> learnSome(const std::function<bool()>& goesOn);
    Result<void> askForView();
    Result<void> traceWanted(const std::function<bool()>& goesOn);
    Result<void> takeWanted();
    Result<void> doPart(LearningPart part, const std::function<bool()>& goesOn);
    std::optional<LearningPart> nextWithin(double leftMs) const;
    Result<void> withoutRoom(Result<void> done);
    bool wantsView() const;
    bool isSharp() const;
    bool isShownDrawn() const { return painter_ && model_->shown().splats == drawn_; }

    std::shared_ptr<gpu::Device> device_;
    trace::PathTracer tracer_;
    std::shared_ptr<ModelShelf> shelf_;
    std::shared_ptr<ModelStore> store_;
    LiveModelOptions options_;
    std::string key_;  // empty: nothing is shown
    trace::Settings settings_;
    ModelStage stage_ = ModelStage::none;
    ModelOrigin origin_ = ModelOrigin::none;
    std::optional<std::chrono::steady_clock::time_point> askingSince_;  // the store; it has not answered yet
    std::uint64_t stepsOfStored_ = 0;                                   // of what is drawn while it resumes
    std::optional<StoredModel> whole_;                // that is drawn, and gone on with next
    std::shared_ptr<const splat::Splats> startWith_;  // instead of points, another model of the store
    Kept kept_;                                       // what the store was given last
    std::chrono::steady_clock::time_point keptAt_;
    // Set by the search; a model from the shelf has the gauge only, which is made anew.
    std::optional<Box> seenMm_;
    std::optional<trace::SurfacePoints> points_;  // found, while the gauge is made
    std::optional<BrightnessGauge> gauge_;
    std::optional<PeripheralModel> model_;
    struct LookedAt {
        Camera camera;
        std::uint32_t samples = 0;  // of each pixel
    };
    std::optional<LookedAt> lookedAt_;  // the last picture on screen that it has learnt from
    std::optional<Camera> wanted_;      // the view that is traced for it now
    bool isWantedTraced_ = false;       // and is to be taken
    LearningPace pace_;
    std::size_t views_ = 0;  // views that the model was given, or asked for in vain
    std::uint64_t stepsAtLastView_ = 0;
    double lastViewMs_ = 0.0;                     // that tracing took
    double trainedMs_ = 0.0;                      // since that
    std::shared_ptr<const splat::Splats> drawn_;  // what the painter has
    std::optional<splat::ModelPainter> painter_;
    double gain_ = 1.0;  // of the painter's model, see gain()
};

}  // namespace macula::hybrid
