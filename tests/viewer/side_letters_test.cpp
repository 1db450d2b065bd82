// Letters at the edges of a 3D picture, and how little of it they cover.
#include "viewer/overlay/painted_text.h"

#include <QImage>
#include <QPainter>

#include "viewer/covered_by.h"
#include "viewer/offscreen.h"
#include "viewer/overlay/mark_atlas.h"

namespace macula::viewer {
namespace {

using SideLettersTest = test::OffscreenTest;

const scene::EdgeLetters kFront{.left = "R", .right = "L", .top = "S", .bottom = "I"};

// How many device pixels of the picture are covered there.
int coveredIn(const live::PictureText& marks, const QRect& part) {
    int count = 0;
    for (std::size_t i = 0; i < marks.boxes.size(); ++i) {
        const VkExtent2D size = marks.boxes[i].extent;
        const QRect box =
            part & QRect(marks.places[i].x, marks.places[i].y, int(size.width), int(size.height));
        count += box.width() * box.height();
    }
    return count;
}

TEST_F(SideLettersTest, EachStandsAtItsEdgeAndNothingElseIsCovered) {
    for (const double ratio : {1.0, 2.0}) {
        const QSize pixels(int(400 * ratio), int(300 * ratio));
        const auto marks = withSideLetters(nullptr, kFront, pixels, ratio);
        ASSERT_TRUE(marks);
        EXPECT_EQ(marks->of.width, std::uint32_t(pixels.width()));
        const int wide = pixels.width();
        const int high = pixels.height();
        const int edge = int(32 * ratio);
        const QRect left(0, high / 2 - edge, edge, 2 * edge);
        const QRect right(wide - edge, high / 2 - edge, edge, 2 * edge);
        const QRect top(wide / 2 - edge, 0, 2 * edge, edge);
        const QRect bottom(wide / 2 - edge, high - edge, 2 * edge, edge);
        int atEdges = 0;
        for (const QRect& part : {left, right, top, bottom}) {
            EXPECT_GT(coveredIn(*marks, part), 40 * ratio * ratio);
            atEdges += coveredIn(*marks, part);
        }
        EXPECT_EQ(coveredIn(*marks, QRect(QPoint(0, 0), pixels)), atEdges);
    }
}

TEST_F(SideLettersTest, WhereTheyHaveNoRoomThereAreNone) {
    EXPECT_EQ(withSideLetters(nullptr, kFront, QSize(30, 30), 1.0), nullptr);
    EXPECT_EQ(withSideLetters(nullptr, {}, QSize(400, 300), 1.0), nullptr);
    const auto others = withSideLetters(nullptr, kFront, QSize(400, 300), 1.0);
    EXPECT_EQ(withSideLetters(others, {}, QSize(400, 300), 1.0), others);
    EXPECT_GT(withSideLetters(others, kFront, QSize(400, 300), 1.0)->boxes.size(), others->boxes.size());
}

TEST_F(SideLettersTest, OtherSidesAreOtherPixels) {
    const scene::EdgeLetters back{.left = "L", .right = "R", .top = "S", .bottom = "I"};
    EXPECT_NE(withSideLetters(nullptr, kFront, QSize(400, 300), 1.0)->rgba,
              withSideLetters(nullptr, back, QSize(400, 300), 1.0)->rgba);
}

TEST_F(SideLettersTest, BoxesCoverWhatIsPaintedAndSmallGaps) {
    QImage painted(20, 6, QImage::Format_ARGB32_Premultiplied);
    painted.fill(Qt::transparent);
    QPainter painter(&painted);
    painter.fillRect(2, 1, 4, 3, Qt::white);
    painter.fillRect(8, 1, 3, 3, Qt::white);  // two pixels apart
    painter.fillRect(15, 1, 2, 3, Qt::white);
    painter.fillRect(4, 4, 1, 1, Qt::white);
    painter.end();
    const auto rects = [&](int closePx) {
        std::vector<QRect> found;
        for (const VkRect2D& box : coveredBoxes(painted, closePx))
            found.emplace_back(box.offset.x, box.offset.y, int(box.extent.width), int(box.extent.height));
        return found;
    };
    EXPECT_EQ(rects(0),
              (std::vector{QRect(2, 1, 4, 3), QRect(8, 1, 3, 3), QRect(15, 1, 2, 3), QRect(4, 4, 1, 1)}));
    EXPECT_EQ(rects(2), (std::vector{QRect(2, 1, 9, 3), QRect(15, 1, 2, 3), QRect(4, 4, 1, 1)}));
}

}  // namespace
}  // namespace macula::viewer
