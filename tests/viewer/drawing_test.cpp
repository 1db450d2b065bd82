// What a person chooses in the menus: how a study is drawn, and what of it.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <algorithm>

#include "base/phantom.h"
#include "segment/scene.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class DrawingTest : public WindowTest {
  protected:
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    QComboBox& box(const char* accessibleName) {
        for (QComboBox* found : window_->findChildren<QComboBox*>()) {
            if (found->accessibleName() == QLatin1String(accessibleName)) return *found;
        }
        throw std::runtime_error(accessibleName);
    }
    bool isGrey() {
        const QImage picture = middle();
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QRgb p = picture.pixel(x, y);
                if (qRed(p) != qGreen(p) || qGreen(p) != qBlue(p)) return false;
            }
        }
        return true;
    }
    // Half as many slices as those of tests/segment, to be quick.
    static study::OpenedStudy personOnATable() {
        constexpr glm::ivec3 kSize{330, 280, 24};
        constexpr glm::dvec3 kSpacingMm{1.3, 1.3, 5.0};
        static const auto kVolume = std::make_shared<const Volume>(
            segment::test::make(
                {.size = kSize,
                 .worldFromVoxel = affine({kSpacingMm.x, 0, 0}, {0, kSpacingMm.y, 0}, {0, 0, kSpacingMm.z},
                                          -0.5 * glm::dvec3(kSize - 1) * kSpacingMm)})
                .volume);
        return {.volume = kVolume,
                .identity = {.series = Text("Made up"), .isOfNobody = true},
                .description = Text("Made up")};
    }
    bool says(const char* text) const { return window_->fidelity().contains(QLatin1String(text)); }
    bool notes(const char* text) const { return window_->notes().contains(QLatin1String(text)); }
};

// The phantom lies on nothing.
TEST_F(DrawingTest, EachLookIsDrawnAndSaidAndWhatIsNoTableStays) {
    window_->showStudy({.volume = std::make_shared<const Volume>(
                            phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}})),
                        .identity = {.series = Text("Phantom"), .isOfNobody = true},
                        .description = Text("Phantom")});
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(says("Path traced"));
    EXPECT_FALSE(isGrey());
    const QString studio = box("Lights").currentText();
    action("between-voxels-smooth").trigger();
    EXPECT_EQ(window_->state().settings.filter, trace::Filter::smooth);
    window_->session().undo();
    EXPECT_FALSE(action("between-voxels-smooth").isChecked());
    EXPECT_TRUE(action("between-voxels-trilinear").isChecked());
    action("keep-hues").trigger();
    EXPECT_EQ(window_->state().settings.toneMap, trace::ToneMap::hue);
    ASSERT_TRUE(waitUntil([&] { return says("hues kept"); }));
    window_->session().undo();
    EXPECT_FALSE(action("keep-hues").isChecked());

    struct Expected {
        int key;
        trace::Look look;
        const char* said;
        bool hasLights;
        bool hasWindow;
    };
    for (const Expected& expected : {Expected{Qt::Key_2, trace::Look::clear, "clear", true, false},
                                     Expected{Qt::Key_3, trace::Look::dvr, "Ray cast", false, false},
                                     Expected{Qt::Key_5, trace::Look::minip, "Minimum", false, true},
                                     Expected{Qt::Key_6, trace::Look::average, "Average", false, true},
                                     Expected{Qt::Key_4, trace::Look::mip, "Maximum", false, true}}) {
        pressKey(expected.key, Qt::ControlModifier);
        ASSERT_TRUE(waitForConverged()) << expected.said;
        EXPECT_EQ(last_->look, expected.look);
        EXPECT_TRUE(says(expected.said)) << window_->fidelity().toStdString();
        EXPECT_EQ(says("W "), expected.hasWindow);
        EXPECT_EQ(isGrey(), expected.hasWindow);
        EXPECT_EQ(box("Lights").isEnabled(), expected.hasLights);
        // Lights that nobody chose go with the look.
        EXPECT_EQ(box("Lights").currentText() == studio, expected.look != trace::Look::clear);
        EXPECT_EQ(action("keep-hues").isEnabled(), !expected.hasWindow);
        EXPECT_EQ(action("between-voxels-smooth").isEnabled(), !expected.hasWindow);
        EXPECT_EQ(action("shade-ray-cast").isEnabled(), expected.look == trace::Look::dvr);
    }
    const int checked = int(std::count_if(trace::kLooks.begin(), trace::kLooks.end(), [&](const auto& look) {
        return action((std::string("look-") + std::string(look.name)).c_str()).isChecked();
    }));
    EXPECT_EQ(checked, 1);
    EXPECT_TRUE(action("look-mip").isChecked());

    QAction& table = action("remove-table");
    table.trigger();
    ASSERT_TRUE(waitUntil([&] { return !window_->searchingTable(); }));
    EXPECT_FALSE(table.isChecked());
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_TRUE(notes("nothing is left out"));
    EXPECT_FALSE(says("table"));
}

// In a projection, whose picture is the same every time.
TEST_F(DrawingTest, TheTableGoesOnceItIsAskedForAndComesAndGoesAtOnceFromThenOn) {
    QAction& table = action("remove-table");
    EXPECT_FALSE(table.isEnabled());
    window_->showStudy(personOnATable());
    action("look-mip").trigger();
    pressKey(Qt::Key_L);
    ASSERT_TRUE(waitForConverged());
    const QImage whole = middle();
    ASSERT_TRUE(table.isEnabled());

    pressKey(Qt::Key_T, Qt::ControlModifier);
    EXPECT_TRUE(window_->searchingTable());
    EXPECT_FALSE(window_->hidesSomething());
    pressKey(Qt::Key_T, Qt::ControlModifier);  // changed their mind
    EXPECT_FALSE(window_->searchingTable());
    EXPECT_FALSE(table.isChecked());

    pressKey(Qt::Key_T, Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([&] { return !window_->searchingTable(); }));
    EXPECT_TRUE(table.isChecked());
    EXPECT_TRUE(window_->hidesSomething());
    EXPECT_TRUE(notes("The table is left out"));
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(says("table left out"));
    const QImage without = middle();
    EXPECT_FALSE(without == whole);

    table.trigger();
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_FALSE(notes("The table is left out"));
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(says("table left out"));
    EXPECT_EQ(last_->remarks.english().find("table"), std::string::npos);
    table.trigger();
    EXPECT_FALSE(window_->searchingTable());
    EXPECT_TRUE(window_->hidesSomething());
    ASSERT_TRUE(waitForConverged());

    // The next one is whole again; and of what is no CT, the reason is told.
    window_->showStudy(personOnATable());
    EXPECT_FALSE(table.isChecked());
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_FALSE(notes("The table is left out"));
    table.trigger();
    EXPECT_TRUE(window_->searchingTable());
    window_->showStudy(studyThatCannotBeShown());
    EXPECT_FALSE(window_->searchingTable());
    EXPECT_FALSE(table.isEnabled());
    EXPECT_TRUE(table.toolTip().contains(QStringLiteral("CT in Hounsfield units only")));
}

TEST_F(DrawingTest, AClipAndAWindowAreUndoneToTheSamePicture) {
    window_->showStudy(personOnATable());
    action("look-mip").trigger();
    pressKey(Qt::Key_A);
    ASSERT_TRUE(waitForConverged());
    const QImage whole = middle();
    const QString first = window_->fidelity();
    const auto blackPixels = [](const QImage& picture, int fromX, int toX) {
        int black = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = fromX; x < toX; ++x) black += qRed(picture.pixel(x, y)) < 64 ? 1 : 0;
        }
        return black;
    };
    action("clip-left-half").trigger();
    EXPECT_TRUE(window_->hidesSomething());
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(says("clipped"));
    // Seen from the front, the patient's left stays and is at the right.
    const QImage half = middle();
    const int width = half.width();
    EXPECT_EQ(blackPixels(half, 0, width / 2 - 4), (width / 2 - 4) * half.height());
    EXPECT_LT(blackPixels(half, width / 2 + 4, width),
              blackPixels(whole, 0, width) / 2 + width * half.height() / 8);
    pressKey(Qt::Key_U, Qt::ControlModifier);
    EXPECT_TRUE(action("no-clip").isChecked());

    // The right button changes the window, not the distance.
    const double distance = window_->viewport().camera().distanceMm;
    sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::RightButton, Qt::RightButton);
    sendMouse(QEvent::MouseMove, {100, 60}, Qt::NoButton, Qt::RightButton);
    sendMouse(QEvent::MouseButtonRelease, {100, 60}, Qt::RightButton, Qt::NoButton);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(window_->viewport().camera().distanceMm, distance);
    EXPECT_FALSE(says("clipped"));
    EXPECT_NE(window_->fidelity(), first);
    EXPECT_LT(blackPixels(middle(), 0, width), blackPixels(whole, 0, width));
    pressKey(Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(window_->fidelity(), first);
    EXPECT_TRUE(middle() == whole);

    // A preset that somebody chooses gives its range: of this one, 150 to 1500 HU.
    QComboBox& presets = box("Preset");
    Q_EMIT presets.activated(presets.findData(QStringLiteral("cinematic-bone"), Qt::ToolTipRole));
    EXPECT_TRUE(waitUntil([&] { return says("W 1350 L 825 HU"); }));
    action("clip-left-half").trigger();
    window_->showStudy(personOnATable());
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_TRUE(action("no-clip").isChecked());
    EXPECT_FALSE(action("look-mip").isChecked()) << "a look is of the study for which it was chosen";
}

}  // namespace
}  // namespace macula::viewer
