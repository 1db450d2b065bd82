// The panel of lights and their handles, with hands on them, against a session.
#include "viewer/lights/lights_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLocale>
#include <QTest>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/phantom.h"
#include "scene/choice/lights_choice.h"
#include "viewer/lights/lights_editing.h"

namespace macula::viewer {
namespace {

using trace::LightFrame;

class LightsPanelTest : public testing::Test {
  protected:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        QLocale::setDefault(QLocale::c());
        application_.emplace(argc_, argv_);
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok()) << catalogue.error().message;
        session_.emplace(*std::move(catalogue));
        editing_.emplace(*session_);
        editing_->setCamera(fromAnterior().camera);
        panel_.emplace(*session_, *editing_);
        tool_.emplace(*session_, *editing_);
        panel_->QWidget::show();
        editing_->setPanelOpen(true);
        session_->show({.volume = std::make_shared<const Volume>(
                            phantom::make({.size = {24, 20, 16}, .spacingMm = {12, 12, 18}}))},
                       {});
    }
    void TearDown() override {
        tool_.reset();
        panel_.reset();
        editing_.reset();
        session_.reset();
        application_.reset();
    }

    static PictureGeometry fromAnterior() {
        return {.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}},
                .aspect = 1.25,
                .sizePx = {1000, 800}};
    }
    static PicturePlace at(const glm::dvec2& place) { return {.picture = fromAnterior(), .at = place}; }
    glm::dvec2 placeOf(std::size_t light) const {
        const scene::LightStand stand = *editing_->stand(fromAnterior().camera);
        return scene::placeOnDome(scene::directionTo(rig().lights[light], stand), stand.eye, 1.25);
    }

    template <class Widget>
    Widget& find(const char* name) {
        auto* found = panel_->findChild<Widget*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void type(const char* name, const QString& text) {
        auto& box = find<QDoubleSpinBox>(name);
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }
    void click(const char* name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }

    const trace::LightRig& rig() const { return *editing_->rig(); }
    const scene::StudyState& state() const { return session_->state(); }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
    std::optional<LightsEditing> editing_;
    std::optional<LightsPanel> panel_;
    std::optional<LightsTool> tool_;
};

TEST_F(LightsPanelTest, ShowsTheUsualLightsAndChangesNothingByItself) {
    EXPECT_EQ(state().lights, nullptr);
    EXPECT_EQ(rig().name, scene::kDefaultLights);
    EXPECT_EQ(find<QComboBox>("lights-light").count(), int(rig().lights.size()));
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(LightsPanelTest, ANumberMakesAnOwnRigInOneStep) {
    const trace::LightRig before = rig();
    type("lights-azimuth", QStringLiteral("-75"));
    ASSERT_NE(state().lights, nullptr);
    EXPECT_EQ(rig().name, scene::kOwnLightsName);
    EXPECT_EQ(rig().lights[0].azimuthDeg, -75.0);
    EXPECT_EQ(rig().lights[0].elevationDeg, before.lights[0].elevationDeg);
    EXPECT_EQ(rig().lights[1], before.lights[1]);
    EXPECT_EQ(find<QComboBox>("lights-rig").currentIndex(), -1);  // none of the list
    session_->undo();
    EXPECT_EQ(rig(), before);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(LightsPanelTest, AHandleIsDraggedToWhereItShinesFrom) {
    ASSERT_TRUE(tool_->press(at(placeOf(1))));
    EXPECT_EQ(editing_->chosen(), 1U);
    tool_->move(at({0.1, 0.1}));
    tool_->move(at(scene::circleOnDome(90.0, 0.0, 1.25)));
    tool_->release(at(scene::circleOnDome(90.0, 0.0, 1.25)));
    EXPECT_NEAR(rig().lights[1].azimuthDeg, 90.0,
                0.5);  // from the patient's left, at the right of the picture
    EXPECT_NEAR(rig().lights[1].elevationDeg, 0.0, 0.5);
    session_->undo();
    EXPECT_FALSE(session_->canUndo());  // the drag was one step
    EXPECT_EQ(state().lights, nullptr);
}

TEST_F(LightsPanelTest, WhoOnlyChoosesALightChangesNothing) {
    ASSERT_TRUE(tool_->press(at(placeOf(1))));
    tool_->release(at(placeOf(1)));
    EXPECT_EQ(editing_->chosen(), 1U);
    EXPECT_TRUE(editing_->drag(*editing_->light()).ok());
    EXPECT_EQ(state().lights, nullptr);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(LightsPanelTest, ACancelledColourLeavesTheLightsThatWere) {
    click("lights-colour");
    auto* dialog = panel_->findChild<QColorDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setCurrentColor(Qt::green);
    EXPECT_NE(state().lights, nullptr);
    dialog->reject();
    EXPECT_EQ(state().lights, nullptr);
}

TEST_F(LightsPanelTest, HandlesFollowTheRotationOfAllLights) {
    type("lights-turned", QStringLiteral("40"));
    EXPECT_EQ(state().settings.lightRotationDeg, 40.0);
    ASSERT_TRUE(tool_->press(at(placeOf(0))));
    tool_->release(at({0.0, 0.0}));
    EXPECT_NEAR(std::remainder(rig().lights[0].azimuthDeg + 40.0, 360.0), 0.0, 0.5);
}

TEST_F(LightsPanelTest, AMarkForEachLightAndNoneWithoutThePanel) {
    const auto count = [&](MarkKind kind) {
        const std::vector<ToolMark> marks = tool_->marks(fromAnterior());
        return std::size_t(std::count_if(marks.begin(), marks.end(),
                                         [&](const ToolMark& mark) { return mark.kind == kind; }));
    };
    EXPECT_EQ(count(MarkKind::heldHandle), 1U);
    EXPECT_EQ(count(MarkKind::freeHandle), rig().lights.size() - 1);
    editing_->setPanelOpen(false);
    EXPECT_TRUE(tool_->marks(fromAnterior()).empty());
    EXPECT_FALSE(tool_->press(at(placeOf(0))));
}

TEST_F(LightsPanelTest, ShiftAndTheWheelChangeTheStrength) {
    const double before = rig().lights[0].radiance;
    EXPECT_TRUE(tool_->turnWheel(1.0, fromAnterior()));
    EXPECT_TRUE(tool_->turnWheel(1.0, fromAnterior()));
    EXPECT_NEAR(rig().lights[0].radiance, before * 1.21, 1e-9);
    session_->undo();
    EXPECT_EQ(rig().lights[0].radiance, before);
}

TEST_F(LightsPanelTest, LightsAreAddedAndRemoved) {
    const std::size_t before = rig().lights.size();
    click("lights-add");
    ASSERT_EQ(rig().lights.size(), before + 1);
    EXPECT_EQ(editing_->chosen(), before);
    const glm::dvec3 from = scene::directionTo(rig().lights.back(), *editing_->stand(fromAnterior().camera));
    EXPECT_LT(from.x, 0.0);  // above the viewer's left shoulder
    EXPECT_LT(from.y, 0.0);
    EXPECT_GT(from.z, 0.0);
    click("lights-remove");
    EXPECT_EQ(rig().lights.size(), before);
}

TEST_F(LightsPanelTest, WhatWouldBeBlackIsRefusedAndSaid) {
    type("lights-sky", QStringLiteral("0"));
    while (rig().lights.size() > 1) click("lights-remove");
    click("lights-remove");
    EXPECT_EQ(rig().lights.size(), 1U);
    EXPECT_FALSE(find<QLabel>("lights-trouble").text().isEmpty());
}

TEST_F(LightsPanelTest, LightsKeepToTheCamera) {
    auto& frames = find<QComboBox>("lights-frame");
    const glm::dvec2 before = placeOf(0);
    frames.setCurrentIndex(1);
    Q_EMIT frames.activated(1);
    EXPECT_EQ(rig().frame, LightFrame::camera);
    EXPECT_LT(glm::length(placeOf(0) - before), 1e-9);
}

TEST_F(LightsPanelTest, LooksWithoutLightsHaveNone) {
    session_->change(QStringLiteral("Look"),
                     [](scene::StudyState& next) { next.settings.look = trace::Look::mip; });
    EXPECT_FALSE(find<QDoubleSpinBox>("lights-azimuth").isEnabled());
    EXPECT_FALSE(find<QPushButton>("lights-meter").isEnabled());
    EXPECT_TRUE(tool_->marks(fromAnterior()).empty());
    EXPECT_FALSE(editing_->add().ok());
}

TEST_F(LightsPanelTest, ExposureIsOneOfItsNumbers) {
    type("lights-exposure", QStringLiteral("2.5"));
    EXPECT_EQ(state().settings.exposure, 2.5);
    session_->undo();
    EXPECT_EQ(state().settings.exposure, 1.0);
}

}  // namespace
}  // namespace macula::viewer
