// The quality slider alone, with hands on it, and what is told of converging.
#include "viewer/quality/quality_control.h"

#include <gtest/gtest.h>

#include <QTest>
#include <limits>
#include <vector>

#include "viewer/offscreen.h"
#include "viewer/quality/quality_controller.h"

namespace macula::viewer {
namespace {

class QualityControlTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        const auto front = live::builtInQualityFront();
        ASSERT_TRUE(front.ok());
        control_.emplace(*front);
        QObject::connect(&*control_, &QualityControl::changed, &*control_,
                         [this](const live::LiveQuality& quality) { told_.push_back(quality); });
    }
    void TearDown() override {
        control_.reset();
        OffscreenTest::TearDown();
    }
    QSlider& slider() { return *control_->findChild<QSlider*>(QStringLiteral("quality-slider")); }
    QCheckBox& automatic() { return *control_->findChild<QCheckBox*>(QStringLiteral("quality-automatic")); }

    std::optional<QualityControl> control_;
    std::vector<live::LiveQuality> told_;
};

TEST_F(QualityControlTest, ByItselfItChangesNothing) {
    control_->setSlowness(2.0);
    control_->setView({.sizePx = {800, 600}, .verticalFovDeg = 30.0});
    EXPECT_FALSE(control_->stop());
    EXPECT_TRUE(automatic().isChecked());
    EXPECT_TRUE(told_.empty());
    // Wherever the slider stands meanwhile.
    EXPECT_EQ(control_->text(), QStringLiteral("Quality: automatic"));
    EXPECT_TRUE(control_->words().startsWith(QStringLiteral("Automatic"))) << control_->words().toStdString();
    control_->setStop(0);
    EXPECT_FALSE(control_->text().contains(QStringLiteral("automatic")));
    EXPECT_FALSE(control_->words().contains(QStringLiteral("Automatic")));
    control_->setStop(std::nullopt);
    told_.clear();
}

TEST_F(QualityControlTest, EachStopIsToldAndSaysWhatItCosts) {
    control_->setSlowness(1.0);
    control_->setView({.sizePx = {128, 128}, .verticalFovDeg = 40.0});
    const auto& stops = control_->front().stops;
    EXPECT_EQ(slider().minimum(), 0);
    EXPECT_EQ(slider().maximum(), int(stops.size()) - 1);
    QString before;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        slider().setValue(int(i));
        control_->setStop(i);  // the slider may have stood there already
        ASSERT_EQ(control_->stop(), i);
        EXPECT_FALSE(automatic().isChecked());
        EXPECT_NE(control_->words(), before);
        before = control_->words();
        EXPECT_TRUE(before.contains(QString::number(stops[i].fovealFlip, 'f', 3))) << before.toStdString();
    }
    ASSERT_EQ(told_.size(), stops.size());
    EXPECT_FALSE(told_.front().hasFovea);
    EXPECT_EQ(told_.back().fovea, stops.back().fovea->request);
    automatic().setChecked(true);
    EXPECT_FALSE(control_->stop());
    EXPECT_EQ(told_.back(), live::LiveQuality());
}

TEST_F(QualityControlTest, KeysGoStepByStepAndStopAtTheEnds) {
    control_->setSlowness(1.0);
    control_->step(1);
    ASSERT_TRUE(control_->stop());
    for (int i = 0; i < 30; ++i) control_->step(1);
    EXPECT_EQ(control_->stop(), control_->front().stops.size() - 1);
    for (int i = 0; i < 30; ++i) control_->step(-1);
    EXPECT_EQ(control_->stop(), 0u);
}

TEST_F(QualityControlTest, TimesAreThoseOfThisMachineAndBouncesAreSaid) {
    control_->setStop(2);
    EXPECT_TRUE(control_->words().contains(QStringLiteral("being measured")));
    control_->setSlowness(1.0);
    const QString fast = control_->words();
    control_->setSlowness(10.0);
    EXPECT_NE(control_->words(), fast);
    control_->setSlowness(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(control_->slowness());
    EXPECT_FALSE(control_->words().contains(QStringLiteral("bounces")));
    control_->setBounces(8);
    EXPECT_TRUE(control_->words().contains(QStringLiteral("8 at every stop")));
    control_->setBounces(control_->front().bounces);
    EXPECT_FALSE(control_->words().contains(QStringLiteral("bounces")));
}

TEST_F(QualityControlTest, AllOfItHasANameAndATip) {
    for (QWidget* widget : {static_cast<QWidget*>(&*control_), static_cast<QWidget*>(&slider())}) {
        EXPECT_FALSE(widget->accessibleName().isEmpty());
        EXPECT_FALSE(widget->toolTip().isEmpty());
    }
    EXPECT_FALSE(automatic().toolTip().isEmpty());
}

class ConvergeNowTest : public testing::Test {
  protected:
    ConvergeNowTest() : converge_({.sampleLimit = 512}, nullptr, [this] { return nowS_; }) {
        QObject::connect(&converge_, &ConvergeNow::goalChanged, &converge_,
                         [this](const RestGoal& goal) { goals_.push_back(goal); });
        QObject::connect(&converge_, &ConvergeNow::progressed, &converge_,
                         [this](const QString& stage, double fraction) {
                             stage_ = stage;
                             fraction_ = fraction;
                         });
        QObject::connect(&converge_, &ConvergeNow::ended, &converge_,
                         [this](const QString& told) { ended_.push_back(told); });
    }
    static live::FrameShown frame(double noise, live::Stage stage = live::Stage::converging) {
        live::FrameShown shown;
        shown.picture = live::OnScreen::traced;
        shown.stage = stage;
        shown.samplesPerPixel = 100;
        shown.noise = noise;
        shown.noiseTarget = ConvergeNow::kNoiseTarget;
        return shown;
    }

    double nowS_ = 0.0;
    std::vector<RestGoal> goals_;
    std::vector<QString> ended_;
    QString stage_;
    double fraction_ = -1.0;
    ConvergeNow converge_;
};

TEST_F(ConvergeNowTest, TellsHowFarItIsAndHowLongItTakes) {
    converge_.onFrame(frame(0.1));
    EXPECT_TRUE(goals_.empty()) << "nobody asked";
    converge_.start();
    ASSERT_EQ(goals_.size(), 1u);
    EXPECT_TRUE(goals_[0].convergesNow);
    EXPECT_LT(goals_[0].noiseTarget, live::kUnseenNoise);
    EXPECT_GT(goals_[0].sampleLimit, 512u);
    live::FrameShown early = frame(0.1, live::Stage::converged);
    early.noiseTarget = live::kUnseenNoise;
    converge_.onFrame(early);
    EXPECT_TRUE(converge_.running()) << "a frame of before";
    converge_.onFrame(frame(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(stage_.contains(QStringLiteral("left")));
    converge_.onFrame(frame(10.0 * ConvergeNow::kNoiseTarget));  // a hundredth
    nowS_ = 10.0;
    converge_.onFrame(frame(2.0 * ConvergeNow::kNoiseTarget));  // a quarter
    EXPECT_NEAR(fraction_, 0.25, 1e-9);
    EXPECT_TRUE(stage_.contains(QStringLiteral("32 s left"))) << stage_.toStdString();
    converge_.onFrame(frame(0.9 * ConvergeNow::kNoiseTarget, live::Stage::converged));
    EXPECT_FALSE(converge_.running());
    ASSERT_EQ(ended_.size(), 1u);
    EXPECT_TRUE(ended_[0].contains(QStringLiteral("final")));
    EXPECT_EQ(goals_.back(), RestGoal{.sampleLimit = 512});
}

TEST_F(ConvergeNowTest, EndsWhenSomebodyStopsItOrSomethingElseIsShown) {
    converge_.cancel();
    converge_.onOtherPicture();
    EXPECT_TRUE(ended_.empty());
    converge_.start();
    converge_.start();
    EXPECT_EQ(goals_.size(), 1u);
    converge_.cancel();
    ASSERT_EQ(ended_.size(), 1u);
    EXPECT_TRUE(ended_[0].isEmpty());
    EXPECT_FALSE(goals_.back().convergesNow);
    converge_.start();
    live::FrameShown model = frame(1.0);
    model.picture = live::OnScreen::model;
    converge_.onFrame(model);
    EXPECT_TRUE(converge_.running());
    converge_.onOtherPicture();
    EXPECT_FALSE(ended_.back().isEmpty());
    EXPECT_FALSE(converge_.running());
}

}  // namespace
}  // namespace macula::viewer
