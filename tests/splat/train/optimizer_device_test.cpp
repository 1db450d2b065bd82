// The optimiser on the device against the reference in double, and going on where it stopped.
#include <cmath>
#include <limits>
#include <random>

#include "gpu/shared_device.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/train/optimizer.h"
#include "pipeline/splat/train/reference_optimizer.h"
#include "shared/splat_layout.h"

namespace macula::splat {
namespace {

using Visible = std::vector<std::uint32_t>;

class OptimizerOnDevice : public gpu::SharedDeviceTest {
  protected:
    // A model, its gradients and its optimiser.
    struct Training {
        std::uint32_t count;
        SplatBuffer parameters;
        SplatBuffer gradients;
        gpu::Buffer visible;
        Optimizer optimizer;

        Training(std::uint32_t splats, std::uint32_t capacity, int shDegree, const OptimizerOptions& options)
            : count(splats),
              parameters(std::move(*SplatBuffer::create(device(), "parameters", capacity, shDegree))),
              gradients(std::move(*SplatBuffer::create(device(), "gradients", capacity, shDegree))),
              visible(std::move(*gpu::Buffer::create(device(), {.label = "visible", .bytes = capacity * 4}))),
              optimizer(std::move(*Optimizer::create(device(), capacity, shDegree, options))) {}

        void step(const std::vector<float>& gradient, Visible seen) {
            seen.resize(parameters.capacity(), 1);  // beyond the count nothing may be touched
            ASSERT_TRUE(gradients.upload(gradient).ok());
            ASSERT_TRUE(gpu::uploadTo<std::uint32_t>(visible, seen).ok());
            auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
            optimizer.record(recorder, parameters, gradients, visible, count);
            ASSERT_TRUE(recorder.submit().ok());
        }
        std::vector<float> now() const { return *parameters.download(count); }
    };

    struct Chance {
        std::mt19937 random;
        std::vector<float> gradients(std::size_t numbers) {
            std::normal_distribution<float> normal;
            std::vector<float> result(numbers);
            for (float& g : result) g = normal(random) * std::pow(10.0f, normal(random) - 4.0f);
            return result;
        }
        // Splats of all sizes and turns; needles, and ones beyond what is taken as it is.
        std::vector<float> model(std::size_t count, int degree) {
            std::normal_distribution<float> normal;
            std::vector<float> result(count * std::size_t(componentCount(degree)));
            for (float& number : result) number = normal(random);
            for (std::size_t at = shared::kSplatLogScale * count; at < shared::kSplatRotation * count; ++at)
                result[at] *= 3.0f;
            result[shared::kSplatLogScale * count + 8] = 1000.0f;
            result[shared::kSplatLogScale * count + 9] = -1000.0f;
            for (std::size_t k = 0; k < 4; ++k) result[(shared::kSplatRotation + k) * count + 10] = 0.0f;
            return result;
        }
        Visible visible(std::size_t count) {
            Visible result(count);
            for (std::uint32_t& v : result) v = random() % 3 == 0 ? 0 : 1 + random() % 9;
            return result;
        }
    };
};

TEST_F(OptimizerOnDevice, IsThatOfTheReferenceOverManySparseSteps) {
    constexpr std::uint32_t kCount = 300;
    const OptimizerOptions options{.position = 0.024, .positionSteps = 40};
    for (const int degree : {0, 1}) {
        Training training(kCount, 512, degree, options);
        ReferenceOptimizer reference(kCount, degree, options);
        const std::size_t numbers = kCount * std::size_t(componentCount(degree));
        Chance chance{std::mt19937(7)};
        const std::vector<float> start = chance.model(kCount, degree);
        ASSERT_TRUE(training.parameters.upload(start).ok());
        std::vector<double> expected(start.begin(), start.end());
        std::vector<double> travelled(numbers, 0.0);
        for (int step = 0; step < 50; ++step) {
            std::vector<float> gradients = chance.gradients(numbers);
            Visible visible = chance.visible(kCount);
            visible[5] = step == 30 ? 1 : 0;  // born late
            visible[6] = 0;                   // never seen
            visible[7] = 1;                   // never usable
            gradients[7 + 300 * std::size_t(step % componentCount(degree))] = step % 3 == 0   ? NAN
                                                                              : step % 3 == 1 ? -INFINITY
                                                                                              : 1e18f;
            if (step == 20) gradients[200] = NAN;
            training.step(gradients, visible);
            const std::vector<double> before = expected;
            reference.step(expected, std::vector<double>(gradients.begin(), gradients.end()), visible);
            // Of a position: along all axes, because they turn.
            const auto movedMm = [&](std::size_t splat) {
                double most = 0.0;
                for (std::size_t at = splat; at < 3 * kCount; at += kCount)
                    most = std::max(most, std::abs(expected[at] - before[at]));
                return most;
            };
            for (std::size_t i = 0; i < numbers; ++i)
                travelled[i] += i < 3 * kCount ? movedMm(i % kCount) : std::abs(expected[i] - before[i]);
        }
        const std::vector<float> result = training.now();
        for (std::size_t i = 0; i < numbers; ++i)
            ASSERT_NEAR(result[i], expected[i], 1e-4 * travelled[i] + 2e-6 * std::abs(expected[i]))
                << "component " << i / kCount << " of " << i % kCount;
        for (std::size_t k = 0; k < numbers / kCount; ++k) {
            EXPECT_EQ(result[k * kCount + 6], start[k * kCount + 6]);
            EXPECT_EQ(result[k * kCount + 7], start[k * kCount + 7]);
        }
        EXPECT_EQ(*training.optimizer.skipped(), reference.skipped());
        EXPECT_GE(reference.skipped(), 50u);
        const auto state = training.optimizer.download(kCount);
        EXPECT_EQ(state->steps, reference.steps());
        EXPECT_EQ(state->steps[5], 1u);
        // What lies beyond the count was not touched.
        const auto all = training.parameters.download(512);
        for (std::size_t at = kCount; at < 512; ++at) EXPECT_EQ((*all)[at], 0.0f);
    }
}

TEST_F(OptimizerOnDevice, TheFirstStepIsAsLongAsTheRateWheneverItComes) {
    const OptimizerOptions options{.positionAtLast = 0.05};
    Training training(2, 2, 1, options);
    const std::vector<float> rates = learningRates(options, 1, 0);
    std::vector<float> gradients(46);
    for (std::size_t k = 0; k < 23; ++k) {
        gradients[2 * k] = std::pow(10.0f, float(k) - 9.0f);
        gradients[2 * k + 1] = -gradients[2 * k];
    }
    for (int step = 0; step < 2000; ++step) {
        if (step == 0 || step == 1999) {
            training.step(gradients, {step == 0 ? 1u : 0u, step == 0 ? 0u : 1u});
            continue;
        }
        if (step % 100 == 0) training.step(gradients, {0, 0});
    }
    const std::vector<float> result = training.now();
    for (std::size_t k = 0; k < 23; ++k) {
        EXPECT_NEAR(result[2 * k], -rates[k], 1e-5 * double(rates[k])) << k;
        EXPECT_NEAR(result[2 * k + 1], rates[k], 1e-5 * double(rates[k])) << k;
    }
}

TEST_F(OptimizerOnDevice, TakesWhateverAGradientMayBe) {
    const OptimizerOptions options{};
    const std::vector<float> values{0.0f, -0.0f, 1e-45f, 1e-30f, -1e-20f, 1e-10f, 1.0f, 1e6f, -9e17f};
    Training training(std::uint32_t(values.size()), 16, 0, options);
    std::vector<float> gradients;
    for (int k = 0; k < 14; ++k) gradients.insert(gradients.end(), values.begin(), values.end());
    for (int step = 0; step < 10; ++step) {
        training.step(gradients, Visible(values.size(), 1));
        for (float& g : gradients) g = -g;
    }
    for (const float value : training.now()) {
        ASSERT_TRUE(std::isfinite(value));
        ASSERT_LE(std::abs(value), 10 * 0.05f);
    }
    EXPECT_EQ(*training.optimizer.skipped(), 0u);
    const auto state = training.optimizer.download(training.count);
    for (std::size_t i = 0; i < state->first.size(); ++i)
        ASSERT_TRUE(std::isfinite(state->first[i]) && std::isfinite(state->second[i]));
    EXPECT_EQ(training.now()[0], 0.0f);
}

TEST_F(OptimizerOnDevice, GoesOnBitForBitWhereItWasSaved) {
    constexpr std::uint32_t kCount = 130;
    const OptimizerOptions options{.position = 0.024, .positionSteps = 25};
    const std::size_t numbers = kCount * 23;
    const auto run = [&](Training& training, Chance& chance, int steps) {
        for (int i = 0; i < steps; ++i) {
            const std::vector<float> gradients = chance.gradients(numbers);
            training.step(gradients, chance.visible(kCount));
        }
    };
    Training whole(kCount, 256, 1, options);
    Chance chance{std::mt19937(3)};
    run(whole, chance, 30);

    Training first(kCount, 256, 1, options);
    Chance again{std::mt19937(3)};
    run(first, again, 12);
    const auto parameters = first.now();
    const auto state = *first.optimizer.download(kCount);
    EXPECT_EQ(state.stepsDone, 12u);
    Training second(kCount, 700, 1, options);  // a pool of another size
    ASSERT_TRUE(second.parameters.upload(parameters).ok());
    ASSERT_TRUE(second.optimizer.upload(state).ok());
    EXPECT_EQ(second.optimizer.download(kCount)->first, state.first);
    run(second, again, 18);

    EXPECT_EQ(second.now(), whole.now());
    const auto a = *whole.optimizer.download(kCount);
    const auto b = *second.optimizer.download(kCount);
    EXPECT_EQ(a.stepsDone, b.stepsDone);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.first, b.first);
    EXPECT_EQ(a.second, b.second);
}

TEST_F(OptimizerOnDevice, RefusesWhatMakesNoSense) {
    for (const OptimizerOptions& bad :
         {OptimizerOptions{.position = 0}, OptimizerOptions{.positionAtLast = NAN},
          OptimizerOptions{.dc = -1}, OptimizerOptions{.beta2 = 1.0}, OptimizerOptions{.beta1 = -0.1},
          OptimizerOptions{.epsilon = 0}}) {
        const auto result = Optimizer::create(device(), 8, 0, bad);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, ErrorCode::usage);
    }
    Optimizer optimizer = std::move(*Optimizer::create(device(), 8, 0, {}));
    OptimizerState state = *optimizer.download(8);
    state.steps.resize(9);
    EXPECT_FALSE(optimizer.upload(state).ok());
    state.steps.resize(8);
    state.second.pop_back();
    EXPECT_FALSE(optimizer.upload(state).ok());
}

}  // namespace
}  // namespace macula::splat
