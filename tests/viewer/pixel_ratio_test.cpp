// A screen of two device pixels to a logical one: what is drawn has the pixels of the screen, and no fewer.
#include <QIcon>
#include <QPixmap>
#include <QPushButton>

#include "viewer/covered_by.h"
#include "viewer/editor/study_editor.h"
#include "viewer/offscreen.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/slices/slice_view.h"
#include "viewer/theme/drawn_icon.h"
#include "viewer/theme/theme.h"
#include "viewer/transfer/point_fields.h"

namespace macula::viewer {
namespace {

class PixelRatioTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        setenv("QT_SCALE_FACTOR", "2", 1);
        OffscreenTest::SetUp();
        applyTheme(*application_, {});
        session_.emplace(scene::Catalogue{});
    }
    void TearDown() override {
        session_.reset();
        OffscreenTest::TearDown();
        unsetenv("QT_SCALE_FACTOR");
    }

    std::optional<StudyEditor> session_;
};

TEST_F(PixelRatioTest, ASliceIsSampledForEachPixelOfTheScreen) {
    session_->show(smallStudy(), {});
    SliceView view(*session_, slices::Orientation::axial);
    view.resize(200, 150);
    view.show();
    ASSERT_DOUBLE_EQ(view.devicePixelRatioF(), 2.0);
    ASSERT_TRUE(waitUntil([&] { return view.isUpToDate(); }));
    const auto frame = view.shownFrame();
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->sizePx, glm::ivec2(400, 300));
    EXPECT_EQ(view.grab().size(), QSize(400, 300));
}

TEST_F(PixelRatioTest, IconsAreDrawnAndNotEnlarged) {
    const QIcon icon = drawnIcon(Glyph::crosshair);
    const QPixmap pixmap = icon.pixmap(QSize(24, 24), 2.0);
    EXPECT_EQ(pixmap.size(), QSize(48, 48));
    EXPECT_DOUBLE_EQ(pixmap.devicePixelRatio(), 2.0);
    // A line of the glyph begins on an odd row: an enlarged one has equal pairs of rows everywhere.
    const QImage image = pixmap.toImage();
    bool isEnlarged = true;
    for (int y = 0; y < image.height() && isEnlarged; y += 2) {
        for (int x = 0; x < image.width(); ++x)
            isEnlarged = isEnlarged && image.pixel(x, y) == image.pixel(x, y + 1);
    }
    EXPECT_FALSE(isEnlarged);
}

TEST_F(PixelRatioTest, NamesOverThePictureHaveTwiceThePixels) {
    const auto once = paintText({.names = {"A name"}}, QSize(500, 300), 1.0);
    const auto twice = paintText({.names = {"A name"}}, QSize(1000, 600), 2.0);
    ASSERT_TRUE(once && twice);
    const QRect small = test::coveredBy(*once);
    const QRect large = test::coveredBy(*twice);
    EXPECT_NEAR(large.height(), 2.0 * small.height(), 3.0);
    EXPECT_NEAR(large.width(), 2.0 * small.width(), 0.1 * large.width());
    EXPECT_NEAR(large.x(), 2.0 * small.x(), 3.0);
}

TEST_F(PixelRatioTest, TheColourOfAPointIsSharp) {
    PointFields fields;
    fields.show();
    PointFields::Point point;
    point.colour = glm::dvec3(1.0, 0.0, 0.0);
    fields.showPoint(point);
    const auto* button = fields.findChild<QPushButton*>(QStringLiteral("transfer-colour"));
    ASSERT_NE(button, nullptr);
    const QList<QSize> sizes = button->icon().availableSizes();
    ASSERT_FALSE(sizes.isEmpty());
    EXPECT_EQ(button->icon().pixmap(QSize(16, 16), 2.0).size(), QSize(32, 32));
}

}  // namespace
}  // namespace macula::viewer
