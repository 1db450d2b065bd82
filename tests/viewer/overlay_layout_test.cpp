// Where texts over a slice stand, in panes of any size and fonts of any size.
#include "viewer/overlay/overlay_layout.h"

#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <set>

#include "viewer/offscreen.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {
namespace {

const QStringList kNames{"MIDRC-RICORD-1A-419639-001012",
                         "ID MIDRC-RICORD-1A-419639-001012, born 1970-01-01, O",
                         "2004-12-12, CT CHEST WITHOUT CONTRAST", "CT, series 2: ROUTINE CHEST NON-CON"};
const QString kWarning("Interpolated: no image was taken here");

class OverlayLayoutTest : public test::OffscreenTest {
  protected:
    static SliceOverlay chest(slices::Orientation orientation) {
        SliceOverlay overlay;
        overlay.orientation = orientation;
        overlay.frame.plane = slices::planeOf(orientation, {});
        overlay.frame.mmPerPixel = 1.5;
        overlay.names = kNames;
        overlay.facts = {"-87 HU at (12, 200, 45), L 12.3 P 45.6 S 78.9 mm",
                         "Axial S 122.0 mm, slice 115 of 248, image 134", "W 400 L 40 HU"};
        overlay.notes = {"MIP 10 mm", kWarning};
        return overlay;
    }
    static OverlayLayout laidOut(const SliceOverlay& overlay, const QSize& size, double scale) {
        return layOut(overlay, size, QApplication::font(), scale);
    }
    static std::vector<PlacedText> of(const OverlayLayout& layout, OverlayPart part) {
        std::vector<PlacedText> found;
        for (const PlacedText& text : layout.texts)
            if (text.part == part) found.push_back(text);
        return found;
    }
    static QString joined(const std::vector<PlacedText>& texts) {
        QStringList lines;
        for (const PlacedText& text : texts) lines << text.text;
        return lines.join(QLatin1Char(' '));
    }
    static std::optional<QPointF> middleOf(const OverlayLayout& layout, const std::string& letter) {
        for (const PlacedText& text : of(layout, OverlayPart::side))
            if (text.text.toStdString() == letter) return text.box().center();
        return std::nullopt;
    }
};

constexpr std::array kOrientations{slices::Orientation::axial, slices::Orientation::coronal,
                                   slices::Orientation::sagittal};

// P above A, or I above S, is a patient who is turned round.
TEST_F(OverlayLayoutTest, LettersKeepTheirSideOrGo) {
    int seen = 0;
    for (const auto orientation : kOrientations) {
        const SliceOverlay overlay = chest(orientation);
        const scene::EdgeLetters sides = edgeLetters(overlay.frame.plane);
        for (int width = 60; width <= 700; width += 40) {
            for (int height = 40; height <= 500; height += 30) {
                for (const double scale : {1.0, 1.5, 2.0}) {
                    const OverlayLayout layout = laidOut(overlay, {width, height}, scale);
                    const auto top = middleOf(layout, sides.top);
                    const auto bottom = middleOf(layout, sides.bottom);
                    const auto left = middleOf(layout, sides.left);
                    const auto right = middleOf(layout, sides.right);
                    EXPECT_EQ(top.has_value(), bottom.has_value());
                    EXPECT_EQ(left.has_value(), right.has_value());
                    if (top && bottom) {
                        EXPECT_LT(top->y(), height / 3.0) << width << " x " << height << " at " << scale;
                        EXPECT_GT(bottom->y(), height * 2.0 / 3.0) << width << " x " << height;
                        EXPECT_NEAR(top->x(), width / 2.0, 1.0);
                        ++seen;
                    }
                    if (left && right) {
                        EXPECT_LT(left->x(), width / 3.0) << width << " x " << height;
                        EXPECT_GT(right->x(), width * 2.0 / 3.0) << width << " x " << height;
                    }
                }
            }
        }
    }
    EXPECT_GT(seen, 1000);
    const OverlayLayout smallest = laidOut(chest(slices::Orientation::axial), {120, 120}, 2.0);
    EXPECT_EQ(of(smallest, OverlayPart::side).size(), 4u) << "the smallest pane that there is";
}

TEST_F(OverlayLayoutTest, NoTextLiesOverALetterOrAnother) {
    for (const auto orientation : kOrientations) {
        for (int width = 180; width <= 900; width += 60) {
            for (int height = 200; height <= 700; height += 50) {
                for (const double scale : {1.0, 2.0}) {
                    const auto layout = laidOut(chest(orientation), {width, height}, scale);
                    for (std::size_t a = 0; a < layout.texts.size(); ++a) {
                        for (std::size_t b = 0; b < a; ++b) {
                            const QRectF both = layout.texts[a].box() & layout.texts[b].box();
                            EXPECT_TRUE(both.height() < 3.0 || both.width() < 3.0)
                                << width << " x " << height << " at " << scale << ": "
                                << layout.texts[a].text.toStdString() << " over "
                                << layout.texts[b].text.toStdString();
                        }
                        EXPECT_TRUE(QRectF(0, 0, width, height).contains(layout.texts[a].box()))
                            << width << " x " << height << ": " << layout.texts[a].text.toStdString();
                    }
                }
            }
        }
    }
}

TEST_F(OverlayLayoutTest, WarningsStayAndNamesGoFromTheLastOn) {
    const SliceOverlay overlay = chest(slices::Orientation::coronal);
    std::set<std::size_t> counts;
    std::size_t before = 0;
    for (int height = 120; height <= 600; height += 20) {
        const OverlayLayout layout = laidOut(overlay, {420, height}, 1.0);
        EXPECT_TRUE(joined(of(layout, OverlayPart::note)).contains(kWarning)) << height;
        const auto names = of(layout, OverlayPart::name);
        EXPECT_GE(names.size(), before) << height;
        for (std::size_t i = 0; i < names.size(); ++i)
            EXPECT_EQ(names[i].text.left(2), kNames[qsizetype(i)].left(2));
        before = names.size();
        counts.insert(names.size());
    }
    EXPECT_EQ(before, 4u);
    EXPECT_GE(counts.size(), 3u);
    EXPECT_TRUE(
        joined(of(laidOut(overlay, {120, 120}, 1.0), OverlayPart::note)).contains("no image was taken"));
}

// What tells one number from the next is at its end as often as at its beginning.
TEST_F(OverlayLayoutTest, LongIdsAreCutInTheirMiddle) {
    SliceOverlay overlay = chest(slices::Orientation::axial);
    overlay.notes.clear();
    const auto names = of(laidOut(overlay, {190, 400}, 1.0), OverlayPart::name);
    ASSERT_FALSE(names.empty());
    EXPECT_TRUE(names[0].text.startsWith("MIDRC-")) << names[0].text.toStdString();
    EXPECT_TRUE(names[0].text.endsWith("001012")) << names[0].text.toStdString();
    EXPECT_TRUE(names[0].text.contains(QStringLiteral("…")));
}

TEST_F(OverlayLayoutTest, LinesBreakAfterACommaAndNumbersKeepTheirUnit) {
    const QFont font = QApplication::font();
    const QString text("Axial S 122.0 mm, slice 115 of 248, image 134");
    const double room = QFontMetricsF(font).horizontalAdvance("Axial S 122.0 mm, slice 115");
    EXPECT_EQ(wrapped({text}, font, room),
              QStringList({"Axial S 122.0 mm,", "slice 115 of 248,", "image 134"}));
    EXPECT_EQ(wrapped({text}, font, 1000.0), QStringList{text});
    const double narrow = QFontMetricsF(font).horizontalAdvance("Axial S 122.0");
    EXPECT_EQ(wrapped({"Axial S 122.0 mm"}, font, narrow), QStringList({"Axial S 122.0", "mm"}));
}

TEST_F(OverlayLayoutTest, LargeFontsShrinkBeforeLinesGo) {
    const auto sizeIn = [](const QSize& pane) { return overlayFont({}, pane, 2.0).pixelSize(); };
    EXPECT_EQ(sizeIn({800, 600}), 26);
    EXPECT_EQ(sizeIn({226, 140}), 13);
    EXPECT_EQ(overlayFont({}, {120, 120}, 1.0).pixelSize(), 13) << "and none becomes smaller than usual";
}

TEST_F(OverlayLayoutTest, TheScaleGoesWhereItWouldLieOverAnotherText) {
    SliceOverlay overlay = chest(slices::Orientation::axial);
    EXPECT_TRUE(laidOut(overlay, {500, 400}, 1.0).scaleBar);
    EXPECT_FALSE(laidOut(overlay, {120, 120}, 1.0).scaleBar);
    overlay.notes.clear();
    overlay.facts.removeFirst();
    EXPECT_TRUE(laidOut(overlay, {190, 260}, 1.0).scaleBar) << "above the facts";
}

// Two that were measured side by side are both read.
TEST_F(OverlayLayoutTest, ABlockThatIsWantedWhereAnotherTextStandsIsBesideIt) {
    const QSize pane(300, 200);
    const QFont font = QApplication::font();
    const double line = QFontMetricsF(font).height();
    const QRectF wanted(100, 100, 80, line);
    const auto standing = [&](double top) {
        return PlacedText{
            .at = {90, top + QFontMetricsF(font).ascent()}, .text = "89.7 mm", .ink = {}, .font = font};
    };
    EXPECT_EQ(freePlace(wanted, pane, line + 1, {}), wanted.topLeft());
    const std::vector<PlacedText> one{standing(100)};
    const QPointF below = freePlace(wanted, pane, line + 1, one);
    EXPECT_EQ(below, QPointF(100, 100 + line + 1));
    EXPECT_FALSE(one[0].box().intersects(QRectF(below, wanted.size())));
    const std::vector<PlacedText> two{standing(100), standing(100 + line + 4)};
    EXPECT_EQ(freePlace(wanted, pane, line + 1, two), QPointF(100, 100 - line - 1)) << "above is nearer";
    std::vector<PlacedText> full;
    for (double top = 0; top < 200; top += 10) full.push_back(standing(top));
    EXPECT_EQ(freePlace(wanted, pane, line + 1, full), wanted.topLeft());
}

}  // namespace
}  // namespace macula::viewer
