#include "pipeline/hybrid/views/pose_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace macula::hybrid {

namespace {

// The finaliser of SplitMix64 (Steele et al. 2014): each output bit depends on all input bits.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// Flips each bit or not, by a hash of all bits above it.
std::uint32_t scrambled(std::uint32_t bits, std::uint64_t seed) {
    std::uint32_t flips = 0;
    for (unsigned place = 0; place < 32; ++place) {
        // The bits above this one, with a leading 1 that marks how many they are.
        const std::uint64_t above = (std::uint64_t{1} << place) | (place == 0 ? 0u : bits >> (32u - place));
        flips |= static_cast<std::uint32_t>(mixed(seed ^ mixed(above)) & 1u) << (31u - place);
    }
    return bits ^ flips;
}

}  // namespace

glm::dvec2 scrambledSobol(std::uint32_t index, std::uint64_t seed) {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    // Direction numbers: single bits in the first dimension; in the second, whose primitive polynomial is
    // x + 1, each is the previous one, xored with itself shifted by one.
    std::uint32_t directionX = 1u << 31;
    std::uint32_t directionY = 1u << 31;
    for (std::uint32_t rest = index; rest != 0; rest >>= 1) {
        if ((rest & 1u) != 0) {
            x ^= directionX;
            y ^= directionY;
        }
        directionX >>= 1;
        directionY ^= directionY >> 1;
    }
    constexpr double kUnit = 1.0 / 4294967296.0;
    return {kUnit * scrambled(x, mixed(2 * seed)), kUnit * scrambled(y, mixed(2 * seed + 1))};
}

namespace {

constexpr double kPi = std::numbers::pi;

// mt19937_64 gives the same numbers everywhere; the distributions of the standard library do not.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : engine_(seed) {}

    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // [0, 1)

    // Uniform in the unit ball: a direction, and the cube root of a uniform number as the distance.
    glm::dvec3 inBall() {
        const double z = 1.0 - 2.0 * uniform();
        const double angle = 2.0 * kPi * uniform();
        const double distance = std::cbrt(uniform());
        const double ring = std::sqrt(std::max(1.0 - z * z, 0.0));
        return distance * glm::dvec3(ring * std::cos(angle), ring * std::sin(angle), z);
    }

  private:
    std::mt19937_64 engine_;
};

glm::dvec3 onSphere(const glm::dvec2& point) {
    const double z = 1.0 - 2.0 * point.x;
    const double ring = std::sqrt(std::max(1.0 - z * z, 0.0));
    return {ring * std::cos(2.0 * kPi * point.y), ring * std::sin(2.0 * kPi * point.y), z};
}

Result<void> check(const Box& seen, const PoseSampling& sampling) {
    const auto bad = [](Text message, Text hint) {
        return Error{ErrorCode::usage, std::move(message), {}, std::move(hint)};
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (!(seen.low[axis] <= seen.high[axis]) || !std::isfinite(seen.low[axis]) ||
            !std::isfinite(seen.high[axis]))
            return bad(Text("There is nothing to be seen."),
                       Text("Choose a preset that shows something of the series."));
    }
    if (!(seen.diagonal() > 0.0))
        return bad(Text("There is nothing to be seen."),
                   Text("Choose a preset that shows something of the series."));
    const auto finiteFrom0 = [](double value) { return value >= 0.0 && std::isfinite(value); };
    if (!(sampling.startDistance > 0.0) || !std::isfinite(sampling.startDistance) ||
        !finiteFrom0(sampling.increment) || !finiteFrom0(sampling.mostVariability) ||
        !(sampling.verticalFovDeg >= 0.1 && sampling.verticalFovDeg <= 170.0) || sampling.mostTries < 1 ||
        sampling.count > (1u << 20))
        return bad(
            Text("The views cannot be chosen this way."),
            Text(
                "Give a start distance above 0, an increment and a variability of 0 or above, and a field of "
                "view of 0.1 to 170 degrees."));
    return {};
}

}  // namespace

glm::dvec3 upFor(const glm::dvec3& forward) {
    const glm::dvec3 superior{0, 0, 1};
    constexpr double kNearlyParallel = 1e-3;
    const bool usable = glm::length(glm::cross(forward, superior)) > kNearlyParallel;
    return usable ? superior : glm::dvec3{0, -1, 0};
}

PoseSampling initialTraining(std::size_t count, std::uint64_t trial) {
    constexpr std::uint64_t kFirst = 42;
    // Skips the seed of groundTruth: a model must not learn from the poses by which it is judged.
    const std::uint64_t past = trial >= groundTruth(1).seed - kFirst ? 1 : 0;
    return {.count = count, .seed = kFirst + trial + past};
}

PoseSampling otherSides(std::size_t count, std::uint64_t trial) {
    constexpr std::uint64_t kNoTrialHas = std::uint64_t(1) << 40;
    return {.count = count, .seed = kNoTrialHas + trial};
}

PoseSampling groundTruth(std::size_t count) {
    return {.count = count, .startDistance = 3.0, .increment = 0.05, .mostVariability = 1.0, .seed = 777};
}

PoseSampling wholeFrames(std::size_t count) {
    return {.count = count,
            .startDistance = 1.7,
            .increment = 0.04,
            .mostVariability = 1.0,
            .seed = 777,
            .verticalFovDeg = 70.0};
}

PoseSampling extension(std::size_t count) {
    return {.count = count, .startDistance = 4.0, .increment = 0.02, .mostVariability = 2.7, .seed = 10};
}

Result<std::vector<SampledPose>> samplePoses(const Box& seenMm, const PoseSampling& sampling,
                                             const PoseAcceptance& accept) {
    MACULA_TRY_VOID(check(seenMm, sampling));
    const glm::dvec3 centre = seenMm.centre();
    const double radius = 0.5 * seenMm.diagonal();
    Chance chance(sampling.seed);
    std::uint32_t point = 0;
    std::vector<SampledPose> views;
    for (std::size_t view = 0; view < sampling.count; ++view) {
        const double variability =
            std::min(static_cast<double>(view) * sampling.increment, sampling.mostVariability);
        SampledPose sampled;
        for (sampled.tries = 1;; ++sampled.tries) {
            const glm::dvec3 direction = onSphere(scrambledSobol(point++, sampling.seed));
            const glm::dvec3 target = centre + 0.8 * radius * variability * chance.inBall();
            const glm::dvec3 eye = centre + (sampling.startDistance - variability) * radius * direction +
                                   0.4 * radius * variability * chance.inBall();
            const double distance = glm::distance(eye, target);
            sampled.camera = {.positionMm = eye,
                              .targetMm = target,
                              .up = upFor((target - eye) / std::max(distance, 1e-300)),
                              .verticalFovDeg = sampling.verticalFovDeg};
            sampled.accepted = distance > 1e-6 * radius && basis(sampled.camera).ok();
            if (sampled.accepted && accept) {
                MACULA_TRY(sampled.accepted, accept(sampled.camera));
            }
            if (sampled.accepted || sampled.tries >= sampling.mostTries) break;
        }
        views.push_back(sampled);
    }
    return views;
}

}  // namespace macula::hybrid
