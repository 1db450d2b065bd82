// The live picture of the C interface, and its model: frame by frame, trained, kept and resumed.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "c/c_fixture.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 48;
constexpr std::uint64_t kStepsToBeShown = 120;  // of a model, as docs/python.md has it

class CLive : public ::testing::Test {
  protected:
    static const macula_device* device() { return testDevice(); }

    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "macula-live-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        store_ = folder_ / "store";
        const auto study = TwoBalls().study();
        view_ = viewOf(study);
        ASSERT_NE(view_, nullptr);
        frame_ = sized<macula_frame>();
        frame_.width = frame_.height = kSide;
        frame_.rgba = rgba_.data();
        frame_.bytes = rgba_.size();
    }
    void TearDown() override { fs::remove_all(folder_); }

    Owned<macula_live> open(std::int32_t model = MACULA_WITH_MODEL) {
        const std::string store = store_.string();
        auto options = sized<macula_live_options>();
        options.model = model;
        options.store = store.c_str();
        macula_live* live = nullptr;
        EXPECT_EQ(macula_live_open(device(), view_.get(), &options, nullptr, &live), MACULA_DONE)
            << lastError().message;
        return Owned<macula_live>(live);
    }
    macula_status draw(const Owned<macula_live>& live) {
        return macula_live_frame(live.get(), &frame_, nullptr, &shown_);
    }
    // Whether a picture came to that within a minute or so; a machine may be slow.
    template <class IsDone>
    bool drawUntil(const Owned<macula_live>& live, const IsDone& isDone) {
        frame_.for_about_ms = 100.0;
        for (int i = 0; i < 600; ++i) {
            if (draw(live) != MACULA_DONE) {
                ADD_FAILURE() << lastError().message;
                return false;
            }
            if (isDone()) return true;
        }
        return false;
    }
    // More than the background has.
    double light(int first, int last) const {
        constexpr int kBackground = 8;
        double sum = 0.0;
        for (int y = 0; y < kSide; ++y)
            for (int x = first; x < last; ++x)
                for (int channel = 0; channel < 3; ++channel)
                    sum += std::max(rgba_[std::size_t(4 * (y * kSide + x) + channel)] - kBackground, 0);
        return sum;
    }
    double left() const { return light(0, kSide / 2); }
    double right() const { return light(kSide / 2, kSide); }

    fs::path folder_;
    fs::path store_;
    Owned<macula_view> view_;
    std::vector<std::uint8_t> rgba_ = std::vector<std::uint8_t>(4 * kSide * kSide, 7);
    macula_frame frame_{};
    macula_shown shown_ = sized<macula_shown>();
};

TEST_F(CLive, TheFirstFrameIsThereAndThePatientIsNotMirrored) {
    const auto live = open(MACULA_WITHOUT_MODEL);
    ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;
    EXPECT_EQ(shown_.is_new, 1);
    EXPECT_NE(shown_.picture, 0);
    EXPECT_STRNE(shown_.device, "");
    EXPECT_LT(shown_.camera.position_mm[1], 0.0) << "before the patient: +y is posterior";
    EXPECT_GT(right(), 3.0 * left());
    for (std::size_t i = 3; i < rgba_.size(); i += 4) ASSERT_EQ(rgba_[i], 255);

    macula_camera behind = shown_.camera;
    behind.position_mm[1] = -behind.position_mm[1];
    frame_.camera = &behind;
    frame_.is_moving = 1;
    ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;
    EXPECT_EQ(shown_.is_final, 0);
    EXPECT_STRNE(shown_.fidelity, "") << "a hand moves: it is said what the picture is worth";
    EXPECT_GT(left(), 3.0 * right());
}

TEST_F(CLive, AtRestItBecomesFinalAndStaysSo) {
    ASSERT_EQ(macula_view_set_look(view_.get(), "dvr"), MACULA_DONE);
    const auto live = open(MACULA_WITHOUT_MODEL);
    ASSERT_TRUE(drawUntil(live, [&] { return shown_.is_final != 0; }));
    EXPECT_EQ(shown_.picture, MACULA_SHOWN_TRACED);
    const std::vector<std::uint8_t> before = rgba_;
    std::ranges::fill(rgba_, std::uint8_t(7));
    ASSERT_EQ(draw(live), MACULA_DONE);
    EXPECT_EQ(shown_.is_new, 0);
    EXPECT_EQ(rgba_, before) << "the pixels come each time";
}

TEST_F(CLive, AnotherViewIsShownFromThenOn) {
    const auto live = open(MACULA_WITHOUT_MODEL);
    ASSERT_EQ(draw(live), MACULA_DONE);
    ASSERT_EQ(macula_view_set_direction(view_.get(), "posterior"), MACULA_DONE);
    ASSERT_EQ(macula_live_show(live.get(), view_.get(), nullptr), MACULA_DONE) << lastError().message;
    ASSERT_EQ(draw(live), MACULA_DONE);
    EXPECT_GT(left(), 3.0 * right());
    const double low[3] = {-48.0, -48.0, -48.0};
    const double high[3] = {0.0, 48.0, 48.0};  // the patient's right half
    ASSERT_EQ(macula_view_set_box(view_.get(), low, high), MACULA_DONE);
    ASSERT_EQ(macula_live_show(live.get(), view_.get(), nullptr), MACULA_DONE);
    macula_camera camera = shown_.camera;
    frame_.camera = &camera;
    ASSERT_EQ(draw(live), MACULA_DONE);
    EXPECT_GT(right(), 3.0 * left());
}

TEST_F(CLive, ATrainedModelIsDrawnWhileAHandMovesAndIsResumed) {
    auto model = sized<macula_model>();
    std::uint64_t steps = 0;
    {
        const auto live = open();
        ASSERT_EQ(macula_live_model(live.get(), &model), MACULA_DONE);
        EXPECT_EQ(model.stage, MACULA_MODEL_NONE);
        EXPECT_TRUE(std::isnan(model.error));
        expectError(macula_live_save(live.get(), nullptr), MACULA_INPUT);  // nothing to keep yet

        const char* times = nullptr;
        ASSERT_EQ(macula_live_times(live.get(), &times), MACULA_DONE) << lastError().message;
        EXPECT_NE(std::string(times).find("\"stage\""), std::string::npos) << times;
        expectError(macula_live_times(live.get(), nullptr), MACULA_USAGE);

        auto training = sized<macula_training>();
        training.steps = 6;
        ASSERT_EQ(macula_live_train(live.get(), &training, nullptr, &model), MACULA_DONE)
            << lastError().message;
        EXPECT_EQ(model.is_resumed, 0);
        EXPECT_GT(model.splats, 0u);
        EXPECT_GE(model.steps, 6u);
        EXPECT_STRNE(model.origin, "");

        // Until it is sharp enough an estimate is shown, and that is said.
        frame_.is_moving = 1;
        ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;
        if (model.steps < kStepsToBeShown) {
            EXPECT_EQ(shown_.picture, MACULA_SHOWN_MODEL);
            EXPECT_NE(std::string(shown_.fidelity).find("estimated"), std::string::npos) << shown_.fidelity;
        }
        training.steps = kStepsToBeShown;
        ASSERT_EQ(macula_live_train(live.get(), &training, nullptr, &model), MACULA_DONE)
            << lastError().message;
        EXPECT_GE(model.steps, kStepsToBeShown);
        steps = model.steps;
        ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;
        EXPECT_EQ(shown_.picture, MACULA_SHOWN_MODEL);
        EXPECT_NE(std::string(shown_.fidelity).find("preview"), std::string::npos) << shown_.fidelity;
        EXPECT_GT(right(), 3.0 * left());

        ASSERT_EQ(macula_live_save(live.get(), nullptr), MACULA_DONE) << lastError().message;
        const std::string file = (folder_ / "model.macula").string();
        ASSERT_EQ(macula_live_write_model(live.get(), file.c_str(), 0, nullptr), MACULA_DONE)
            << lastError().message;
        EXPECT_GT(fs::file_size(file), 1000u);
        expectError(macula_live_write_model(live.get(), file.c_str(), 0, nullptr), MACULA_OUTPUT);
        expectError(macula_live_write_model(live.get(), (file + ".txt").c_str(), 0, nullptr), MACULA_USAGE);
    }
    const auto live = open();
    auto training = sized<macula_training>();
    training.steps = 1;
    ASSERT_EQ(macula_live_train(live.get(), &training, nullptr, &model), MACULA_DONE) << lastError().message;
    EXPECT_EQ(model.is_resumed, 1) << model.origin;
    EXPECT_GT(model.steps, steps);
}

std::int32_t stopAtOnce(void*, const char*, double) {
    return 1;
}

TEST_F(CLive, IsCancelledAndLeavesThePixels) {
    const auto live = open();
    const std::vector<std::uint8_t> before = rgba_;
    auto progress = sized<macula_progress>();
    progress.told = stopAtOnce;
    EXPECT_EQ(macula_live_frame(live.get(), &frame_, &progress, &shown_), MACULA_CANCELLED);
    EXPECT_EQ(rgba_, before);
    EXPECT_EQ(macula_live_train(live.get(), nullptr, &progress, nullptr), MACULA_CANCELLED);
    ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;  // it goes on afterwards
    EXPECT_GT(right(), 3.0 * left());
}

TEST_F(CLive, WhatCannotBeTrainedSaysWhy) {
    const auto without = open(MACULA_WITHOUT_MODEL);
    expectError(macula_live_train(without.get(), nullptr, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_live_save(without.get(), nullptr), MACULA_USAGE);
    ASSERT_EQ(macula_view_set_look(view_.get(), "mip"), MACULA_DONE);
    const auto mip = open();
    expectError(macula_live_train(mip.get(), nullptr, nullptr, nullptr), MACULA_USAGE);
}

TEST_F(CLive, AStoreThatIsNoneIsTold) {
    const std::string file = (folder_ / "file").string();
    std::fclose(std::fopen(file.c_str(), "w"));
    store_ = file;
    const auto live = open();
    ASSERT_EQ(draw(live), MACULA_DONE) << lastError().message;  // the picture goes on without
    ASSERT_NE(macula_live_note(live.get(), 0), nullptr);
}

TEST_F(CLive, FramesThatAreNoneAreRefused) {
    const auto live = open(MACULA_WITHOUT_MODEL);
    const auto refused = [&](const auto& change) {
        const macula_frame good = frame_;
        change(frame_);
        expectError(draw(live), MACULA_USAGE);
        frame_ = good;
    };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    refused([](macula_frame& f) { f.size = 0; });
    refused([](macula_frame& f) { f.width = 0; });
    refused([](macula_frame& f) { f.height = 16385; });
    refused([](macula_frame& f) { f.bytes -= 1; });
    refused([](macula_frame& f) { f.row_bytes = 4; });
    refused([=](macula_frame& f) { f.gaze[1] = kNan; });
    refused([=](macula_frame& f) { f.for_about_ms = kNan; });
    refused([](macula_frame& f) { f.for_about_ms = -1.0; });
    auto camera = sized<macula_camera>();
    refused([&](macula_frame& f) { f.camera = &camera; });
    auto image = sized<macula_lent_image>();
    refused([&](macula_frame& f) { f.image = &image; });
    shown_.size = 1;
    expectError(draw(live), MACULA_USAGE);
    expectError(macula_live_frame(live.get(), nullptr, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_live_frame(nullptr, &frame_, nullptr, nullptr), MACULA_USAGE);
    auto training = sized<macula_training>();
    training.seconds = kNan;
    expectError(macula_live_train(live.get(), &training, nullptr, nullptr), MACULA_USAGE);
    auto options = sized<macula_live_options>();
    options.model = 2;
    macula_live* none = nullptr;
    expectError(macula_live_open(device(), view_.get(), &options, nullptr, &none), MACULA_USAGE);
    EXPECT_EQ(none, nullptr);
    macula_live_close(nullptr);
}

}  // namespace
}  // namespace macula::test
