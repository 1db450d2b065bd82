// Every estimator of the device, in float, against two truths in double: the reference tracer with other
// random numbers, and code that was written anew (dense_light.h; what it shares is said in dense_scene.h). Of
// the device and of the reference each number is a mean over 64 seeds; of the other code over 64 batches of
// paths, or 16 of evenly spread ones for light scattered once. As a small bias hides in the noise of any one
// number, what they say together is judged as well: docs/numerical-limits.md says how small a bias is seen.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "pipeline/trace/reference_tracer.h"
#include "shader/statistics.h"
#include "trace/dense_light.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

constexpr int kSeeds = 64;
constexpr int kEvenBatches = 16;
constexpr int kPixels = scenes::kSmallPixels;
constexpr int kParts = 4;                          // quarters of the picture
using Means = std::array<glm::dvec4, kParts + 1>;  // and the whole

// Means of quarters, from batches that know nothing of each other.
class Tally {
  public:
    void add(Means batch) {
        batch[kParts] = 0.25 * (batch[0] + batch[1] + batch[2] + batch[3]);
        for (int part = 0; part <= kParts; ++part) {
            sums_[std::size_t(part)] += batch[std::size_t(part)];
            squares_[std::size_t(part)] += batch[std::size_t(part)] * batch[std::size_t(part)];
        }
        ++batches_;
    }
    double mean(int part, int channel) const { return sums_[std::size_t(part)][channel] / batches_; }
    double variance(int part, int channel) const {  // of the mean
        const double m = mean(part, channel);
        return std::max(squares_[std::size_t(part)][channel] / batches_ - m * m, 0.0) / (batches_ - 1);
    }

  private:
    Means sums_{};
    Means squares_{};
    int batches_ = 0;
};

int partOf(double x, double y) {  // of the picture, 0 to 1
    return (y < 0.5 ? 0 : 2) + (x < 0.5 ? 0 : 1);
}

template <class Pixels>
Means meansOf(const Pixels& pixels, double samples) {
    Means means{};
    for (int y = 0; y < kPixels; ++y) {
        for (int x = 0; x < kPixels; ++x) {
            means[std::size_t(partOf((x + 0.5) / kPixels, (y + 0.5) / kPixels))] +=
                glm::dvec4(pixels[std::size_t(y * kPixels + x)]) / (samples * kPixels * kPixels / kParts);
        }
    }
    return means;
}

// Numbers that fill the unit cube evenly (Kronecker's sequence), each batch shifted by chance.
class Even {
  public:
    Even(std::size_t batch, int index) : batch_(batch), index_(index) {}
    double operator()(int dimension, double irrational, int index) const {
        std::uint64_t h = (batch_ * 64 + std::uint64_t(dimension) + 1) * 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        const double shift = double((h ^ (h >> 31)) >> 11) * 0x1p-53;
        return std::fmod(shift + irrational * index, 1.0);
    }
    double x() const { return (*this)(0, 0.7548776662466927, index_); }
    double y() const { return (*this)(1, 0.5698402909980532, index_); }
    double operator()(int vertex, scenes::DenseLight::Choice choice) const {
        static const double kRoots[] = {std::sqrt(2.0), std::sqrt(3.0),  std::sqrt(5.0),
                                        std::sqrt(7.0), std::sqrt(11.0), std::sqrt(13.0)};
        return (*this)(2 + choice, kRoots[choice], scenes::DenseLight::kVertices * index_ + vertex);
    }

  private:
    std::size_t batch_;
    int index_;
};

// sample(x, y, even, engine) at `points` points of each part, in each batch.
template <class Sample>
Tally overPicture(int batches, int points, const Sample& sample) {
    std::vector<Means> means(std::size_t(batches), Means{});
    parallelFor(means.size(), [&](std::size_t batch) {
        std::mt19937_64 engine(1000 + batch);
        for (int part = 0; part < kParts; ++part) {
            for (int n = 0; n < points; ++n) {
                const Even even(batch, part * points + n);
                means[batch][std::size_t(part)] +=
                    sample(0.5 * (even.x() + part % 2), 0.5 * (even.y() + part / 2), even, engine) /
                    double(points);
            }
        }
    });
    Tally tally;
    for (const Means& batch : means) tally.add(batch);
    return tally;
}

// What the differences of all scenes and parts say together: by their squares, and by their sign.
class Verdict {
  public:
    void add(double difference, double variance, double truth) {
        squares_ += difference * difference / variance;
        ++count_;
        weighted_ += difference * truth / variance;
        weights_ += truth * truth / variance;
    }
    // A right estimator fails the first in 2e-5 of all cases, the second in 1.1e-5, as most of the noise is
    // that of 64 seeds of the device; were all of it that of 16 batches, the first in 8e-4.
    void judge(const std::string& what) const {
        ASSERT_GE(count_, 24);
        // The mean square of Student's t with 15 degrees of freedom is 15/13.
        EXPECT_LT(squares_ / count_, 15.0 / 13.0 + 6.0 * std::sqrt(2.0 / count_)) << what;
        const double bias = weighted_ / weights_;  // relative
        const double error = 1.0 / std::sqrt(weights_);
        EXPECT_LT(std::abs(bias), statistics::kDeviateLimit * error) << what;
        EXPECT_LT(error, 0.003) << what << ": too noisy to see a bias";
        ::testing::Test::RecordProperty(what + "BiasMillionths", int(std::lround(1e6 * bias)));
        ::testing::Test::RecordProperty(what + "ErrorMillionths", int(std::lround(1e6 * error)));
        ::testing::Test::RecordProperty(what + "SquaresPercent", int(100.0 * squares_ / count_));
    }

  private:
    double squares_ = 0.0;
    int count_ = 0;
    double weighted_ = 0.0;
    double weights_ = 0.0;
};
struct Verdicts {
    Verdict light;
    Verdict coverage;
};

void compare(const Tally& device, const Tally& truth, Verdicts& verdicts) {
    for (int part = 0; part <= kParts; ++part) {
        for (int channel = 0; channel < 4; ++channel) {
            const double expected = truth.mean(part, channel);
            const double difference = device.mean(part, channel) - expected;
            const double variance = device.variance(part, channel) + truth.variance(part, channel);
            // Of two means with their errors the ratio is Student's t (Welch). Where the truth has 16 batches
            // its degrees of freedom are 15 or more, and one is above 6.5 with a probability of 1e-5 at most;
            // of 440 such numbers, 5e-3. Elsewhere they are 63 or more: 1.5e-8, and of 1320 numbers, 2e-5.
            EXPECT_LT(std::abs(difference), 6.5 * std::sqrt(variance) + 1e-6)
                << "part " << part << " channel " << channel << ": " << expected + difference << " for "
                << expected;
            // The three colours of a part are nearly one number.
            if (variance < 1e-14 || part == kParts || (channel != 1 && channel != 3)) continue;
            (channel == 1 ? verdicts.light : verdicts.coverage).add(difference, variance, expected);
        }
    }
}

class Unbiased : public DeviceTest, public ::testing::WithParamInterface<std::tuple<Look, Filter>> {
  protected:
    Look look() const { return std::get<0>(GetParam()); }
    Filter filter() const { return std::get<1>(GetParam()); }
    // Each estimator and scene has seeds of its own: what they say is independent.
    std::uint32_t firstSeed(int scene) const {
        return 100'000u * (1 + 2 * std::uint32_t(look() == Look::clear) +
                           std::uint32_t(filter() == Filter::trilinear)) +
               1000u * std::uint32_t(scene);
    }

    Tally onDevice(PathTracer& t, const scenes::SmallScene& scene, std::uint32_t firstSeed,
                   std::uint32_t samples) const {
        EXPECT_TRUE(t.scene().setVolume(scene.volume).ok());
        EXPECT_TRUE(t.scene().setTransferFunction(scene.function).ok());
        EXPECT_TRUE(t.scene().setEnvironment(scene.environment()).ok());
        EXPECT_TRUE(t.scene().setClip(scene.clip).ok());
        EXPECT_TRUE(t.setView(scene.view).ok());
        Tally tally;
        for (std::uint32_t seed = firstSeed; seed < firstSeed + kSeeds; ++seed) {
            EXPECT_TRUE(t.setSettings(scene.settings(look(), filter(), seed)).ok());
            EXPECT_TRUE(*t.trace(samples));
            tally.add(meansOf(t.readback()->radiance, 1.0));
            EXPECT_EQ(t.statistics()->abandonedSamples + t.statistics()->nonFiniteSamples, 0u);
            EXPECT_EQ(t.statistics()->collisionsAboveBound, 0u);
        }
        return tally;
    }
    Tally ofReference(const scenes::SmallScene& scene, std::uint32_t firstSeed, std::uint32_t samples) const {
        std::optional<MaskBits> bits;
        if (scene.clip.mask) bits = maskBits(*scene.clip.mask, *scene.volume);
        const MaskBits* mask = bits ? &*bits : nullptr;
        const Environment environment = scene.environment();
        const Medium medium =
            makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function, scene.clip, mask);
        const ReferenceTracer reference(*scene.volume, medium, environment, mask);
        Tally tally;
        for (std::uint32_t seed = firstSeed; seed < firstSeed + kSeeds; ++seed) {
            const auto params = makeTraceParams(*scene.volume, medium, environment, scene.view,
                                                scene.settings(look(), filter(), seed), scene.clip);
            tally.add(meansOf(reference.trace(*params, filter(), Precision::twofold, 0, samples), samples));
        }
        return tally;
    }
    Tally ofOtherCode(const scenes::SmallScene& scene) const {
        // docs/presets.md: light that is scattered once is three times as strong, less where surfaces
        // scatter.
        const double gain = 3.0 * 0.15 / (0.15 + 0.24 * scene.function.surface.weight);
        const scenes::DenseLight dense(scene, filter(), look() == Look::clear ? gain : 1.0);
        if (look() == Look::clear) {
            return overPicture(kEvenBatches, 256,
                               [&](double x, double y, const Even& even, std::mt19937_64&) {
                                   return dense.scatteredOnce(x, y, 0.25, even);
                               });
        }
        return overPicture(kSeeds, 384, [&](double x, double y, const Even&, std::mt19937_64& engine) {
            return dense.walked(x, y, scene.bounces, engine);
        });
    }
};

TEST_P(Unbiased, InSmallScenesByTwoTruths) {
    auto made = PathTracer::create(device());
    PathTracer t = std::move(made).value();
    const std::vector<scenes::SmallScene> scenes = scenes::smallScenes();
    ASSERT_EQ(scenes.size(), 11u);
    Verdicts byReference;
    Verdicts byOtherCode;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        SCOPED_TRACE(scenes[i].name);
        const std::uint32_t seed = firstSeed(int(i));
        const Tally device = onDevice(t, scenes[i], seed, 12);
        {
            SCOPED_TRACE("against the reference");
            compare(device, ofReference(scenes[i], seed + 500, 8), byReference);
        }
        SCOPED_TRACE("against other code");
        compare(device, ofOtherCode(scenes[i]), byOtherCode);
    }
    byReference.light.judge("referenceLight");
    byReference.coverage.judge("referenceCoverage");
    byOtherCode.light.judge("otherLight");
    byOtherCode.coverage.judge("otherCoverage");
}

INSTANTIATE_TEST_SUITE_P(All, Unbiased,
                         ::testing::Combine(::testing::Values(Look::clear, Look::cinematic),
                                            ::testing::Values(Filter::trilinear, Filter::stochastic)),
                         [](const auto& p) {
                             return std::string(std::get<0>(p.param) == Look::clear ? "Once" : "Often") +
                                    (std::get<1>(p.param) == Filter::trilinear ? "Trilinear" : "Stochastic");
                         });

}  // namespace
}  // namespace macula::trace
