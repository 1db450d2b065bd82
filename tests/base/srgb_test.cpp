#include "base/srgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula {
namespace {

// The table of IEC 61966-2-1 and values that are known elsewhere.
TEST(Srgb, HasTheStandardsValues) {
    EXPECT_EQ(encodedSrgb(0.0), 0.0);
    EXPECT_NEAR(encodedSrgb(1.0), 1.0, 1e-12);
    EXPECT_NEAR(encodedSrgb(0.5), 0.735356983052449, 1e-12);
    EXPECT_NEAR(encodedSrgb(0.18), 0.461356, 1e-6) << "18 % grey";
    EXPECT_NEAR(decodedSrgb(0.5), 0.214041140482232, 1e-12);
    EXPECT_NEAR(decodedSrgb(0.02), 0.02 / 12.92, 1e-15) << "the line through 0";
}

TEST(Srgb, DecodesWhatItEncodes) {
    for (int i = 0; i <= 255; ++i) {
        const double encoded = double(i) / 255.0;
        EXPECT_NEAR(encodedSrgb(decodedSrgb(encoded)), encoded, 1e-7) << i;
        const auto single = float(encoded);
        EXPECT_NEAR(encodedSrgb(decodedSrgb(single)), single, 1e-6f) << i;
        EXPECT_EQ(std::lround(255.0f * encodedSrgb(float(decodedSrgb(encoded)))), i);
    }
}

// Of both pieces, where they meet: a step would be seen as a line in a smooth picture.
TEST(Srgb, HasNoStepWhereTheLineEnds) {
    EXPECT_NEAR(decodedSrgb(0.04045), decodedSrgb(std::nextafter(0.04045, 1.0)), 1e-7);
    EXPECT_NEAR(encodedSrgb(0.0031308), encodedSrgb(std::nextafter(0.0031308, 1.0)), 1e-6);
    EXPECT_GT(decodedSrgb(1.2), 1.2) << "it goes on above white";
    EXPECT_TRUE(std::isnan(decodedSrgb(std::nan(""))));
}

}  // namespace
}  // namespace macula
