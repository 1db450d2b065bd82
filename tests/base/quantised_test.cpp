// What floats become in 16 bits where a few of them lie far away.
#include "base/quantised.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula {
namespace {

constexpr int kSide = 40;

// An ADC map in 1e-6 mm²/s: 0.25 apart, from 400 to 3600, and `odd` voxels of another value.
std::shared_ptr<const Volume> diffusion(std::size_t odd, float value) {
    std::vector<float> voxels(std::size_t{kSide} * kSide * kSide);
    for (std::size_t n = 0; n < voxels.size(); ++n) voxels[n] = 400.0F + 0.25F * float(n % 12'800);
    for (std::size_t n = 0; n < odd; ++n) voxels[n * 997] = value;
    auto made = Volume::createFloat({.size = glm::ivec3(kSide), .modality = "MR"}, std::move(voxels));
    return std::make_shared<const Volume>(*std::move(made));
}

double largestError(const Volume& a, const Volume& b, const ValueRange& within) {
    double error = 0.0;
    for (int k = 0; k < kSide; ++k)
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i)
                if (const double value = a.value(i, j, k); value >= within.low && value <= within.high)
                    error = std::max(error, std::abs(value - b.value(i, j, k)));
    return error;
}

TEST(Quantised, OneHotVoxelTakesNoStepsFromTissue) {
    for (const float hot : {1e6F, -1e6F, 3e38F}) {
        const auto floats = diffusion(1, hot);
        const Quantised made = quantised(floats);
        EXPECT_FALSE(made.isExact);
        EXPECT_LT(largestError(*floats, *made.volume, {400.0, 3600.0}), 0.08) << hot;
        const double brought = made.volume->value(0, 0, 0);
        EXPECT_NEAR(brought, hot > 0.0F ? 6799.0 : -2799.0, 5.0) << "as far away again as tissue is wide";
        const auto& said = made.volume->provenance().assumptions;
        ASSERT_EQ(said.size(), 2u);
        EXPECT_TRUE(said[1].english().starts_with("The 3D picture shows values below ")) << said[1];
    }
}

// What many voxels have is no mistake of a scanner: a bladder full of tracer, or metal.
TEST(Quantised, ManyHotVoxelsKeepTheirValues) {
    const auto floats = diffusion(64, 1e6F);  // a thousandth
    EXPECT_EQ(rangeToQuantise(*floats), floats->valueRange());
    const Quantised made = quantised(floats);
    EXPECT_NEAR(made.volume->value(0, 0, 0), 1e6, 8.0);
    EXPECT_EQ(made.volume->provenance().assumptions.size(), 1u);
}

TEST(Quantised, AFewThatAreNotFarAwayKeepTheirValues) {
    const auto floats = diffusion(1, 20'000.0F);
    EXPECT_EQ(rangeToQuantise(*floats), floats->valueRange());
}

TEST(Quantised, SaysWhetherAllValuesAreAsBefore) {
    const auto exact = [](std::vector<float> voxels) {
        const auto count = int(voxels.size());
        auto made = Volume::createFloat({.size = {count, 1, 1}}, std::move(voxels));
        return quantised(std::make_shared<const Volume>(*std::move(made)));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(exact({-3.0F, 5.0F, nan, 60'000.0F}).isExact);
    EXPECT_FALSE(exact({0.0F, 0.1F, 10.0F}).isExact);
    auto stored = Volume::create({.size = {2, 1, 1}}, {1, 2});
    const auto same = std::make_shared<const Volume>(*std::move(stored));
    const Quantised made = quantised(same);
    EXPECT_EQ(made.volume, same);
    EXPECT_TRUE(made.isExact);
}

}  // namespace
}  // namespace macula
