// Qualities as people write them.
#include "pipeline/trace/quality.h"

#include <gtest/gtest.h>

#include "presets/embedded_files.h"

namespace macula::trace {
namespace {

TEST(Quality, BuiltInOnesAreUsable) {
    ASSERT_EQ(presets::qualityFiles().size(), 4u);
    for (const auto& file : presets::qualityFiles()) {
        const auto quality = qualityFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(quality) << quality.error().message;
        EXPECT_EQ(quality->name, file.name);
        // What is called the reference is what it is said to be.
        if (file.name == "reference") {
            EXPECT_EQ(quality->denoising, Denoising::off);
            EXPECT_EQ(quality->filter, Filter::trilinear);
        }
    }
}

TEST(Quality, ErrorsSayWhatWasExpected) {
    const auto says = [](const std::string& fields) {
        const auto read =
            qualityFromJson("{\"version\":1,\"name\":\"a\",\"title\":\"A\"," + fields + "}", "a.json");
        return read ? std::string() : read.error().message.english() + " " + read.error().hint.english();
    };
    EXPECT_EQ(says(R"("samplesPerPixel":4,"bounces":2,"filter":"trilinear","denoise":true)"), "");
    EXPECT_NE(says(R"("samplesPerPixel":0,"bounces":2,"filter":"trilinear","denoise":true)"), "");
    EXPECT_NE(says(R"("samplesPerPixel":1.5,"bounces":2,"filter":"trilinear","denoise":true)").find("whole"),
              std::string::npos);
    EXPECT_NE(says(R"("samplesPerPixel":4,"bounces":1025,"filter":"trilinear","denoise":true)"), "");
    EXPECT_NE(says(R"("samplesPerPixel":4,"bounces":2,"filter":"cubic","denoise":true)").find("stochastic"),
              std::string::npos);
    EXPECT_NE(says(R"("samplesPerPixel":4,"bounces":2,"filter":"trilinear","denoise":1)"), "");
    EXPECT_NE(
        says(R"("samplesPerPixel":4,"bounces":2,"filter":"trilinear","denoise":true,"spp":3)").find("spp"),
        std::string::npos);
    EXPECT_NE(says(R"("bounces":2,"filter":"trilinear","denoise":true)").find("samplesPerPixel"),
              std::string::npos);
}

}  // namespace
}  // namespace macula::trace
