// A study that is opened again, in another window: as it was left, with what was learnt of it.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QTemporaryDir>
#include <chrono>
#include <fstream>
#include <stdexcept>

#include "base/phantom.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class SessionTest : public WindowTest {
  protected:
    SessionTest() { usesModel_ = true; }
    void SetUp() override {
        sessions_ = folder_.filePath(QStringLiteral("sessions")).toStdString();
        WindowTest::SetUp();
    }
    void anotherWindow() {
        window_.reset();  // saves
        origins_.clear();
        makeWindow();
        QObject::connect(&*window_, &MainWindow::frameShown, &*window_,
                         [this](const live::FrameShown& frame) { origins_.push_back(frame.model.origin); });
    }
    bool waitForOrigin(hybrid::ModelOrigin origin) {
        return waitUntil([&] { return !origins_.empty() && origins_.back() == origin; });
    }

    // As the window tells them: "Preview sharpening, 120 steps".
    int steps() const {
        return window_->modelState().section(QLatin1String(", "), 1).section(QLatin1Char(' '), 0, 0).toInt();
    }

    QTemporaryDir folder_;
    std::vector<hybrid::ModelOrigin> origins_;
};

TEST_F(SessionTest, ComesBackAsItWasLeftWithItsModel) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(window_->notes().contains(QLatin1String("as it was left")));
    ASSERT_TRUE(waitUntil([&] { return steps() >= 60; }));
    scene::StudyState left = window_->state();
    left.settings.lightStrength = 1.5;
    left.camera->positionMm += glm::dvec3(40.0, 10.0, 5.0);
    ASSERT_TRUE(window_->setState(left).ok());
    ASSERT_TRUE(waitForConverged());
    ASSERT_TRUE(waitUntil([&] { return steps() >= 60; }));
    const int stepsLeft = steps();

    anotherWindow();
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForOrigin(hybrid::ModelOrigin::stored));
    // No picture of it ever was of a model that began anew.
    EXPECT_EQ(std::count(origins_.begin(), origins_.end(), hybrid::ModelOrigin::points), 0);
    EXPECT_TRUE(window_->notes().contains(QLatin1String("as it was left"))) << window_->notes().toStdString();
    const scene::StudyState now = window_->state();
    EXPECT_EQ(now.settings.lightStrength, 1.5);
    EXPECT_LT(glm::distance(now.camera->positionMm, left.camera->positionMm), 1e-6);
    ASSERT_TRUE(waitForConverged());
    EXPECT_GE(steps(), stepsLeft);

    // And as nobody has left it, which can be undone. What was measured stays.
    window_->session().change(QStringLiteral("Distance"), [](scene::StudyState& next) {
        next.measurements = {
            {.label = {}, .shape = slices::Distance{.endsMm = {glm::dvec3(0.0), glm::dvec3(9.0)}}}};
    });
    window_->findChild<QAction*>(QStringLiteral("show-afresh"))->trigger();
    EXPECT_EQ(window_->state().settings.lightStrength, 1.0);
    EXPECT_EQ(window_->state().measurements.size(), 1u);
    window_->session().undo();
    EXPECT_EQ(window_->state().settings.lightStrength, 1.5);
    window_->session().redo();
    EXPECT_FALSE(window_->notes().contains(QLatin1String("as it was left")));
}

TEST_F(SessionTest, WithoutAPlaceForItTheWindowSaysSoAndIsAsItIsWithout) {
    window_.reset();
    std::ofstream(folder_.filePath(QStringLiteral("file")).toStdString()) << "no folder";
    sessions_ = folder_.filePath(QStringLiteral("file/sessions")).toStdString();
    makeWindow();
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(window_->notes().contains(QLatin1String("essions"))) << window_->notes().toStdString();
    EXPECT_TRUE(window_->message().isEmpty());
}

class SessionStateTest : public SessionTest {
  protected:
    SessionStateTest() { usesModel_ = false; }

    QComboBox& lights() {
        for (QComboBox* box : window_->findChildren<QComboBox*>())
            if (box->accessibleName() == QLatin1String("Lights")) return *box;
        throw std::runtime_error("Lights");
    }
};

TEST_F(SessionStateTest, MenusAndListsShowWhatComesBack) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    const QString usual = lights().currentText();
    ASSERT_FALSE(usual.isEmpty());
    const auto catalogue = scene::builtInCatalogue();
    ASSERT_TRUE(catalogue.ok());
    scene::StudyState left = window_->state();
    for (const auto& rig : catalogue->lights)
        if (rig != scene::defaultLights(*catalogue, trace::Look::cinematic)) left.lights = rig;
    ASSERT_NE(left.lights, nullptr);
    left.settings.look = trace::Look::average;
    ASSERT_TRUE(window_->setState(left).ok());
    const QString chosen = lights().currentText();
    EXPECT_NE(chosen, usual);

    anotherWindow();
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    EXPECT_EQ(window_->state().settings.look, trace::Look::average);
    EXPECT_EQ(lights().currentText(), chosen);
    EXPECT_FALSE(lights().isEnabled()) << "this look has none";
    EXPECT_TRUE(window_->findChild<QAction*>(QStringLiteral("reset-window"))->isEnabled());

    window_->findChild<QAction*>(QStringLiteral("show-afresh"))->trigger();
    EXPECT_EQ(window_->state().settings.look, trace::Look::cinematic);
    EXPECT_EQ(lights().currentText(), usual);
    EXPECT_TRUE(lights().isEnabled());

    // And that is kept, though nobody has chosen anything since.
    anotherWindow();
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    EXPECT_EQ(window_->state().settings.look, trace::Look::cinematic);
    EXPECT_EQ(lights().currentText(), usual);
}

// That of a newer version, say, or one that the disk gave too late.
TEST_F(SessionStateTest, AStateThatIsNotShownStaysAsLongAsNothingIsChanged) {
    window_.reset();
    const auto volume = std::make_shared<const Volume>(phantom::make());
    {
        live::StudyKeeper keeper({.folder = *sessions_}, {});
        keeper.keepState(volume, R"({"version": 2, "later": true})");
    }
    makeWindow();
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(window_->notes().contains(QLatin1String("cannot be read"))) << window_->notes().toStdString();
    window_.reset();
    live::StudyKeeper keeper({.folder = *sessions_}, {});
    const auto left = keeper.stateOf(volume, std::chrono::minutes(1));
    ASSERT_TRUE(left);
    EXPECT_NE(left->find("later"), std::string::npos);
    EXPECT_EQ(left->find("look"), std::string::npos);
}

}  // namespace
}  // namespace macula::viewer
