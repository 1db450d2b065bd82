// How bright a picture is.
#include "scene/lights/light_meter.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace macula::scene {
namespace {

TEST(LightMeter, PutsTheBrightestTwentiethBelowWhite) {
    std::vector<glm::vec4> picture;
    for (int i = 1; i <= 1000; ++i) picture.push_back({glm::vec3(0.001f * float(i)), 1.0f});
    EXPECT_NEAR(*meteredExposure(picture), kMeteredLuminance / 0.95, 1e-6);
}

TEST(LightMeter, CountsWhatIsSeenAndFinite) {
    std::vector<glm::vec4> picture(100, {0.35f, 0.35f, 0.35f, 1.0f});
    const double exposure = *meteredExposure(picture);
    EXPECT_NEAR(exposure, 2.0, 1e-6);
    picture.insert(picture.end(), 500, glm::vec4(0.0f));            // background
    picture.insert(picture.end(), 500, {4.0f, 4.0f, 4.0f, 0.25f});  // hardly covered
    picture.push_back(glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    picture.push_back({std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 1.0f});
    EXPECT_EQ(*meteredExposure(picture), exposure);
    for (glm::vec4& pixel : picture) pixel *= 0.75f;  // premultiplied: as bright, less covered
    EXPECT_NEAR(*meteredExposure(picture), exposure, 1e-6);
}

TEST(LightMeter, SpecksDoNotDarkenThePicture) {
    std::vector<glm::vec4> picture(100, {0.35f, 0.35f, 0.35f, 1.0f});
    for (int i = 0; i < 4; ++i) picture[std::size_t(i) * 7] = {1e6f, 1e6f, 1e6f, 1.0f};
    EXPECT_NEAR(*meteredExposure(picture), 2.0, 1e-6);
}

TEST(LightMeter, StaysWithinItsRange) {
    EXPECT_FALSE(meteredExposure({}).has_value());
    EXPECT_FALSE(meteredExposure(std::vector<glm::vec4>(9, glm::vec4(0.0f))).has_value());
    EXPECT_EQ(*meteredExposure(std::vector<glm::vec4>(9, {0.0f, 0.0f, 0.0f, 1.0f})), kMostMetered);
    EXPECT_EQ(*meteredExposure(std::vector<glm::vec4>(9, {1e30f, 1e30f, 1e30f, 1.0f})), 1.0 / kMostMetered);
    const float denormal = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(*meteredExposure(std::vector<glm::vec4>(1, {denormal, 0.0f, 0.0f, 1.0f})), kMostMetered);
}

}  // namespace
}  // namespace macula::scene
