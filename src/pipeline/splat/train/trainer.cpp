#include "pipeline/splat/train/trainer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/train/dice.h"
#include "pipeline/splat/train/regrouped_state.h"

namespace macula::splat {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point time) {
    return std::chrono::duration<double, std::milli>(Clock::now() - time).count();
}

constexpr int kMostHalvings = 15;

Result<void> check(const TrainerOptions& o) {
    const bool stages = std::all_of(o.stages.begin(), o.stages.end(), [](const TrainingStage& stage) {
        return stage.halvings >= 0 && stage.halvings <= kMostHalvings;
    });
    const auto isShare = [](double share) { return share >= 0.0 && share <= 1.0; };
    const bool density =
        o.density.every > 0 && isShare(o.density.unseenShare) && isShare(o.density.splitShare);
    if (stages && density && o.loss.dssimWeight >= 0.0f && o.loss.dssimWeight <= 1.0f &&
        o.loss.exposure > 0.0f && std::isfinite(o.loss.exposure))
        return {};
    return Error{ErrorCode::usage,
                 Text("The settings of the training make no sense."),
                 {},
                 Text("Pictures are halved 0 to 15 times, the weight of D-SSIM and the shares of splats are "
                      "0 to 1, the "
                      "exposure and the steps between density control above 0.")};
}

}  // namespace

Trainer::Trainer(std::shared_ptr<gpu::Device> device, TrainerOptions options, Splats like,
                 std::shared_ptr<const LossKernels> lossKernels, SplatBuffer parameters,
                 SplatBuffer gradients, Rasterizer rasterizer, Optimizer optimizer)
    : device_(std::move(device)),
      options_(std::move(options)),
      like_(std::move(like)),
      lossKernels_(std::move(lossKernels)),
      parameters_(std::move(parameters)),
      gradients_(std::move(gradients)),
      rasterizer_(std::move(rasterizer)),
      optimizer_(std::move(optimizer)) {}

Result<Trainer> Trainer::create(const std::shared_ptr<gpu::Device>& device, const Splats& model,
                                const TrainerOptions& options, ListMaker lists) {
    MACULA_TRY_VOID(check(options));
    MACULA_TRY_VOID(model.validate());
    if (model.shDegree > 1) {
        return Error{ErrorCode::usage,
                     Text("Models of this degree of colour can be shown, but not trained."),
                     {},
                     Text("Reduce the model to degree 1.")};
    }
    const auto count = static_cast<std::uint32_t>(model.size());
    const std::uint32_t capacity = std::max({options.capacity, count, 1u});
    const int degree = model.shDegree;
    MACULA_TRY(auto lossKernels, LossKernels::create(device));
    MACULA_TRY(SplatBuffer parameters, SplatBuffer::create(device, "splats", capacity, degree));
    MACULA_TRY(SplatBuffer gradients, SplatBuffer::create(device, "derivatives", capacity, degree));
    MACULA_TRY(Rasterizer rasterizer, Rasterizer::create(device, capacity, degree, {.lists = lists}));
    MACULA_TRY(Optimizer optimizer, Optimizer::create(device, capacity, degree, options.optimizer));
    MACULA_TRY_VOID(parameters.upload(componentsOf(model)));
    Splats like = model;
    like.resize(0);
    Trainer trainer(device, options, std::move(like), std::move(lossKernels), std::move(parameters),
                    std::move(gradients), std::move(rasterizer), std::move(optimizer));
    trainer.count_ = count;
    trainer.options_.capacity = capacity;
    MACULA_TRY_VOID(trainer.keep());
    return trainer;
}

Result<void> Trainer::addView(TrainingView view) {
    return addView(std::make_shared<const TrainingView>(std::move(view)));
}

Result<void> Trainer::addView(std::shared_ptr<const TrainingView> given) {
    MACULA_TRY(PicturePyramid pictures, PicturePyramid::upload(device_, *lossKernels_, *given));
    // Makes the loss now, because a view that no step can compare would stop all later steps.
    MACULA_TRY([[maybe_unused]] const Loss* loss, lossFor(given->view.sizePx));
    lastGood_.views.push_back({.given = given});
    views_.add({.pictures = std::move(pictures), .given = std::move(given)});
    return {};
}

Result<void> Trainer::replaceView(std::size_t index, TrainingView view) {
    MACULA_CHECK(index < views_.size() && view.view.sizePx == views_[index].given->view.sizePx);
    const auto given = std::make_shared<const TrainingView>(std::move(view));
    MACULA_TRY(PicturePyramid pictures, PicturePyramid::upload(device_, *lossKernels_, *given));
    const double heavier = double(given->weight) / double(views_[index].given->weight);
    const auto replace = [&](auto& known) {
        known.given = given;
        if (known.loss >= 0.0) known.loss *= heavier;
    };
    views_[index].pictures = std::move(pictures);
    replace(views_[index]);
    replace(lastGood_.views[index]);
    return {};
}

void Trainer::forgetStandIns() {
    views_.forgetStandIns();
    std::erase_if(lastGood_.views, [](const TrainingState::View& view) { return !isPicture(*view.given); });
}

Result<Loss*> Trainer::lossFor(glm::ivec2 sizePx) {
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    if (!loss_ || loss_->mostPixels() < pixels) {
        loss_.reset();  // first, because both at once may not fit
        MACULA_TRY(loss_, Loss::create(device_, lossKernels_, pixels));
    }
    return &*loss_;
}

TrainingStage Trainer::stageNow() const {
    TrainingStage now;
    for (const TrainingStage& stage : options_.stages)
        if (stage.firstStep <= steps_) now = stage;
    return now;
}

// False when there was no room for all pairs: then no splat has moved, and there is room now.
Result<bool> Trainer::tryStep(const PictureLevel& level, Loss& loss, const LossStep& over) {
    const Blending blending = blendingOf(like_.lowPass);
    RasterPass pass;
    if (!rasterizer_.listsOnDevice()) {
        MACULA_TRY(pass, rasterizer_.draw(parameters_, count_, level.view, blending));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "training step"));
    if (rasterizer_.listsOnDevice()) {
        MACULA_TRY(pass, rasterizer_.recordDraw(recorder, parameters_, count_, level.view, blending));
    }
    loss.record(recorder, rasterizer_.picture(), level.target, options_.loss, over);
    MACULA_TRY_VOID(rasterizer_.recordBackward(recorder, pass, parameters_, loss.gradient(), gradients_));
    optimizer_.record(recorder, parameters_, gradients_, rasterizer_.visible(), count_);
    const Result<gpu::Ticket> submitted = recorder.submit();
    if (!submitted) {
        optimizer_.takeBack();
        return submitted.error();
    }
    Result<bool> settled = rasterizer_.settle(pass);
    if (!settled || !*settled) optimizer_.takeBack();
    return settled;
}

Result<double> Trainer::differenceTo(const TrainingView& view) {
    MACULA_TRY(const PicturePyramid pictures, PicturePyramid::upload(device_, *lossKernels_, view));
    const PictureLevel& level = pictures.whole();
    MACULA_TRY(Loss * loss, lossFor(level.view.sizePx));
    MACULA_TRY_VOID(rasterizer_.draw(parameters_, count_, level.view, blendingOf(like_.lowPass)));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "compare"));
    loss->record(recorder, rasterizer_.picture(), level.target, options_.loss,
                 {.measure = LossMeasure::absolute,
                  .background = glm::vec3(0.0f),
                  .viewWeight = 1.0f,
                  .coverageOnly = view.kind == ViewKind::outline});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY(const shared::SplatLossResult result, loss->read());
    return double(result.l1);
}

// Tries again after outOfMemory: buffers that were replaced while commands were recorded are freed only
// afterwards, and may be the missing memory.
Result<bool> Trainer::tryStepTwice(const PictureLevel& level, Loss& loss, const LossStep& over) {
    Result<bool> done = tryStep(level, loss, over);
    if (done || done.error().code != ErrorCode::outOfMemory || device_->pendingDestructions() == 0)
        return done;
    MACULA_TRY_VOID(device_->waitForAll());
    return tryStep(level, loss, over);
}

Result<shared::SplatLossResult> Trainer::stepOf(TrainedView& view) {
    if (!view.pictures) {
        MACULA_TRY(view.pictures, PicturePyramid::upload(device_, *lossKernels_, *view.given));
    }
    const TrainingStage stage = stageNow();
    MACULA_TRY(const PictureLevel* level, view.pictures->halved(stage.halvings, *lossKernels_));
    MACULA_TRY(Loss * loss, lossFor(level->view.sizePx));
    Dice dice(options_.seed, steps_, 1);
    const double red = dice();
    const double green = dice();
    const LossStep over{.measure = stage.measure,
                        .background = glm::vec3(red, green, dice()),
                        .viewWeight = view.given->weight,
                        .coverageOnly = view.given->kind == ViewKind::outline};

    for (bool done = false; !done;) {
        MACULA_TRY(done, tryStepTwice(*level, *loss, over));
    }
    return loss->read();
}

// When a view does not fit the memory, others take its turn: otherwise each new try of the same step would
// draw it again, and fail for ever.
Result<void> Trainer::oneStep() {
    Error noRoom;
    while (const std::optional<std::size_t> next = views_.next(options_.seed, steps_)) {
        TrainedView& view = views_[*next];
        const Result<shared::SplatLossResult> result = stepOf(view);
        if (!result && result.error().code == ErrorCode::outOfMemory) {
            view.hasNoRoom = true;
            noRoom = result.error();
            continue;
        }
        if (!result) return result.error();
        view.loss = double(result->loss);
        view.l1 = double(result->l1);
        ++steps_;
        if (isTimeToRegroup()) MACULA_TRY_VOID(regroupSplats());
        return {};
    }
    views_.tryAllAgain();
    return noRoom;
}

bool Trainer::isTimeToRegroup() const {
    const DensityOptions& density = options_.density;
    return steps_ >= density.firstStep && steps_ <= density.lastStep &&
           (steps_ - density.firstStep) % density.every == 0;
}

Result<void> Trainer::regroupSplats() {
    MACULA_TRY(const Splats before, snapshot());
    MACULA_TRY(auto statistics, gpu::read<shared::SplatStatistics>(rasterizer_.statistics()));
    statistics.resize(count_);
    MACULA_TRY(const OptimizerState known, optimizer_.download(count_));
    const Regrouped regrouped = regroup(before, statistics, options_.density, parameters_.capacity());
    const OptimizerState state =
        regroupedState(known, regrouped, static_cast<std::size_t>(parameters_.components()));
    MACULA_TRY_VOID(optimizer_.upload(state));
    MACULA_TRY_VOID(parameters_.upload(componentsOf(regrouped.splats)));
    count_ = static_cast<std::uint32_t>(regrouped.source.size());
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "clear statistics"));
    rasterizer_.clearStatistics(recorder);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    views_.tryAllAgain();
    return {};
}

Result<TrainingReport> Trainer::step(std::uint64_t steps, const std::function<bool()>& keepGoing) {
    if (views_.size() == 0)
        return Error{
            ErrorCode::usage, Text("There is no picture to learn from."), {}, Text("Add views first.")};
    for (std::uint64_t i = 0; i < steps; ++i) {
        MACULA_TRY_VOID(oneStep());
        if (!(millisecondsSince(keptAt_) < options_.keepEveryMs)) MACULA_TRY_VOID(keep());
        if (keepGoing && !keepGoing()) break;
    }
    return report();
}

Result<Splats> Trainer::snapshot() const {
    MACULA_TRY(const std::vector<float> components, parameters_.download(count_));
    return splatsOf(components, like_);
}

TrainingReport Trainer::report() const {
    const TrainedViews::Means means = views_.means();
    return {.steps = steps_, .loss = means.loss, .l1 = means.l1, .splats = count_};
}

}  // namespace macula::splat
