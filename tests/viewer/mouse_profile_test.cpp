// What the buttons of the mouse do on slices, in each profile.
#include "viewer/settings/mouse_profile.h"

#include <gtest/gtest.h>

#include "viewer/slice_view_fixture.h"

namespace macula::viewer {
namespace {

class MouseProfileTest : public SliceViewTest {
  protected:
    ~MouseProfileTest() override { useMouseProfile({}); }
};

TEST_F(MouseProfileTest, WindowLeftStillSetsTheCrossHairByAClick) {
    useMouseProfile(QStringLiteral("window"));
    showStudy();
    const auto view = pane(slices::Orientation::axial);
    const glm::dvec3 before = crosshair();
    drag(*view, Qt::LeftButton, {200, 200}, {240, 200});
    EXPECT_TRUE(state().slices.window) << "the left button sets the window";
    EXPECT_EQ(crosshair(), before);
    click(*view, {150, 150});
    EXPECT_NE(crosshair(), before);
    const auto window = state().slices.window;
    drag(*view, Qt::RightButton, {200, 200}, {200, 150});
    EXPECT_EQ(state().slices.window, window) << "the right one zooms";
    view->setTool(SliceTool::distance);
    drag(*view, Qt::LeftButton, {150, 200}, {250, 200});
    EXPECT_EQ(state().measurements.size(), 1u) << "a tool keeps the left button";
}

TEST_F(MouseProfileTest, SlicesLeftScrollsByImages) {
    useMouseProfile(QStringLiteral("scroll"));
    showStudy();
    const auto view = pane(slices::Orientation::axial);
    const double before = crosshair().z;
    drag(*view, Qt::LeftButton, {200, 200}, {200, 200 + int(3 * kScrollPx)});
    const double after = crosshair().z;
    EXPECT_NE(after, before);
    drag(*view, Qt::LeftButton, {200, 200}, {200, 200 - int(3 * kScrollPx)});
    EXPECT_NEAR(crosshair().z, before, 1e-9) << "as far back";
    drag(*view, Qt::MiddleButton, {200, 200}, {240, 200});
    EXPECT_TRUE(state().slices.window);
}

TEST(MouseProfiles, OfAnUnknownNameIsTheFirst) {
    useMouseProfile(QStringLiteral("nobody's"));
    EXPECT_EQ(&mouseProfile(), &kMouseProfiles.front());
    for (const MouseProfile& each : kMouseProfiles) {
        useMouseProfile(QLatin1String(each.name));
        EXPECT_EQ(&mouseProfile(), &each);
    }
    useMouseProfile({});
    EXPECT_EQ(&mouseProfile(), &kMouseProfiles.front());
}

}  // namespace
}  // namespace macula::viewer
