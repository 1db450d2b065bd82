// The native kernel that gathers derivatives is the same maths in double, whatever the splat.
#include "pipeline/splat/native/native_gather.h"

#include <algorithm>
#include <cmath>

#include "splat/native/native_models.h"
#include "splat/native/native_pictures.h"

namespace macula::splat {
namespace {

constexpr float kUntouched = 7.0f;
constexpr std::size_t kValues = shared::kPairValues;

#define OUT(type) type&
#define INOUT(type) type&
struct GatherHost : reference::HostTwofold {
    using HostTwofold::HostTwofold;
#define float double
#include "splat/splat_outcome.glsl"
#undef float
};
#undef OUT
#undef INOUT

// The derivatives by the parameters of one splat; empty for a splat that does not show.
struct Gathered {
    std::vector<double> values;
    double weight = 0.0;
    double pull = 0.0;
};

// Pairs of splats and tiles whose sums are what a few pixels of a splat give, and what is to be gathered of
// them.
struct GatherScene {
    GatherScene(const Splats& splats, const RasterView& view_, const Blending& blending_, int slots_)
        : model(splats), view(view_), blending(blending_), slots(slots_) {
        GatherHost host(view, blending);
        const auto count = splats.size();
        screen.resize(count * shared::kScreenTexels);
        ranges.resize(count);
        expected.resize(count);
        // Pairs lie in another order than splats.
        for (std::size_t n = 0; n < count; ++n) add(host, splats, count - 1 - n);
        if (pairs.empty()) pairs.resize(kValues);
    }

    void add(GatherHost& host, const Splats& splats, std::size_t i) {
        const GatherHost::Splat splat{splats.position[i], splats.logScale[i], splats.rotation[i],
                                      double(splats.opacityLogit[i])};
        const GatherHost::ScreenSplat s = host.projectSplat(splat, host.frame);
        glm::vec4* texels = &screen[i * shared::kScreenTexels];
        texels[0] = glm::vec4(s.mean, s.conic.x, s.conic.y);
        texels[1] = glm::vec4(s.conic.z, s.opacity, s.depthMm, s.extent.x);
        texels[2] = glm::vec4(0, 0, 0, s.extent.y);
        const auto first = static_cast<std::uint32_t>(pairs.size() / kValues / std::size_t(slots));
        const auto parts = static_cast<std::uint32_t>(s.opacity > 0.0 ? i % 5 : 0);
        ranges[i] = {first, parts};
        if (parts == 0) return;
        const GatherHost::ScreenGradient by = host.outcomeOf(splat, host.frame).byScreen;
        const double weight = i % 9 == 1 ? 0.0 : 0.1 + double(i % 3);
        const std::array<double, kValues> whole{by.mean.x,   by.mean.y,  by.conic.x,     by.conic.y,
                                                by.conic.z,  by.opacity, by.colour.x,    by.colour.y,
                                                by.colour.z, weight,     0.7 * double(i)};
        const double share = 2.5 * double(parts) * slots;
        std::array<double, kValues> sums{};
        for (std::size_t n = 0; n < std::size_t(parts) * std::size_t(slots); ++n) {
            for (std::size_t k = 0; k < kValues; ++k) {
                pairs.push_back(float(whole[k] * (1.0 + double((n + k) % 4)) / share));
                sums[k] += double(pairs.back());
            }
        }
        if (sums[9] > 0.0) expected[i] = gathered(host, splats, i, splat, s, sums);
    }

    static Gathered gathered(GatherHost& host, const Splats& splats, std::size_t i,
                             const GatherHost::Splat& splat, const GatherHost::ScreenSplat& s,
                             const std::array<double, kValues>& sums) {
        GatherHost::ScreenGradient g = host.noGradient();
        g.mean = {sums[0], sums[1]};
        g.conic = {sums[2], sums[3], sums[4]};
        g.opacity = sums[5];
        g.colour = {sums[6], sums[7], sums[8]};
        GatherHost::SplatGradient by = host.projectionGradient(splat, host.frame, s, g);
        const glm::dvec3 direction = host.directionTo(splat.position, host.frame);
        glm::dvec3 colour = host.colourOfBand0(splats.dc[i]);
        const glm::vec3* sh = splats.shDegree == 1 ? &splats.sh[3 * i] : nullptr;
        if (sh != nullptr) colour += host.colourOfBand1(direction, sh[0], sh[1], sh[2]);
        const glm::dvec3 bySum = host.sumGradient(colour, g.colour);
        if (sh != nullptr)
            by.position +=
                host.colourPositionGradient(splat.position, host.frame, sh[0], sh[1], sh[2], bySum);
        Gathered result{.values = {}, .weight = sums[9], .pull = sums[10]};
        const auto take = [&](const auto& v) {
            for (int k = 0; k < v.length(); ++k) result.values.push_back(v[k]);
        };
        take(by.position);
        take(by.logScale);
        take(by.rotation);
        result.values.push_back(by.opacityLogit);
        take(bySum * host.band0Slope());
        if (sh == nullptr) return result;
        const GatherHost::Band1Gradient bySh = host.band1Gradient(direction, bySum);
        take(bySh.s1);
        take(bySh.s2);
        take(bySh.s3);
        return result;
    }

    void gather() {
        std::vector<shared::SplatFrame> frame{model.frameOf(view, blending)};
        gradients.assign(model.parameters.size(), kUntouched);
        visible.assign(model.capacity, 9);
        statistics.assign(model.capacity, {1.0f, 2.0f, 3.0f, 4.0f});
        gpu::NativeDispatch dispatch({static_cast<std::uint32_t>(model.count + 63) / 64, 1, 1}, {});
        bindTo(dispatch, 0, frame);
        bindTo(dispatch, 1, screen);
        bindTo(dispatch, 2, model.parameters);
        bindTo(dispatch, 3, ranges);
        bindTo(dispatch, 4, pairs);
        bindTo(dispatch, 5, gradients);
        bindTo(dispatch, 6, visible);
        bindTo(dispatch, 7, statistics);
        nativeGather(model.degree, slots)(dispatch);
    }

    NativeModel model;
    RasterView view;
    Blending blending;
    int slots;
    std::vector<glm::vec4> screen;
    std::vector<glm::uvec2> ranges;
    std::vector<float> pairs;
    std::vector<Gathered> expected;

    std::vector<float> gradients;
    std::vector<std::uint32_t> visible;
    std::vector<shared::SplatStatistics> statistics;
};

void expectStatistics(const shared::SplatStatistics& found, const Gathered& expected, bool shows) {
    EXPECT_FLOAT_EQ(found.views, shows ? 2.0f : 1.0f);
    EXPECT_NEAR(found.weight, 2.0 + expected.weight, 1e-5 * (2.0 + expected.weight));
    EXPECT_NEAR(found.pull, 3.0 + expected.pull, 1e-5 * (3.0 + expected.pull));
    EXPECT_NEAR(found.mostWeight, std::max(4.0, expected.weight), 1e-5 * std::max(4.0, expected.weight));
}

// Of a splat that shows, with the tolerances of splat_maths_device_test.cpp.
void expectGradients(const GatherScene& scene, std::size_t i) {
    const auto vector = [&](std::size_t first, std::size_t count, double least) {
        double square = 0.0;
        double length = 0.0;
        for (std::size_t k = first; k < first + count; ++k) {
            const double exact = scene.expected[i].values[k];
            const double off = double(scene.gradients[k * scene.model.capacity + i]) - exact;
            square += off * off;
            length += exact * exact;
        }
        return std::sqrt(square) / std::max(std::sqrt(length), least);
    };
    const std::vector<double>& exact = scene.expected[i].values;
    EXPECT_LT(vector(shared::kSplatPosition, 3, 1e-6), 1e-3);
    EXPECT_LT(vector(shared::kSplatLogScale, 3, 1e-6), 1e-3);
    const double byScale = glm::length(glm::dvec3(exact[3], exact[4], exact[5]));
    EXPECT_LT(vector(shared::kSplatRotation, 4, std::max(1e-5, 1e-3 * byScale)), 5e-3);
    EXPECT_LT(vector(shared::kSplatOpacity, 1, 1e-6), 1e-3);
    EXPECT_LT(vector(shared::kSplatDc, 3, 1e-6), 1e-4);
    if (scene.model.degree == 1) {
        EXPECT_LT(vector(shared::kSplatSh, 9, 1e-6), 1e-4);
    }
}

// Returns how many show.
std::size_t expectLikeReference(GatherScene& scene) {
    std::size_t shown = 0;
    onEachInstructionSet([&] {
        scene.gather();
        shown = 0;
        for (std::size_t i = 0; i < scene.model.capacity; ++i) {
            SCOPED_TRACE(i);
            const bool isSplat = i < scene.model.count;
            const bool shows = isSplat && !scene.expected[i].values.empty();
            EXPECT_EQ(scene.visible[i], shows ? 1u : isSplat ? 0u : 9u);
            expectStatistics(scene.statistics[i], isSplat ? scene.expected[i] : Gathered{}, shows);
            if (shows) {
                ++shown;
                expectGradients(scene, i);
                continue;
            }
            for (std::size_t at = i; at < scene.gradients.size(); at += scene.model.capacity)
                ASSERT_EQ(scene.gradients[at], kUntouched);
        }
    });
    return shown;
}

TEST(NativeGather, DerivativesAreThoseOfTheReferenceForSplatsOfAllKinds) {
    std::vector<SingleSplat> kinds = splatsOfAllKinds();
    const std::vector<SingleSplat> bad = splatsNotFinite();
    kinds.insert(kinds.begin() + 20, bad.begin(), bad.end());  // beside others in a vector
    for (const bool isParallel : {false, true}) {
        for (const LowPass lowPass : kLowPasses) {
            for (const int degree : {0, 1}) {
                GatherScene scene(modelOf(kinds, degree), isParallel ? someParallelView() : someView(),
                                  blendingOf(lowPass), 1 + degree);
                EXPECT_GT(expectLikeReference(scene), 180u);
            }
        }
    }
}

TEST(NativeGather, TakesAnyNumberOfSplatsAndSlots) {
    for (const std::size_t count : {0, 1, 2, 15, 16, 17, 1030}) {
        for (const int slots : {1, 3}) {
            GatherScene scene(singleOf(randomModel(3, count, 1)), frontView({61, 47}), {}, slots);
            const std::size_t shown = expectLikeReference(scene);
            if (count > 2) {
                EXPECT_GT(shown, count / 3);
            }
        }
    }
}

TEST(NativeGather, WhatIsNotFiniteStaysWithItsSplat) {
    GatherScene scene(singleOf(randomModel(3, 40, 1)), frontView({61, 47}), {}, 1);
    scene.gather();
    const std::vector<float> good = scene.gradients;
    const std::size_t splat = 18;
    ASSERT_GT(scene.ranges[splat].y, 0u);
    scene.pairs[scene.ranges[splat].x * kValues + 2] = std::numeric_limits<float>::quiet_NaN();
    onEachInstructionSet([&] {
        scene.gather();
        for (std::size_t at = 0; at < good.size(); ++at) {
            if (at % scene.model.capacity == splat) continue;
            ASSERT_NEAR(scene.gradients[at], good[at], 1e-3 * std::abs(good[at]) + 1e-3);
        }
        EXPECT_TRUE(std::isnan(scene.gradients[shared::kSplatLogScale * scene.model.capacity + splat]));
    });
}

}  // namespace
}  // namespace macula::splat
