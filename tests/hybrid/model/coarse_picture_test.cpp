// What is seen while there is no model.
#include "pipeline/hybrid/model/held_out_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace macula::hybrid {
namespace {

using Colour = std::function<glm::vec4(int x, int y)>;

splat::TrainingView viewOf(const glm::ivec2& size, const Colour& colour) {
    splat::TrainingView view;
    view.view.sizePx = size;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) view.pixels.push_back(colour(x, y));
    return view;
}

TEST(CoarsePicture, ShowsWhatIsEvenAndWhatRisesEvenlyAsItIs) {
    const splat::LossOptions loss;
    const auto even = viewOf({64, 96}, [](int, int) { return glm::vec4(0.3f, 0.2f, 0.1f, 1.0f); });
    EXPECT_NEAR(coarseDifference(even, 24, loss), 0.0, 1e-7);
    const auto ramp = viewOf(
        {64, 96}, [](int x, int y) { return glm::vec4(float(x) / 100.0f, float(y) / 100.0f, 0.0f, 1.0f); });
    const splat::TrainingView shown = coarselyShown(ramp, 24);
    for (int y = 8; y < 88; ++y)
        for (int x = 8; x < 56; ++x) {
            const glm::vec4 of = shown.pixels[std::size_t(y) * 64 + std::size_t(x)];
            // A coarse pixel is one of four by four, half a pixel beside the middle of them.
            EXPECT_NEAR(of.r, (float(x) + 0.5f) / 100.0f, 1e-5f);
            EXPECT_NEAR(of.g, (float(y) + 0.5f) / 100.0f, 1e-5f);
        }
}

TEST(CoarsePicture, LosesWhatIsFiner) {
    const splat::LossOptions loss;
    const auto stripes =
        viewOf({96, 96}, [](int x, int) { return glm::vec4(glm::vec3(x / 2 % 2 == 0 ? 1.0f : 0.0f), 1.0f); });
    // Of four values three are colours, and half of the pixels are as far off as can be.
    EXPECT_NEAR(coarseDifference(stripes, 24, loss), 0.375, 0.02);
    EXPECT_LT(coarseDifference(stripes, 48, loss), 0.4);
    EXPECT_EQ(coarseDifference(stripes, 96, loss), 0.0) << "it has no fewer lines";
    EXPECT_EQ(coarseDifference(stripes, 200, loss), 0.0);
}

TEST(CoarsePicture, IsComparedAtTheExtremes) {
    const splat::LossOptions loss{.encode = splat::LossEncoding::display};
    EXPECT_EQ(coarseDifference(viewOf({0, 0}, nullptr), 42, loss), 0.0);
    EXPECT_EQ(coarseDifference(viewOf({1, 1}, [](int, int) { return glm::vec4(1.0f); }), 42, loss), 0.0);
    const auto one = viewOf({200, 1}, [](int x, int) { return glm::vec4(float(x % 2)); });
    EXPECT_EQ(coarseDifference(one, 42, loss), 0.0);
    EXPECT_TRUE(std::isfinite(coarseDifference(one, 1, loss)));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const auto torn = viewOf({64, 64}, [&](int x, int y) {
        if (x < 20) return glm::vec4(nan);
        return x == 40 && y == 40 ? glm::vec4(inf, 0.0f, 0.0f, 1.0f) : glm::vec4(float(y % 3) * 1e30f);
    });
    const double difference = coarseDifference(torn, 16, loss);
    EXPECT_TRUE(std::isfinite(difference));
    EXPECT_GT(difference, 0.0);
    const auto unknown = viewOf({64, 64}, [&](int, int) { return glm::vec4(nan); });
    EXPECT_EQ(coarseDifference(unknown, 16, loss), 0.0);
}

TEST(CoarsePicture, OfAnOutlineOnlyCoverageCounts) {
    auto view =
        viewOf({64, 64}, [](int x, int y) { return glm::vec4(float(x % 2), float(y % 2), 0.0f, 1.0f); });
    EXPECT_GT(coarseDifference(view, 16, {}), 0.0);
    view.kind = splat::ViewKind::outline;
    EXPECT_EQ(coarseDifference(view, 16, {}), 0.0);
}

}  // namespace
}  // namespace macula::hybrid
