#include "pipeline/splat/train/reference_optimizer.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "base/check.h"
#include "pipeline/splat/model/splats.h"
#include "shared/splat_layout.h"

namespace macula::splat {

std::vector<float> learningRates(const OptimizerOptions& options, int shDegree, std::uint64_t stepsDone) {
    const std::uint64_t from = std::min(options.decayFrom, options.positionSteps);
    const double done = stepsDone >= options.positionSteps ? 1.0
                        : stepsDone <= from                ? 0.0
                                            : double(stepsDone - from) / double(options.positionSteps - from);
    const double others = std::exp(std::log(options.othersAtLast) * done);
    const double position =
        std::exp(std::log(options.position) * (1.0 - done) + std::log(options.positionAtLast) * done);
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
        const auto valuesAt = [&](auto values, int component) {
            const std::size_t at = std::size_t(component) * count + i;
            return glm::dvec3(values[at], values[at + count], values[at + 2 * count]);
        };
        const glm::dmat3 worldFromAxes = rotationOf(parameters, i);
        const glm::dvec3 deviationsMm = glm::exp(glm::clamp(valuesAt(parameters, shared::kSplatLogScale),
                                                            -double(kMaxLogScale), double(kMaxLogScale)));
        const glm::dvec3 gradient =
            glm::transpose(worldFromAxes) * valuesAt(gradients, shared::kSplatPosition);
        glm::dvec3 along;
        for (int axis = 0; axis < 3; ++axis)
            along[axis] = double(rates[std::size_t(axis)]) * deviationsMm[axis] *
                          learn(std::size_t(axis), i, gradient[axis]);
        const glm::dvec3 moved = worldFromAxes * along;
        for (int axis = 0; axis < 3; ++axis) parameters[std::size_t(axis) * count + i] += moved[axis];
        for (std::size_t k = shared::kSplatLogScale; k < rates.size(); ++k)
            parameters[k * count + i] += double(rates[k]) * learn(k, i, gradients[k * count + i]);
    }
}

double ReferenceOptimizer::learn(std::size_t component, std::size_t splat, double gradient) {
    const std::size_t at = component * steps_.size() + splat;
    first_[at] = options_.beta1 * first_[at] + (1.0 - options_.beta1) * gradient;
    second_[at] = options_.beta2 * second_[at] + (1.0 - options_.beta2) * gradient * gradient;
    const double first = first_[at] / (1.0 - std::pow(options_.beta1, steps_[splat]));
    const double second = second_[at] / (1.0 - std::pow(options_.beta2, steps_[splat]));
    return -first / (std::sqrt(second) + options_.epsilon);
}

glm::dmat3 ReferenceOptimizer::rotationOf(std::span<const double> parameters, std::size_t splat) const {
    const auto part = [&](int k) {
        return parameters[std::size_t(shared::kSplatRotation + k) * steps_.size() + splat];
    };
    const glm::dquat turn(part(0), part(1), part(2), part(3));
    return glm::length(turn) > 1e-12 ? glm::mat3_cast(glm::normalize(turn)) : glm::dmat3(1.0);
}

}  // namespace macula::splat
