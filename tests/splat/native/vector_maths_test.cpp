// exp and log of base/vector_in_glsl.h on each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splat/native/vector_maths_test.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include "base/vector_in_glsl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

using namespace macula::HWY_NAMESPACE;

// Of `count` numbers, a multiple of 16.
void expOf(const float* x, float* y, std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) GlslInVectors::exp(Float::load(x + i)).store(y + i);
}
void logOf(const float* x, float* y, std::size_t count) {
    for (std::size_t i = 0; i < count; i += kLanes) GlslInVectors::log(Float::load(x + i)).store(y + i);
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>
#include <limits>
#include <vector>

#include "base/worst.h"
#include "splat/native/native_pictures.h"

namespace macula::splat {

HWY_EXPORT(expOf);
HWY_EXPORT(logOf);

namespace {

double unitOf(double value) {
    const float single = std::abs(static_cast<float>(value));
    return double(std::nextafter(single, std::numeric_limits<float>::infinity())) - double(single);
}

TEST(VectorMaths, ExpIsWithinTwoUnitsInTheLastPlace) {
    std::vector<float> x(1 << 16);
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = -80.0f + 168.0f * (static_cast<float>(i) + 0.37f) / static_cast<float>(x.size());
    std::vector<float> y(x.size());
    onEachInstructionSet([&] {
        HWY_DYNAMIC_DISPATCH(expOf)(x.data(), y.data(), x.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double exact = std::exp(double(x[i]));
            worst = test::worse(worst, std::abs(double(y[i]) - exact) / unitOf(exact));
        }
        EXPECT_LT(worst, 2.0);
    });
    x.assign(16, 0.0f);
    x[1] = -1e30f;
    x[2] = -std::numeric_limits<float>::infinity();
    x[3] = 1e30f;
    onEachInstructionSet([&] {
        HWY_DYNAMIC_DISPATCH(expOf)(x.data(), y.data(), x.size());
        EXPECT_EQ(y[0], 1.0f);
        EXPECT_NEAR(double(y[1]) / std::exp(-80.0), 1.0, 1e-6);
        EXPECT_EQ(y[2], y[1]);
        EXPECT_NEAR(double(y[3]) / std::exp(88.0), 1.0, 1e-6);
    });
}

TEST(VectorMaths, LogIsWithinTwoUnitsInTheLastPlace) {
    std::vector<float> x(1 << 16);
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = static_cast<float>(std::exp(-80.0 + 160.0 * (double(i) + 0.37) / double(x.size())));
    for (std::size_t i = 0; i < 4096; ++i) x[i] = 1.0f + (static_cast<float>(i) - 2000.0f) * 1e-5f;
    std::vector<float> y(x.size());
    onEachInstructionSet([&] {
        HWY_DYNAMIC_DISPATCH(logOf)(x.data(), y.data(), x.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double exact = std::log(double(x[i]));
            worst = test::worse(worst, std::abs(double(y[i]) - exact) / std::max(2.0 * unitOf(exact), 1e-7));
        }
        EXPECT_LT(worst, 1.0);
    });
    x.assign(16, 0.0f);
    onEachInstructionSet([&] {
        HWY_DYNAMIC_DISPATCH(logOf)(x.data(), y.data(), x.size());
        EXPECT_TRUE(std::isfinite(y[0]));
    });
}

}  // namespace
}  // namespace macula::splat
#endif
