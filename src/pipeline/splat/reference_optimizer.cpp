#include "pipeline/splat/reference_optimizer.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "pipeline/splat/splats.h"
#include "shared/splat_layout.h"

namespace macula::splat {

std::vector<float> learningRates(const OptimizerOptions& options, int shDegree, std::uint64_t stepsDone) {
    const std::uint64_t from = std::min(options.decayFrom, options.positionSteps);
    const double done = stepsDone >= options.positionSteps ? 1.0
                        : stepsDone <= from                ? 0.0
                                            : double(stepsDone - from) / double(options.positionSteps - from);
    const double others = std::exp(std::log(options.othersAtLast) * done);
    const double position = options.extentMm * std::exp(std::log(options.position) * (1.0 - done) +
                                                        std::log(options.positionAtLast) * done);
    std::vector<float> rates(std::size_t(shared::kSplatSh) + 3 * shCount(shDegree),
                             float(options.sh * others));
    const auto set = [&](int first, int end, double rate) {
        std::fill(rates.begin() + first, rates.begin() + end, static_cast<float>(rate));
    };
    set(shared::kSplatPosition, shared::kSplatLogScale, position);
    set(shared::kSplatLogScale, shared::kSplatRotation, options.logScale * others);
    set(shared::kSplatRotation, shared::kSplatOpacity, options.rotation * others);
    set(shared::kSplatOpacity, shared::kSplatDc, options.opacityLogit * others);
    set(shared::kSplatDc, shared::kSplatSh, options.dc * others);
    return rates;
}

ReferenceOptimizer::ReferenceOptimizer(std::size_t count, int shDegree, const OptimizerOptions& options)
    : options_(options), shDegree_(shDegree), steps_(count) {
    first_.resize(count * learningRates(options, shDegree, 0).size());
    second_.resize(first_.size());
}

void ReferenceOptimizer::step(std::span<double> parameters, std::span<const double> gradients,
                              std::span<const std::uint32_t> visible) {
    const std::size_t count = steps_.size();
    MACULA_CHECK_EQ(parameters.size(), first_.size());
    MACULA_CHECK_EQ(gradients.size(), first_.size());
    MACULA_CHECK_EQ(visible.size(), count);
    const std::vector<float> rates = learningRates(options_, shDegree_, stepsDone_++);
    for (std::size_t i = 0; i < count; ++i) {
        if (visible[i] == 0) continue;
        bool usable = true;
        for (std::size_t at = i; at < gradients.size(); at += count)
            usable &= std::abs(gradients[at]) < double(1e18f);
        if (!usable) {
            ++skipped_;
            continue;
        }
        ++steps_[i];
        for (std::size_t k = 0; k < rates.size(); ++k) {
            const std::size_t at = k * count + i;
            const double g = gradients[at];
            first_[at] = options_.beta1 * first_[at] + (1.0 - options_.beta1) * g;
            second_[at] = options_.beta2 * second_[at] + (1.0 - options_.beta2) * g * g;
            const double first = first_[at] / (1.0 - std::pow(options_.beta1, steps_[i]));
            const double second = second_[at] / (1.0 - std::pow(options_.beta2, steps_[i]));
            parameters[at] -= double(rates[k]) * first / (std::sqrt(second) + options_.epsilon);
        }
    }
}

}  // namespace macula::splat
