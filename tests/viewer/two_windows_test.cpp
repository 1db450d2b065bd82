// What a person has measured is not lost: by a second window on the study, or by a program that is ended.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <chrono>
#include <memory>

#include "base/phantom.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class TwoWindowsTest : public WindowTest {
  protected:
    void SetUp() override {
        sessions_ = folder_.filePath(QStringLiteral("sessions")).toStdString();
        WindowTest::SetUp();
    }
    static void measure(MainWindow& window, double lengthMm) {
        window.session().change(QStringLiteral("Distance"), [&](scene::StudyState& next) {
            next.measurements.push_back(
                {.label = {},
                 .shape = slices::Distance{.endsMm = {glm::dvec3(0.0), glm::dvec3(lengthMm, 0.0, 0.0)}}});
        });
    }
    static bool openPhantom(MainWindow& window) {
        window.open(std::nullopt);
        return waitUntil([&] { return window.hasStudy() && !window.loading(); });
    }
    std::unique_ptr<MainWindow> secondWindow() const {
        auto instance = createInstanceForWindows();
        if (!instance) return nullptr;
        auto window = std::make_unique<MainWindow>(*std::move(instance), windowOptions());
        window->show();
        return window;
    }

    QTemporaryDir folder_;
};

TEST_F(TwoWindowsTest, OnOneStudyKeepWhatWasMeasuredInEither) {
    auto second = secondWindow();
    ASSERT_NE(second, nullptr);
    ASSERT_TRUE(openPhantom(*window_));
    ASSERT_TRUE(openPhantom(*second));
    measure(*window_, 10.0);
    ASSERT_TRUE(window_->keepStateNow());
    measure(*second, 20.0);
    ASSERT_TRUE(second->keepStateNow());
    EXPECT_TRUE(waitUntil([&] { return second->notes().contains(QStringLiteral("another window")); }))
        << second->notes().toStdString();
    measure(*window_, 30.0);
    window_.reset();
    second.reset();  // the last

    makeWindow();
    ASSERT_TRUE(openPhantom(*window_));
    std::vector<double> lengths;
    for (const slices::Measurement& each : window_->state().measurements)
        lengths.push_back(slices::lengthMm(std::get<slices::Distance>(each.shape)));
    std::ranges::sort(lengths);
    EXPECT_EQ(lengths, (std::vector{10.0, 20.0, 30.0}));
}

// As SIGTERM and a desktop that logs out have it, while the window lives.
TEST_F(TwoWindowsTest, WhatWasMeasuredJustNowIsKeptWhenTheProgramIsAskedToEnd) {
    ASSERT_TRUE(openPhantom(*window_));
    measure(*window_, 10.0);
    ASSERT_TRUE(window_->keepStateNow());
    live::StudyKeeper other({.folder = *sessions_}, {});
    const auto left = other.stateOf(std::make_shared<const Volume>(phantom::make()), std::chrono::minutes(1));
    ASSERT_TRUE(left);
    const auto state = scene::studyStateFromJson(*left, {});
    ASSERT_TRUE(state.ok());
    EXPECT_EQ(state->measurements, window_->state().measurements);
}

// And by itself, soon after each change: nobody asks before a SIGKILL.
TEST_F(TwoWindowsTest, WhatWasMeasuredIsKeptByItself) {
    ASSERT_TRUE(openPhantom(*window_));
    measure(*window_, 10.0);
    live::StudyKeeper other({.folder = *sessions_}, {});
    const auto volume = std::make_shared<const Volume>(phantom::make());
    EXPECT_TRUE(waitUntil([&] {
        const auto left = other.stateOf(volume, std::chrono::minutes(1));
        return left && left->find("measurements") != std::string::npos;
    }));
}

}  // namespace
}  // namespace macula::viewer
