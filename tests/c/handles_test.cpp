// Mistakes of a host with its handles: refused, and survived.
#include <array>

#include "c/c_fixture.h"

namespace macula::test {
namespace {

constexpr int kSide = 16;

class CHandles : public ::testing::Test {
  protected:
    void SetUp() override {
        study_ = TwoBalls().study();
        view_ = viewOf(study_);
        ASSERT_NE(view_, nullptr);
        picture_.width = picture_.height = kSide;
        picture_.samples_per_pixel = 2;
        picture_.rgba = rgba_.data();
        picture_.bytes = rgba_.size();
    }

    Owned<macula_study> study_;
    Owned<macula_view> view_;
    std::array<std::uint8_t, 4 * kSide * kSide> rgba_{};
    macula_picture picture_ = sized<macula_picture>();
};

TEST_F(CHandles, WhatIsClosedIsRefusedAndClosedOnce) {
    macula_view* const view = view_.release();
    macula_study* const study = study_.release();
    macula_study_close(study);
    macula_study_close(study);
    auto volume = sized<macula_volume>();
    expectError(macula_study_volume(study, &volume), MACULA_USAGE);
    EXPECT_EQ(macula_study_volumes(study), 0u);
    EXPECT_EQ(macula_study_title(study, 0), nullptr);
    macula_view* none = view;
    expectError(macula_view_create(study, &none), MACULA_USAGE);
    EXPECT_EQ(none, nullptr);

    ASSERT_EQ(macula_draw(testDevice(), view, &picture_, nullptr, nullptr), MACULA_DONE)
        << lastError().message;
    macula_view_close(view);
    macula_view_close(view);
    expectError(macula_draw(testDevice(), view, &picture_, nullptr, nullptr), MACULA_USAGE);
    EXPECT_EQ(macula_view_note(view, 0), nullptr);
    const char* json = "not touched";
    expectError(macula_view_record(view, &json), MACULA_USAGE);
    EXPECT_EQ(json, nullptr);
}

TEST_F(CHandles, OneOfAnotherKindIsNone) {
    auto* const wrong = reinterpret_cast<macula_view*>(study_.get());
    expectError(macula_draw(testDevice(), wrong, &picture_, nullptr, nullptr), MACULA_USAGE);
    macula_view_close(wrong);
    auto volume = sized<macula_volume>();
    EXPECT_EQ(macula_study_volume(study_.get(), &volume), MACULA_DONE) << "nothing was closed";
    auto frame = sized<macula_frame>();
    expectError(macula_live_frame(reinterpret_cast<macula_live*>(view_.get()), &frame, nullptr, nullptr),
                MACULA_USAGE);
}

struct Meddler {
    macula_view* view = nullptr;
    macula_device* device = nullptr;
    const macula_picture* picture = nullptr;
    bool closes = false;
    int calls = 0;
    macula_status changed = MACULA_DONE;
    macula_status drawn = MACULA_DONE;
    const char* note = "not asked";
};

// What no host may do, from within a call that has the view and the device.
std::int32_t meddle(void* user, const char* /*stage*/, double /*fraction*/) {
    auto& meddler = *static_cast<Meddler*>(user);
    if (meddler.calls++ > 0) return 0;
    meddler.changed = macula_view_set_look(meddler.view, "mip");
    meddler.drawn = macula_draw(meddler.device, meddler.view, meddler.picture, nullptr, nullptr);
    meddler.note = macula_view_note(meddler.view, 0);
    if (meddler.closes) macula_view_close(meddler.view);
    return 0;
}

TEST_F(CHandles, WhatIsInUseIsRefusedAndTheCallGoesOn) {
    Meddler meddler{view_.get(), testDevice(), &picture_};
    auto progress = sized<macula_progress>();
    progress.told = meddle;
    progress.user = &meddler;
    auto drawn = sized<macula_drawn>();
    ASSERT_EQ(macula_draw(testDevice(), view_.get(), &picture_, &progress, &drawn), MACULA_DONE)
        << lastError().message;
    EXPECT_GT(meddler.calls, 0);
    EXPECT_EQ(meddler.changed, MACULA_USAGE);
    EXPECT_EQ(meddler.drawn, MACULA_USAGE);
    EXPECT_EQ(meddler.note, nullptr);
    EXPECT_EQ(drawn.is_empty, 0);
    EXPECT_EQ(macula_view_set_look(view_.get(), "mip"), MACULA_DONE) << "it is free again";
}

TEST_F(CHandles, WhatIsClosedWhileACallUsesItLastsAsLongAsTheCall) {
    macula_view* const view = view_.release();
    Meddler meddler{view, testDevice(), &picture_};
    meddler.closes = true;
    auto progress = sized<macula_progress>();
    progress.told = meddle;
    progress.user = &meddler;
    ASSERT_EQ(macula_draw(testDevice(), view, &picture_, &progress, nullptr), MACULA_DONE)
        << lastError().message;
    EXPECT_NE(rgba_, decltype(rgba_){});
    expectError(macula_draw(testDevice(), view, &picture_, nullptr, nullptr), MACULA_USAGE);
}

// A call that failed must not keep what it had.
TEST_F(CHandles, AfterAFailureTheyAreFree) {
    auto tooLarge = picture_;
    tooLarge.width = 1 << 20;
    expectError(macula_draw(testDevice(), view_.get(), &tooLarge, nullptr, nullptr), MACULA_USAGE);
    macula_cancel* cancel = nullptr;
    ASSERT_EQ(macula_cancel_create(&cancel), MACULA_DONE);
    macula_cancel_now(cancel);
    auto progress = sized<macula_progress>();
    progress.cancel = cancel;
    EXPECT_EQ(macula_draw(testDevice(), view_.get(), &picture_, &progress, nullptr), MACULA_CANCELLED);
    macula_cancel_close(cancel);
    EXPECT_EQ(macula_draw(testDevice(), view_.get(), &picture_, nullptr, nullptr), MACULA_DONE)
        << lastError().message;
}

TEST_F(CHandles, AStructOfNoSizeIsToldWithBothSizes) {
    auto volume = sized<macula_volume>();
    volume.size = 3;
    expectError(macula_study_volume(study_.get(), &volume), MACULA_USAGE);
    const std::string message = lastError().message;
    EXPECT_NE(message.find(" 3 bytes"), std::string::npos) << message;
    EXPECT_NE(message.find(std::to_string(sizeof volume)), std::string::npos) << message;
}

TEST_F(CHandles, ErrorsAreUtf8WhateverWasGiven) {
    macula_device* device = nullptr;
    expectError(macula_device_open("caf\xE9 \xC3\xA9 \xED\xA0\x80", &device), MACULA_USAGE);
    const std::string message = lastError().message;
    EXPECT_NE(message.find("caf\xEF\xBF\xBD \xC3\xA9 \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"),
              std::string::npos)
        << message;
    macula_study* study = nullptr;
    expectError(macula_study_open("/nowhere/\xFF", nullptr, nullptr, &study), MACULA_INPUT);
    EXPECT_STREQ(lastError().place, "/nowhere/\xEF\xBF\xBD");
}

}  // namespace
}  // namespace macula::test
