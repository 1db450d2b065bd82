// Our distances against those of ITK.
#include "segment/distance.h"

#include <gtest/gtest.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <random>

#include "segment/itk_image.h"

namespace macula::segment {
namespace {

TEST(Distance, IsThatOfItk) {
    const Grid grid{.size = {41, 37, 29}, .spacingMm = {2.1, 1.7, 3.3}};
    std::mt19937 random(7);
    Mask mask(grid.count());
    for (int n = 0; n < 25; ++n) mask[random() % mask.size()] = 1;
    for (int b = 5; b < 15; ++b) std::fill_n(mask.begin() + std::ptrdiff_t(grid.index(8, b, 12)), 9, 1);

    using Filter = itk::SignedMaurerDistanceMapImageFilter<MaskImage, itk::Image<float, 3>>;
    const auto filter = Filter::New();
    filter->SetInput(imageOf(grid, mask));
    filter->SetSquaredDistance(false);
    filter->SetUseImageSpacing(true);
    filter->Update();
    const float* expected = filter->GetOutput()->GetBufferPointer();

    const double reachMm = 12.0;
    const std::vector<float> actual = distanceTo(grid, mask, reachMm);
    std::size_t within = 0;
    for (std::size_t n = 0; n < mask.size(); ++n) {
        const float truth = std::max(expected[n], 0.0f);
        if (std::abs(truth - reachMm) < 1e-3) continue;
        if (truth > reachMm) {
            ASSERT_TRUE(std::isinf(actual[n])) << n;
        } else {
            ASSERT_NEAR(actual[n], truth, 1e-4) << n;
            ++within;
        }
    }
    EXPECT_GT(within, mask.size() / 4);
}

// They are of the whole process, in which Macula may be a guest.
TEST(Itk, KeepsTheWarningsOfItsOtherUsers) {
    const Grid grid{.size = {3, 3, 3}};
    EXPECT_NE(imageOf(grid, Mask(grid.count())), nullptr);
    EXPECT_TRUE(itk::Object::GetGlobalWarningDisplay());
}

TEST(Distance, OfNothingIsInfinite) {
    const Grid grid{.size = {3, 1, 2}};
    for (const float mm : distanceTo(grid, Mask(6), 5.0)) EXPECT_TRUE(std::isinf(mm));
}

// A plate 3 blocks thick beside a cube of 9, and a plate that the edge of the grid cuts.
TEST(Distance, OpeningKeepsWhatIsThick) {
    const Grid grid{.size = {40, 20, 20}, .spacingMm = {1.0, 1.0, 1.0}};
    Mask mask(grid.count());
    for (int c = 4; c < 13; ++c) {
        for (int b = 4; b < 13; ++b) {
            for (int a = 4; a < 13; ++a) mask[grid.index(a, b, c)] = 1;
            for (int a = 20; a < 23; ++a) mask[grid.index(a, b, c)] = 1;
        }
    }
    std::vector<float> depthMm;
    const Mask open = opened(grid, mask, 2.5, 10.0, depthMm);
    EXPECT_EQ(open[grid.index(8, 8, 8)], 1);
    EXPECT_EQ(open[grid.index(4, 8, 8)], 1);
    EXPECT_EQ(open[grid.index(21, 8, 8)], 0);
    EXPECT_EQ(depthMm[grid.index(8, 8, 8)], 5.0f);
    EXPECT_EQ(depthMm[grid.index(21, 8, 8)], 2.0f);
    EXPECT_EQ(depthMm[grid.index(30, 8, 8)], 0.0f);
}

}  // namespace
}  // namespace macula::segment
