#include "pipeline/splat/train/optimizer.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/native/native_adam.h"
#include "shaders/splat.h"
#include "shared/splat_adam_params.h"

namespace macula::splat {

namespace {

constexpr std::size_t kMostCorrections = std::size_t(1) << 20;

// 1 / (1 - beta^t) of both betas for t = 0, 1, ..., until they are 1 in float. A table, because 1 - 0.999^t
// from the device's own exp and log has hardly three correct digits. At t = 0 there is nothing to correct.
std::vector<glm::vec2> correctionTable(const OptimizerOptions& options) {
    const double beta1 = static_cast<float>(options.beta1);  // as the kernel has it
    const double beta2 = static_cast<float>(options.beta2);
    const double slower = std::max({beta1, beta2, 1e-3});
    const double steps = std::ceil(std::log(std::ldexp(1.0, -25)) / std::log(slower));
    const auto count = static_cast<std::size_t>(std::clamp(steps, 1.0, double(kMostCorrections - 1))) + 1;
    std::vector<glm::vec2> table(count, glm::vec2(1.0f));
    for (std::size_t t = 1; t < count; ++t)
        table[t] = {1.0 / (1.0 - std::pow(beta1, double(t))), 1.0 / (1.0 - std::pow(beta2, double(t)))};
    return table;
}

Result<void> check(const OptimizerOptions& o) {
    const bool rates =
        std::ranges::all_of(std::initializer_list<double>{o.logScale, o.rotation, o.opacityLogit, o.dc, o.sh},
                            [](double rate) { return std::isfinite(rate) && rate >= 0.0; });
    const bool positions =
        std::ranges::all_of(std::initializer_list<double>{o.position, o.positionAtLast, o.othersAtLast},
                            [](double value) { return std::isfinite(value) && value > 0.0; });
    const auto isBeta = [](double beta) { return beta >= 0.0 && static_cast<float>(beta) < 1.0f; };
    const bool betas = isBeta(o.beta1) && isBeta(o.beta2);
    if (rates && positions && betas && o.epsilon >= 1e-30 && o.epsilon <= 1.0) return {};
    return Error{
        .code = ErrorCode::usage,
        .message = Text("The settings of the training make no sense."),
        .where = {},
        .hint = Text("Position rates and decays must be above 0, other rates not below 0, both betas "
                     "from 0 to below 1, "
                     "and epsilon from 1e-30 to 1.")};
}

Result<gpu::Buffer> zeroes(const std::shared_ptr<gpu::Device>& device, const char* label,
                           std::uint64_t bytes) {
    MACULA_TRY(gpu::Buffer buffer, gpu::Buffer::create(device, {.label = label, .bytes = bytes}));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, label));
    recorder.fill(buffer, 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return buffer;
}

}  // namespace

Optimizer::Optimizer(const OptimizerOptions& options, gpu::Kernel kernel, SplatBuffer first,
                     SplatBuffer second, gpu::Buffer steps, gpu::Buffer skipped, gpu::Buffer params,
                     gpu::TexelBuffer corrections)
    : options_(options),
      kernel_(std::move(kernel)),
      first_(std::move(first)),
      second_(std::move(second)),
      steps_(std::move(steps)),
      skipped_(std::move(skipped)),
      params_(std::move(params)),
      corrections_(std::move(corrections)) {}

Result<Optimizer> Optimizer::create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                    int shDegree, const OptimizerOptions& options) {
    MACULA_TRY_VOID(check(options));
    MACULA_TRY(gpu::Kernel kernel,
               gpu::Kernel::create(device, shaders::splat_adam_comp, {.native = nativeAdam()}));
    MACULA_TRY(SplatBuffer first, SplatBuffer::create(device, "first moments", capacity, shDegree));
    MACULA_TRY(SplatBuffer second, SplatBuffer::create(device, "second moments", capacity, shDegree));
    MACULA_TRY(gpu::Buffer steps, zeroes(device, "steps of splats", std::uint64_t(capacity) * 4));
    MACULA_TRY(gpu::Buffer skipped, zeroes(device, "skipped splats", 4));
    MACULA_TRY(gpu::Buffer params, gpu::Buffer::create(device, {.label = "optimizer parameters",
                                                                .bytes = sizeof(shared::SplatAdamParams)}));
    const std::vector<glm::vec2> table = correctionTable(options);
    MACULA_TRY(gpu::TexelBuffer corrections,
               gpu::TexelBuffer::create(device, {.label = "bias corrections",
                                                 .elements = table.size(),
                                                 .format = VK_FORMAT_R32G32_SFLOAT}));
    MACULA_TRY_VOID(gpu::uploadTo<glm::vec2>(corrections.buffer(), table));
    return Optimizer(options, std::move(kernel), std::move(first), std::move(second), std::move(steps),
                     std::move(skipped), std::move(params), std::move(corrections));
}

void Optimizer::record(gpu::Recorder& recorder, SplatBuffer& parameters, const SplatBuffer& gradients,
                       const gpu::Buffer& visible, std::uint32_t count) {
    const std::uint32_t capacity = first_.capacity();
    MACULA_CHECK_EQ(parameters.capacity(), capacity);
    MACULA_CHECK_EQ(gradients.capacity(), capacity);
    MACULA_CHECK_EQ(parameters.shDegree(), first_.shDegree());
    MACULA_CHECK_EQ(gradients.shDegree(), first_.shDegree());
    MACULA_CHECK_LE(count, capacity);
    MACULA_CHECK_LE(std::uint64_t(count) * 4, visible.bytes());
    const std::vector<float> rates = learningRates(options_, first_.shDegree(), stepsDone_++);
    if (count == 0) return;
    shared::SplatAdamParams params{.count = count,
                                   .capacity = capacity,
                                   .components = first_.components(),
                                   .lastCorrection = static_cast<std::uint32_t>(corrections_.elements() - 1),
                                   .beta1 = static_cast<float>(options_.beta1),
                                   .beta2 = static_cast<float>(options_.beta2),
                                   .epsilon = static_cast<float>(options_.epsilon),
                                   .rates = {}};
    std::copy(rates.begin(), rates.end(), std::begin(params.rates));
    const auto label = recorder.label("optimizer");
    recorder.update(params_, std::as_bytes(std::span(&params, 1)));
    recorder.dispatch(kernel_, {count},
                      {params_, corrections_, gradients.values(), visible, parameters.values().buffer(),
                       first_.values().buffer(), second_.values().buffer(), steps_, skipped_});
}

Result<std::uint32_t> Optimizer::skipped() const {
    MACULA_TRY(const std::vector<std::uint32_t> counts, gpu::read<std::uint32_t>(skipped_));
    return counts.front();
}

Result<OptimizerState> Optimizer::download(std::uint32_t count) const {
    MACULA_CHECK_LE(count, first_.capacity());
    OptimizerState state{.stepsDone = stepsDone_, .steps = {}, .first = {}, .second = {}};
    MACULA_TRY(state.steps, gpu::read<std::uint32_t>(steps_));
    state.steps.resize(count);
    MACULA_TRY(state.first, first_.download(count));
    MACULA_TRY(state.second, second_.download(count));
    return state;
}

Result<void> Optimizer::upload(const OptimizerState& state) {
    const std::size_t numbers = state.steps.size() * static_cast<std::size_t>(first_.components());
    if (state.steps.size() > first_.capacity() || state.first.size() != numbers ||
        state.second.size() != numbers) {
        return Error{.code = ErrorCode::inputNotUsable,
                     .message = Text("The state of the training does not fit the model."),
                     .where = {},
                     .hint = Text("It was saved for another model, or is damaged: train anew.")};
    }
    std::vector<std::uint32_t> steps = state.steps;
    steps.resize(first_.capacity(), 0);
    MACULA_TRY_VOID(gpu::uploadTo<std::uint32_t>(steps_, steps));
    MACULA_TRY_VOID(first_.upload(state.first));
    MACULA_TRY_VOID(second_.upload(state.second));
    stepsDone_ = state.stepsDone;
    return {};
}

}  // namespace macula::splat
