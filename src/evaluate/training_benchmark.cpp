#include "evaluate/training_benchmark.h"

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "pipeline/splat/draw/rasterizer.h"
#include "pipeline/splat/draw/reference_rasterizer.h"
#include "pipeline/splat/train/loss.h"
#include "pipeline/splat/train/optimizer.h"
#include "pipeline/splat/train/reference_loss.h"
#include "pipeline/splat/train/reference_optimizer.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::evaluate {

using namespace splat;  // the namespace that is measured

namespace {

// The background over which both compare pictures.
constexpr glm::vec3 kBackground{0.25f, 0.5f, 0.75f};

struct Turn {
    Spent project, lists, deviceLists, raster, loss, backward, adam, step;
};

// All that a step needs, on the device.
struct Tools {
    SplatBuffer parameters;
    SplatBuffer gradients;
    SplatBuffer moved;  // by Adam; the drawn model does not change
    Rasterizer rasterizer;
    Rasterizer deviceSorted;
    LossTarget target;
    Loss loss;
    Optimizer optimizer;
    Trainer trainer;
};

Result<Tools> makeTools(const std::shared_ptr<gpu::Device>& device, const Splats& model,
                        const TrainingView& view, const TrainerOptions& options) {
    const auto count = static_cast<std::uint32_t>(model.size());
    const glm::ivec2 size = view.view.sizePx;
    MACULA_TRY(SplatBuffer parameters, SplatBuffer::create(device, "splats", count, model.shDegree));
    MACULA_TRY_VOID(parameters.upload(componentsOf(model)));
    MACULA_TRY(SplatBuffer gradients, SplatBuffer::create(device, "derivatives", count, model.shDegree));
    MACULA_TRY(SplatBuffer moved, SplatBuffer::create(device, "moved splats", count, model.shDegree));
    MACULA_TRY(Rasterizer rasterizer, Rasterizer::create(device, count, model.shDegree));
    MACULA_TRY(Rasterizer deviceSorted,
               Rasterizer::create(device, count, model.shDegree, {.lists = ListMaker::device}));
    MACULA_TRY(const auto kernels, LossKernels::create(device));
    MACULA_TRY(DevicePicture picture,
               DevicePicture::upload(device, "picture to learn from", size.x, size.y, view.pixels));
    MACULA_TRY(LossTarget target, LossTarget::create(*kernels, std::move(picture)));
    MACULA_TRY(Loss loss, Loss::create(device, kernels, std::uint64_t(size.x) * std::uint64_t(size.y)));
    MACULA_TRY(Optimizer optimizer, Optimizer::create(device, count, model.shDegree, options.optimizer));
    MACULA_TRY(Trainer trainer, Trainer::create(device, model, options));
    MACULA_TRY_VOID(trainer.addView(view));
    return Tools{.parameters = std::move(parameters),
                 .gradients = std::move(gradients),
                 .moved = std::move(moved),
                 .rasterizer = std::move(rasterizer),
                 .deviceSorted = std::move(deviceSorted),
                 .target = std::move(target),
                 .loss = std::move(loss),
                 .optimizer = std::move(optimizer),
                 .trainer = std::move(trainer)};
}

class Bench {
  public:
    Bench(std::shared_ptr<gpu::Device> device, const Splats& model, const TrainingView& view,
          const TrainerOptions& options, Tools tools)
        : device_(std::move(device)),
          model_(model),
          view_(view),
          options_(options),
          blending_(blendingOf(model.lowPass)),
          tools_(std::move(tools)),
          target_(view.pixels.begin(), view.pixels.end()),
          optimizer_(model.size(), model.shDegree, options.optimizer),
          parameters_(toDouble(componentsOf(model))) {}

    // Times each stage until the device has finished it.
    Result<Turn> deviceTurn() {
        Turn turn;
        Tools& t = tools_;
        const auto count = static_cast<std::uint32_t>(model_.size());
        MACULA_TRY_VOID(device_->waitForAll());
        Watch watch;
        const auto draw = [&](Rasterizer& rasterizer, Turn& into) {
            watch.lap();
            return rasterizer.draw(t.parameters, count, view_.view, blending_,
                                   [&](DrawStage stage) -> Result<void> {
                                       MACULA_TRY_VOID(device_->waitForAll());
                                       (stage == DrawStage::project ? into.project
                                        : stage == DrawStage::lists ? into.lists
                                                                    : into.raster) = watch.lap();
                                       return {};
                                   });
        };
        Turn sorted;
        MACULA_TRY_VOID(draw(t.deviceSorted, sorted));
        turn.deviceLists = sorted.lists;
        MACULA_TRY(const RasterPass pass, draw(t.rasterizer, turn));
        pairs_ = pass.pairCount();
        const auto timeOf = [&](Spent& time,
                                const std::function<Result<void>(gpu::Recorder&)>& record) -> Result<void> {
            watch.lap();
            MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "benchmark"));
            MACULA_TRY_VOID(record(recorder));
            MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
            MACULA_TRY_VOID(device_->waitForAll());
            time = watch.lap();
            return {};
        };
        MACULA_TRY_VOID(timeOf(turn.loss, [&](gpu::Recorder& recorder) -> Result<void> {
            t.loss.record(recorder, t.rasterizer.picture(), t.target, options_.loss, kOver);
            return {};
        }));
        MACULA_TRY_VOID(timeOf(turn.backward, [&](gpu::Recorder& recorder) {
            return t.rasterizer.recordBackward(recorder, pass, t.parameters, t.loss.gradient(), t.gradients);
        }));
        MACULA_TRY_VOID(timeOf(turn.adam, [&](gpu::Recorder& recorder) -> Result<void> {
            t.optimizer.record(recorder, t.moved, t.gradients, t.rasterizer.visible(), count);
            return {};
        }));
        watch.lap();
        MACULA_TRY_VOID(t.trainer.step(1));
        turn.step = watch.lap();
        return turn;
    }

    Turn referenceTurn() {
        Turn turn;
        const ReferenceSplats splats(model_);
        Watch watch;
        const auto projected = projectSplats(splats, view_.view, blending_, Precision::twofold);
        turn.project = watch.lap();
        const RasterImage image = rasterize(splats, view_.view, blending_, Precision::twofold);
        turn.raster = watch.lap() - turn.project;
        ReferenceLoss loss =
            referenceLoss(image.sizePx.x, image.sizePx.y, image.rgba, target_, options_.loss, kOver);
        turn.loss = watch.lap();
        const RasterGradient gradient{.rgba = std::move(loss.gradient), .depth = {}};
        watch.lap();
        const ReferenceSplats derivative =
            rasterizeBackward(splats, view_.view, blending_, image, gradient, Precision::twofold);
        turn.backward = watch.lap() - turn.project;
        const std::vector<double> gradients = componentsOf(derivative);
        std::vector<std::uint32_t> visible;
        for (const ProjectedSplat& splat : projected) visible.push_back(splat.opacity > 0.0 ? 1 : 0);
        watch.lap();
        optimizer_.step(parameters_, gradients, visible);
        turn.adam = watch.lap();
        turn.step = turn.project + turn.raster + turn.loss + turn.backward + turn.adam;
        return turn;
    }

    std::uint64_t pairs() const { return pairs_; }

  private:
    static constexpr LossStep kOver{.background = kBackground, .viewWeight = 1.0f};

    static std::vector<double> toDouble(const std::vector<float>& values) {
        return {values.begin(), values.end()};
    }
    // As componentsOf(Splats), in double.
    static std::vector<double> componentsOf(const ReferenceSplats& splats) {
        const std::size_t count = splats.size();
        std::vector<double> values(count * static_cast<std::size_t>(componentCount(splats.shDegree)));
        const auto put = [&](std::size_t i, int component, const auto& value, int numbers) {
            for (int k = 0; k < numbers; ++k)
                values[static_cast<std::size_t>(component + k) * count + i] = value[k];
        };
        for (std::size_t i = 0; i < count; ++i) {
            put(i, shared::kSplatPosition, splats.position[i], 3);
            put(i, shared::kSplatLogScale, splats.logScale[i], 3);
            put(i, shared::kSplatRotation, splats.rotation[i], 4);
            put(i, shared::kSplatOpacity, glm::dvec2(splats.opacityLogit[i]), 1);
            put(i, shared::kSplatDc, splats.dc[i], 3);
            for (std::size_t k = 0; k < shCount(splats.shDegree); ++k)
                put(i, shared::kSplatSh + 3 * static_cast<int>(k),
                    splats.sh[i * shCount(splats.shDegree) + k], 3);
        }
        return values;
    }
    static std::vector<float> componentsOf(const Splats& splats) { return splat::componentsOf(splats); }

    std::shared_ptr<gpu::Device> device_;
    const Splats& model_;
    const TrainingView& view_;
    const TrainerOptions& options_;
    Blending blending_;
    Tools tools_;
    std::vector<glm::dvec4> target_;
    std::uint64_t pairs_ = 0;  // pairs of splat and tile in the last turn
    ReferenceOptimizer optimizer_;
    std::vector<double> parameters_;
};

Contender contenderOf(const std::vector<Turn>& turns, Spent Turn::*stage) {
    Contender contender;
    for (const Turn& turn : turns) contender.turns.push_back(turn.*stage);
    return contender;
}

StageBenchmark compare(const std::vector<Turn>& device, const std::vector<Turn>& reference,
                       Spent Turn::*stage) {
    const Contender ours = contenderOf(device, stage);
    const Contender scalar = contenderOf(reference, stage);
    return {.device = ours.medians(), .reference = scalar.medians(), .ratio = ours.ratioTo(scalar)};
}

}  // namespace

Result<TrainingBenchmark> benchmarkTraining(const std::shared_ptr<gpu::Device>& device, const Splats& model,
                                            const TrainingView& view, const TrainingBenchmarkOptions& options,
                                            Progress& progress) {
    if (model.size() == 0)
        return Error{ErrorCode::usage,
                     Text("There are no splats to train."),
                     {},
                     Text("Choose a model that has some.")};
    TrainerOptions trainer = options.trainer;
    trainer.stages = {};
    trainer.density.lastStep = 0;
    trainer.keepEveryMs = std::numeric_limits<double>::infinity();
    MACULA_TRY(Tools tools, makeTools(device, model, view, trainer));
    Bench bench(device, model, view, trainer, std::move(tools));
    MACULA_TRY([[maybe_unused]] const Turn first, bench.deviceTurn());
    std::vector<Turn> deviceTurns;
    std::vector<Turn> referenceTurns;
    for (int i = 0; i < options.repetitions; ++i) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("The benchmark was cancelled."), {}, {}};
        MACULA_TRY(const Turn turn, bench.deviceTurn());
        deviceTurns.push_back(turn);
        referenceTurns.push_back(bench.referenceTurn());
        progress.advance();
    }
    const auto stage = [&](Spent Turn::*which) { return compare(deviceTurns, referenceTurns, which); };
    return TrainingBenchmark{
        .pairs = bench.pairs(),
        .project = stage(&Turn::project),
        .lists = {.device = contenderOf(deviceTurns, &Turn::lists).medians(), .reference = {}},
        .deviceLists = {.device = contenderOf(deviceTurns, &Turn::deviceLists).medians(), .reference = {}},
        .raster = stage(&Turn::raster),
        .loss = stage(&Turn::loss),
        .backward = stage(&Turn::backward),
        .adam = stage(&Turn::adam),
        .step = stage(&Turn::step)};
}

}  // namespace macula::evaluate
