// Pictures of the C interface.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "c/c_fixture.h"

namespace macula::test {
namespace {

constexpr int kSide = 40;

class CDrawing : public ::testing::Test {
  protected:
    static macula_device* device() { return testDevice(); }

    void SetUp() override {
        const auto study = TwoBalls().study();  // closed before its view is drawn
        view_ = viewOf(study);
        ASSERT_NE(view_, nullptr);
        picture_ = sized<macula_picture>();
        picture_.width = picture_.height = kSide;
        picture_.samples_per_pixel = 2;
        picture_.rgba = rgba_.data();
        picture_.bytes = rgba_.size();
    }

    macula_status draw(const macula_progress* progress = nullptr) {
        return macula_draw(device(), view_.get(), &picture_, progress, &drawn_);
    }
    // Of the columns from `first` to before `last`.
    double light(int first, int last) const {
        double sum = 0.0;
        for (int y = 0; y < kSide; ++y)
            for (int x = first; x < last; ++x)
                for (int channel = 0; channel < 3; ++channel)
                    sum += rgba_[std::size_t(4 * (y * kSide + x) + channel)];
        return sum;
    }
    double left() const { return light(0, kSide / 2); }
    double right() const { return light(kSide / 2, kSide); }

    Owned<macula_view> view_;
    std::vector<std::uint8_t> rgba_ = std::vector<std::uint8_t>(4 * kSide * kSide, 7);
    macula_picture picture_{};
    macula_drawn drawn_ = sized<macula_drawn>();
};

TEST_F(CDrawing, FromTheFrontThePatientsLeftIsAtTheRightAndFromBehindAtTheLeft) {
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_GT(right(), 3.0 * left());
    EXPECT_EQ(drawn_.is_empty, 0);
    EXPECT_EQ(drawn_.is_denoised, 0);
    EXPECT_EQ(drawn_.is_coarse, 0);
    EXPECT_DOUBLE_EQ(drawn_.samples_per_pixel, 2.0);
    EXPECT_STREQ(drawn_.preset, "cinematic-bone");
    EXPECT_LT(drawn_.camera.position_mm[1], 0.0) << "before the patient: +y is posterior";
    for (std::size_t i = 3; i < rgba_.size(); i += 4) ASSERT_EQ(rgba_[i], 255);
    ASSERT_EQ(macula_view_set_direction(view_.get(), "posterior"), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_GT(left(), 3.0 * right());
}

// A view leaves its scene on the device, whichever view or device comes next, and whoever is closed first.
TEST_F(CDrawing, ViewsAndDevicesTakeTurns) {
    const auto pixelsOf = [&](macula_device* on, macula_view* view) {
        std::ranges::fill(rgba_, std::uint8_t(7));
        EXPECT_EQ(macula_draw(on, view, &picture_, nullptr, &drawn_), MACULA_DONE) << lastError().message;
        return rgba_;
    };
    const std::vector<std::uint8_t> first = pixelsOf(device(), view_.get());
    auto other = viewOf(TwoBalls().study());
    ASSERT_EQ(macula_view_set_direction(other.get(), "posterior"), MACULA_DONE);
    const std::vector<std::uint8_t> behind = pixelsOf(device(), other.get());
    EXPECT_NE(behind, first);
    macula_device* second = nullptr;
    ASSERT_EQ(macula_device_open(nullptr, &second), MACULA_DONE);
    EXPECT_EQ(pixelsOf(second, view_.get()), first);
    EXPECT_EQ(pixelsOf(device(), view_.get()), first);
    EXPECT_EQ(pixelsOf(second, other.get()), behind);
    EXPECT_EQ(pixelsOf(device(), other.get()), behind);
    EXPECT_EQ(pixelsOf(second, other.get()), behind);
    macula_device_close(second);
    EXPECT_EQ(pixelsOf(device(), other.get()), behind);
    other.reset();
    EXPECT_EQ(pixelsOf(device(), view_.get()), first);
}

// Voxels that are stored from left to right show the same patient.
TEST_F(CDrawing, OfMirroredVoxelsThePatientStaysAsHeIs) {
    TwoBalls mirrored;
    for (std::size_t row = 0; row < mirrored.hu.size(); row += TwoBalls::kSide)
        std::reverse(mirrored.hu.begin() + std::ptrdiff_t(row),
                     mirrored.hu.begin() + std::ptrdiff_t(row) + TwoBalls::kSide);
    macula_voxels given = mirrored.voxels();
    given.patient_from_voxel[0] = -4.0;
    given.patient_from_voxel[3] = 46.0;
    macula_study* study = nullptr;
    ASSERT_EQ(macula_study_of_voxels(&given, nullptr, &study), MACULA_DONE);
    const Owned<macula_study> owned(study);
    view_ = viewOf(owned);
    ASSERT_NE(view_, nullptr);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_GT(right(), 3.0 * left());
}

// null is the direction that `macula render` takes, and the record tells why.
TEST_F(CDrawing, WithoutADirectionItIsSeenFromWhereItsKindIs) {
    const auto viewed = [&](int slices) {
        const TwoBalls balls;
        macula_voxels given = balls.voxels();
        const int leftOut = (TwoBalls::kSide - slices) / 2;  // above and below
        const std::size_t slice = std::size_t(TwoBalls::kSide) * TwoBalls::kSide;
        given.slices = slices;
        given.data = balls.hu.data() + slice * std::size_t(leftOut);
        given.bytes = slice * std::size_t(slices) * sizeof(std::int16_t);
        given.patient_from_voxel[11] += 4.0 * leftOut;
        macula_study* study = nullptr;
        EXPECT_EQ(macula_study_of_voxels(&given, nullptr, &study), MACULA_DONE) << lastError().message;
        const Owned<macula_study> owned(study);
        view_ = viewOf(owned);
        EXPECT_EQ(macula_view_set_direction(view_.get(), "left"), MACULA_DONE);
        EXPECT_EQ(macula_view_set_direction(view_.get(), nullptr), MACULA_DONE);
        EXPECT_EQ(draw(), MACULA_DONE) << lastError().message;
        const char* record = nullptr;
        EXPECT_EQ(macula_view_record(view_.get(), &record), MACULA_DONE);
        const auto json = nlohmann::json::parse(record);
        return std::pair(json["view"].get<std::string>(), json["whyView"].get<std::string>());
    };
    const auto rise = [&] {
        const macula_camera& camera = drawn_.camera;
        const double behind = camera.target_mm[1] - camera.position_mm[1];
        return std::atan2(camera.position_mm[2] - camera.target_mm[2], behind) * 180.0 / 3.14159265;
    };
    EXPECT_EQ(viewed(10), std::pair(std::string("oblique"), std::string("short-scan")));
    EXPECT_GT(rise(), 30.0) << "from above";
    EXPECT_GT(right(), left()) << "never mirrored";
    EXPECT_EQ(viewed(TwoBalls::kSide), std::pair(std::string("turned"), std::string("body")));
    EXPECT_GT(rise(), 5.0);
    EXPECT_LT(rise(), 12.0);
    EXPECT_GT(right(), left());
}

TEST_F(CDrawing, LiesOverTheBackgroundThatIsChosen) {
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_EQ(rgba_[0], 0) << "black where nobody chose";
    ASSERT_EQ(macula_view_set_background(view_.get(), "#10f0ff"), MACULA_DONE) << lastError().message;
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_EQ(std::vector<std::uint8_t>(rgba_.begin(), rgba_.begin() + 4),
              (std::vector<std::uint8_t>{0x10, 0xf0, 0xff, 255}));
    const char* state = nullptr;
    ASSERT_EQ(macula_view_state(view_.get(), &state), MACULA_DONE);
    EXPECT_EQ(nlohmann::json::parse(state)["background"], "#10f0ff");
    expectError(macula_view_set_background(view_.get(), "sky"), MACULA_USAGE);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_EQ(rgba_[1], 0xf0) << "it stays";
    ASSERT_EQ(macula_view_set_background(view_.get(), nullptr), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_EQ(rgba_[1], 0);
}

TEST_F(CDrawing, ABoxAndAClipHideWhatIsOutside) {
    // Mip of all values: the camera shows the whole volume, so that halves stay where they are.
    ASSERT_EQ(macula_view_set_look(view_.get(), "mip"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_window(view_.get(), 0.0, 2000.0), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE);
    const double whole = right();
    const double small = left();
    ASSERT_GT(whole, 2.0 * small);
    ASSERT_GT(small, 0.0);
    const double low[3] = {-48.0, -48.0, -48.0};
    const double high[3] = {0.0, 48.0, 48.0};  // the patient's right half
    ASSERT_EQ(macula_view_set_box(view_.get(), low, high), MACULA_DONE) << lastError().message;
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_NEAR(left(), small, 0.1 * small);
    EXPECT_LT(right(), 0.1 * whole);
    ASSERT_EQ(macula_view_set_clip(view_.get(), "left-half"), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_NEAR(right(), whole, 0.1 * whole);
    EXPECT_LT(left(), 0.1 * small);
    ASSERT_EQ(macula_view_set_clip(view_.get(), nullptr), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_NEAR(left(), small, 0.02 * small);
}

TEST_F(CDrawing, WithTheCameraThatWasToldThePictureIsTheSame) {
    ASSERT_EQ(draw(), MACULA_DONE);
    const std::vector<std::uint8_t> before = rgba_;
    ASSERT_EQ(macula_view_set_camera(view_.get(), &drawn_.camera), MACULA_DONE) << lastError().message;
    std::ranges::fill(rgba_, std::uint8_t(7));
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_EQ(rgba_, before);
}

// What can be set can be kept and set again.
TEST_F(CDrawing, AWindowThatNoStateCouldHoldIsRefused) {
    for (const double bad :
         {1e10, -1e10, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        expectError(macula_view_set_window(view_.get(), bad, 100.0), MACULA_USAGE);
    for (const double bad : {1e10, 1e-10, -1.0, std::numeric_limits<double>::quiet_NaN()})
        expectError(macula_view_set_window(view_.get(), 0.0, bad), MACULA_USAGE);
    ASSERT_EQ(macula_view_set_look(view_.get(), "mip"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_window(view_.get(), 1e9, 1e-9), MACULA_DONE);
    const char* state = nullptr;
    ASSERT_EQ(macula_view_state(view_.get(), &state), MACULA_DONE) << lastError().message;
    EXPECT_EQ(macula_view_set_state(view_.get(), std::string(state).c_str()), MACULA_DONE)
        << lastError().message;
}

TEST_F(CDrawing, ABlackProjectionSpeaksOfItsWindowAndOfNoPreset) {
    ASSERT_EQ(macula_view_set_look(view_.get(), "mip"), MACULA_DONE);
    ASSERT_EQ(macula_view_set_window(view_.get(), 5000.0, 100.0), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    ASSERT_EQ(drawn_.is_empty, 1);
    ASSERT_NE(macula_view_note(view_.get(), 0), nullptr);
    const std::string note = macula_view_note(view_.get(), 0);
    EXPECT_NE(note.find("W 100 L 5000 HU"), std::string::npos) << note;
    EXPECT_EQ(note.find("reset"), std::string::npos) << note;
}

TEST_F(CDrawing, WhatIsPointedAtIsWhereItIs) {
    auto pick = sized<macula_pick>();
    auto picked = sized<macula_picked>();
    pick.width = pick.height = 101;  // the middle of a pixel is that of the picture
    pick.x = pick.y = 50.5;
    expectError(macula_view_pick(view_.get(), &pick, nullptr, &picked),
                MACULA_USAGE);  // from where is not known
    // From the front, straight at the middle of the large ball, whose radius is 18 mm.
    auto camera = sized<macula_camera>();
    camera.position_mm[0] = camera.target_mm[0] = 22.0;
    camera.position_mm[1] = -500.0;
    camera.up[2] = 1.0;
    pick.camera = &camera;
    ASSERT_EQ(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_DONE) << lastError().message;
    ASSERT_EQ(picked.is_something, 1);
    EXPECT_NEAR(picked.point_mm[0], 22.0, 0.5);
    EXPECT_NEAR(picked.point_mm[1], -18.0, 4.0);
    EXPECT_NEAR(picked.point_mm[2], 0.0, 0.5);
    // To the right of the picture is the patient's left, and below is inferior.
    camera.parallel_height_mm = 101.0;  // a pixel is a millimetre
    pick.x = 58.5;
    pick.y = 55.5;
    ASSERT_EQ(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_DONE) << lastError().message;
    ASSERT_EQ(picked.is_something, 1);
    EXPECT_NEAR(picked.point_mm[0], 30.0, 0.5);
    EXPECT_NEAR(picked.point_mm[2], -5.0, 0.5);
    pick.x = pick.y = 0.5;
    ASSERT_EQ(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_DONE);
    EXPECT_EQ(picked.is_something, 0);
    EXPECT_EQ(picked.point_mm[0], 0.0);

    // As it was drawn; and of what is clipped away nothing.
    camera.parallel_height_mm = 0.0;
    ASSERT_EQ(macula_view_set_camera(view_.get(), &camera), MACULA_DONE);
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    pick.camera = nullptr;
    pick.x = pick.y = 50.5;
    ASSERT_EQ(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_DONE);
    EXPECT_EQ(picked.is_something, 1);
    ASSERT_EQ(macula_view_set_clip(view_.get(), "right-half"), MACULA_DONE);
    ASSERT_EQ(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_DONE);
    EXPECT_EQ(picked.is_something, 0);
}

TEST_F(CDrawing, APlaceThatIsInNoPictureIsRefused) {
    ASSERT_EQ(draw(), MACULA_DONE);
    auto good = sized<macula_pick>();
    good.width = good.height = kSide;
    auto picked = sized<macula_picked>();
    const auto refused = [&](const auto& change) {
        macula_pick pick = good;
        change(pick);
        expectError(macula_view_pick(view_.get(), &pick, nullptr, &picked), MACULA_USAGE);
    };
    refused([](macula_pick& p) { p.size = 0; });
    refused([](macula_pick& p) { p.width = 0; });
    refused([](macula_pick& p) { p.x = -1.0; });
    refused([](macula_pick& p) { p.y = kSide + 1.0; });
    refused([](macula_pick& p) { p.x = std::numeric_limits<double>::quiet_NaN(); });
    auto nowhere = sized<macula_camera>();
    refused([&](macula_pick& p) { p.camera = &nowhere; });
    expectError(macula_view_pick(view_.get(), nullptr, nullptr, &picked), MACULA_USAGE);
    expectError(macula_view_pick(view_.get(), &good, nullptr, nullptr), MACULA_USAGE);
    picked.size = 0;
    expectError(macula_view_pick(view_.get(), &good, nullptr, &picked), MACULA_USAGE);
}

TEST_F(CDrawing, RowsMayBeLongerAndNothingIsWrittenBetweenThem) {
    ASSERT_EQ(draw(), MACULA_DONE);
    const std::vector<std::uint8_t> tight = rgba_;
    constexpr std::size_t kRow = 4 * kSide + 12;
    std::vector<std::uint8_t> wide(kRow * kSide, 9);
    picture_.rgba = wide.data();
    picture_.row_bytes = kRow;
    picture_.bytes = wide.size() - 12;
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    for (std::size_t y = 0; y < kSide; ++y) {
        EXPECT_TRUE(std::equal(wide.begin() + std::ptrdiff_t(y * kRow),
                               wide.begin() + std::ptrdiff_t(y * kRow + 4 * kSide),
                               tight.begin() + std::ptrdiff_t(y * 4 * kSide)));
        for (std::size_t gap = 4 * kSide; gap < kRow; ++gap) ASSERT_EQ(wide[y * kRow + gap], 9);
    }
}

TEST_F(CDrawing, PicturesThatAreNoneAreRefusedAndLeaveThePixels) {
    const std::vector<std::uint8_t> before = rgba_;
    const auto refused = [&](const auto& change) {
        const macula_picture good = picture_;
        change(picture_);
        expectError(draw(), MACULA_USAGE);
        picture_ = good;
    };
    refused([](macula_picture& p) { p.size = 0; });
    refused([](macula_picture& p) { p.width = 0; });
    refused([](macula_picture& p) { p.height = -1; });
    refused([](macula_picture& p) { p.width = 16385; });
    refused([](macula_picture& p) { p.rgba = nullptr; });
    refused([](macula_picture& p) { p.bytes -= 1; });
    refused([](macula_picture& p) { p.row_bytes = 4 * kSide - 1; });
    refused([](macula_picture& p) { p.row_bytes = std::numeric_limits<std::uint64_t>::max(); });
    refused([](macula_picture& p) { p.samples_per_pixel = std::numeric_limits<std::uint32_t>::max(); });
    refused([](macula_picture& p) { p.most_noise = std::numeric_limits<double>::quiet_NaN(); });
    refused([](macula_picture& p) { p.lens_mm = -1.0; });
    refused([](macula_picture& p) { p.lens_mm = std::numeric_limits<double>::infinity(); });
    refused([](macula_picture& p) { p.lens_mm = 5.0, p.focus_mm = -200.0; });
    refused([](macula_picture& p) { p.fog_mm = -1.0; });
    refused([](macula_picture& p) { p.fog_mm = std::numeric_limits<double>::quiet_NaN(); });
    refused([](macula_picture& p) { p.denoise = 3; });
    refused([](macula_picture& p) { p.quality = "best"; });
    drawn_.size = 1;
    expectError(draw(), MACULA_USAGE);
    EXPECT_EQ(rgba_, before);
}

TEST_F(CDrawing, ChoicesThatAreNoneAreRefusedAndTheViewStays) {
    macula_view* view = view_.get();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    expectError(macula_view_set_preset(view, "no-such-preset", 0), MACULA_USAGE);
    expectError(macula_view_set_look(view, "xray"), MACULA_USAGE);
    expectError(macula_view_set_lights(view, "moon"), MACULA_USAGE);
    expectError(macula_view_set_window(view, kNan, 1.0), MACULA_USAGE);
    expectError(macula_view_set_window(view, 0.0, -1.0), MACULA_USAGE);
    expectError(macula_view_set_clip(view, "half"), MACULA_USAGE);
    expectError(macula_view_set_direction(view, "above"), MACULA_USAGE);
    expectError(macula_view_set_background(view, "#12345"), MACULA_USAGE);
    const double low[3] = {0.0, 0.0, 0.0};
    const double flat[3] = {10.0, 10.0, 0.0};
    const double none[3] = {10.0, kNan, 10.0};
    expectError(macula_view_set_box(view, low, flat), MACULA_USAGE);
    expectError(macula_view_set_box(view, low, none), MACULA_USAGE);
    expectError(macula_view_set_box(view, low, nullptr), MACULA_USAGE);
    auto camera = sized<macula_camera>();
    expectError(macula_view_set_camera(view, &camera), MACULA_USAGE);
    camera.position_mm[1] = -300.0;
    camera.up[2] = 1.0;
    camera.parallel_height_mm = -5.0;
    expectError(macula_view_set_camera(view, &camera), MACULA_USAGE);
    camera.parallel_height_mm = kNan;
    expectError(macula_view_set_camera(view, &camera), MACULA_USAGE);
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_STREQ(drawn_.preset, "cinematic-bone");
    EXPECT_GT(right(), 3.0 * left());
}

TEST_F(CDrawing, APictureOfNothingSaysWhy) {
    const double low[3] = {500.0, 500.0, 500.0};
    const double high[3] = {600.0, 600.0, 600.0};
    ASSERT_EQ(macula_view_set_box(view_.get(), low, high), MACULA_DONE) << lastError().message;
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_EQ(drawn_.is_empty, 1);
    EXPECT_NE(macula_view_note(view_.get(), 0), nullptr);
}

std::int32_t stopWhileTracing(void*, const char* stage, double fraction) {
    return std::string(stage).starts_with("Tracing") && fraction > 0.0 ? 1 : 0;
}

TEST_F(CDrawing, IsCancelledAndLeavesThePixels) {
    const std::vector<std::uint8_t> before = rgba_;
    picture_.samples_per_pixel = 1 << 20;
    auto progress = sized<macula_progress>();
    progress.told = stopWhileTracing;
    EXPECT_EQ(draw(&progress), MACULA_CANCELLED);
    EXPECT_EQ(rgba_, before);
    EXPECT_EQ(lastError().status, MACULA_CANCELLED);
}

TEST_F(CDrawing, SaysThatItIsDenoised) {
    picture_.denoise = MACULA_DENOISED;
    ASSERT_EQ(draw(), MACULA_DONE);
    EXPECT_EQ(drawn_.is_denoised, 1);
}

// Where things are printed is the host's business.
TEST_F(CDrawing, NothingIsPrinted) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    macula_device* made = nullptr;
    ASSERT_EQ(macula_device_open(nullptr, &made), MACULA_DONE);
    const Owned<macula_device> own(made);
    EXPECT_EQ(macula_draw(made, view_.get(), &picture_, nullptr, nullptr), MACULA_DONE);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(CDevice, ThatIsNotThereIsAnError) {
    macula_device* device = nullptr;
    const macula_status opened = macula_device_open("no such card", &device);
    EXPECT_EQ(device, nullptr);
    expectError(opened, MACULA_USAGE);
    expectError(macula_device_open(nullptr, nullptr), MACULA_USAGE);
}

}  // namespace
}  // namespace macula::test
