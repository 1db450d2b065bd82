// Views of the C interface as text, what a picture says of itself, and who has the log.
#include <cstring>
#include <nlohmann/json.hpp>

#include "c/c_fixture.h"

namespace macula::test {
namespace {

using Json = nlohmann::json;

std::string stateOf(const Owned<macula_view>& view) {
    const char* json = nullptr;
    EXPECT_EQ(macula_view_state(view.get(), &json), MACULA_DONE) << lastError().message;
    return json == nullptr ? "" : json;
}

TEST(CState, GoesOutAndInAndIsTheSame) {
    const auto study = TwoBalls().study();
    const auto view = viewOf(study);
    auto camera = sized<macula_camera>();
    camera.position_mm[1] = -300.0;
    camera.up[2] = 1.0;
    camera.vertical_fov_deg = 25.0;
    ASSERT_EQ(macula_view_set_preset(view.get(), "cinematic-chest", 0), MACULA_DONE);
    ASSERT_EQ(macula_view_set_look(view.get(), "clear"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_lights(view.get(), "studio"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_clip(view.get(), "left-half"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_camera(view.get(), &camera), MACULA_DONE) << lastError().message;
    const std::string state = stateOf(view);
    ASSERT_TRUE(Json::accept(state)) << state;

    const auto other = viewOf(study);
    EXPECT_NE(stateOf(other), state);
    ASSERT_EQ(macula_view_set_state(other.get(), state.c_str()), MACULA_DONE) << lastError().message;
    EXPECT_EQ(stateOf(other), state);
    // What is chosen afterwards counts more.
    ASSERT_EQ(macula_view_set_clip(other.get(), nullptr), MACULA_DONE);
    EXPECT_NE(stateOf(other), state);
    ASSERT_EQ(macula_view_set_clip(other.get(), "left-half"), MACULA_DONE);
    EXPECT_EQ(stateOf(other), state);
}

TEST(CState, DrawsWhatItSays) {
    const auto study = TwoBalls().study();
    const auto view = viewOf(study);
    ASSERT_EQ(macula_view_set_clip(view.get(), "left-half"), MACULA_DONE);
    const std::string state = stateOf(view);
    const auto other = viewOf(study);
    ASSERT_EQ(macula_view_set_state(other.get(), state.c_str()), MACULA_DONE);

    macula_device* device = nullptr;
    ASSERT_EQ(macula_device_open(nullptr, &device), MACULA_DONE) << lastError().message;
    const Owned<macula_device> owned(device);
    std::vector<std::uint8_t> pictures[2];
    int index = 0;
    for (const auto* drawn : {&view, &other}) {
        pictures[index].resize(4 * 32 * 32);
        auto picture = sized<macula_picture>();
        picture.width = picture.height = 32;
        picture.samples_per_pixel = 2;
        picture.rgba = pictures[index].data();
        picture.bytes = pictures[index].size();
        ASSERT_EQ(macula_draw(device, drawn->get(), &picture, nullptr, nullptr), MACULA_DONE);
        ++index;
    }
    EXPECT_EQ(pictures[0], pictures[1]);

    const char* text = nullptr;
    ASSERT_EQ(macula_view_record(other.get(), &text), MACULA_DONE);
    const Json record = Json::parse(text);
    EXPECT_EQ(record.at("width"), 32);
    EXPECT_EQ(record.at("preset"), "cinematic-bone");
    EXPECT_EQ(record.at("clip"), "left-half");
    EXPECT_DOUBLE_EQ(record.at("meanSamplesPerPixel").get<double>(), 2.0);
}

TEST(CState, WhatIsNoneIsRefusedAndTheViewStays) {
    const auto study = TwoBalls().study();
    const auto view = viewOf(study);
    ASSERT_EQ(macula_view_set_clip(view.get(), "left-half"), MACULA_DONE);
    const std::string before = stateOf(view);
    expectError(macula_view_set_state(view.get(), ""), MACULA_INPUT);
    expectError(macula_view_set_state(view.get(), "{\"camera\": [1, 2"), MACULA_INPUT);
    expectError(macula_view_set_state(view.get(), "[]"), MACULA_INPUT);
    expectError(macula_view_set_state(view.get(), nullptr), MACULA_USAGE);
    expectError(macula_view_set_state(nullptr, "{}"), MACULA_USAGE);
    // Of another patient: a clip or a camera would be a lie there.
    TwoBalls others;
    others.hu.front() = 500;
    const auto otherStudy = others.study();
    const auto other = viewOf(otherStudy);
    expectError(macula_view_set_state(other.get(), before.c_str()), MACULA_INPUT);
    EXPECT_EQ(stateOf(view), before);
    const char* text = "";
    expectError(macula_view_record(view.get(), &text), MACULA_USAGE);  // not drawn yet
    EXPECT_EQ(text, nullptr);
    expectError(macula_view_state(view.get(), nullptr), MACULA_USAGE);
}

void remember(void* user, std::int32_t level, const char* line) {
    if (level == MACULA_LOG_INFO) *static_cast<std::string*>(user) += line;
}

TEST(CLog, TheHostHasItAndNobodyElse) {
    std::string lines;
    ::testing::internal::CaptureStderr();
    ASSERT_EQ(macula_log_to(remember, &lines, MACULA_LOG_WARNING), MACULA_DONE);
    macula_device* device = nullptr;
    ASSERT_EQ(macula_device_open(nullptr, &device), MACULA_DONE) << lastError().message;
    macula_device_close(device);
    EXPECT_NE(lines.find("renders on"), std::string::npos) << lines;
    ASSERT_EQ(macula_log_to(nullptr, nullptr, MACULA_LOG_WARNING), MACULA_DONE);
    lines.clear();
    ASSERT_EQ(macula_device_open(nullptr, &device), MACULA_DONE);
    macula_device_close(device);
    EXPECT_EQ(lines, "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    expectError(macula_log_to(remember, &lines, 4), MACULA_USAGE);
}

}  // namespace
}  // namespace macula::test
