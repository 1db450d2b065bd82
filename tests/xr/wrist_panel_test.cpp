// The panel: where it is, which button a ray meets, and what stands on it.
#include "xr/wrist_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "xr/panel_picture.h"

namespace macula::xr {
namespace {

constexpr std::array kAll{PanelButton::presetBefore, PanelButton::presetNext, PanelButton::shiftLower,
                          PanelButton::shiftHigher,  PanelButton::knife,      PanelButton::held,
                          PanelButton::resetClips,   PanelButton::undo,       PanelButton::picture,
                          PanelButton::quality,      PanelButton::realSize,   PanelButton::recentre,
                          PanelButton::otherWrist};

Pose aimAt(const glm::dvec3& from, const glm::dvec3& to) {
    return {from, glm::quatLookAt(glm::normalize(to - from), glm::dvec3(0, 1, 0))};
}

TEST(WristPanel, ARayMeetsEachButtonInItsMiddle) {
    const Pose panel{{0.2, 1.3, -0.4},
                     glm::angleAxis(glm::radians(25.0), glm::normalize(glm::dvec3(1.0, 0.5, 0.2)))};
    for (const PanelButton button : kAll) {
        const glm::dvec2 middle = WristPanel::middleOf(button);
        EXPECT_EQ(WristPanel::buttonAt(middle), button);
        const glm::dvec3 target = WristPanel::poseOf(panel, middle).positionM;
        const glm::dvec3 from = panel.positionM + panel.orientation * glm::dvec3(0.3, -0.2, 0.5);
        const auto hit = WristPanel::hit(panel, aimAt(from, target));
        ASSERT_TRUE(hit);
        // 2 mm before the panel, seen aslant, are some pixels.
        EXPECT_LT(glm::distance(*hit, middle), 6.0);
        EXPECT_EQ(WristPanel::buttonAt(*hit), button);
    }
}

TEST(WristPanel, NothingIsMetFromBehindOrBesideOrFar) {
    const Pose panel{{0.0, 1.5, -0.5}, {1, 0, 0, 0}};
    EXPECT_TRUE(WristPanel::hit(panel, aimAt({0, 1.5, 0}, panel.positionM)));
    EXPECT_FALSE(WristPanel::hit(panel, aimAt({0, 1.5, -1.0}, panel.positionM))) << "behind";
    EXPECT_FALSE(WristPanel::hit(panel, aimAt({0, 1.5, 0}, {0.11, 1.5, -0.5}))) << "beside";
    EXPECT_FALSE(WristPanel::hit(panel, aimAt({0, 1.5, 1.5}, panel.positionM))) << "far";
    EXPECT_FALSE(WristPanel::hit(panel, aimAt({0, 1.5, 0}, {0, 1.5, 1.0}))) << "away";
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(WristPanel::hit(panel, {{none, none, none}, {1, 0, 0, 0}}));
}

TEST(WristPanel, IsThereForWhoLooksAtIt) {
    const glm::dvec3 head(0.0, 1.6, 0.0);
    // A fist that is held upright shows it to the face.
    const Pose upright{{-0.1, 1.3, -0.4}, glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0))};
    EXPECT_TRUE(WristPanel::isTurnedTo(WristPanel::poseAt(upright), head));
    const Pose away{{-0.1, 1.3, -0.4}, glm::angleAxis(glm::radians(-90.0), glm::dvec3(1, 0, 0))};
    EXPECT_FALSE(WristPanel::isTurnedTo(WristPanel::poseAt(away), head));
}

TEST(WristPanel, ButtonsDoNotOverlapAndLieOnThePanel) {
    for (const PanelButton button : kAll) {
        const glm::dvec2 middle = WristPanel::middleOf(button);
        EXPECT_GT(middle.x, 0.0);
        EXPECT_LT(middle.x, WristPanel::kSizePx.x);
        EXPECT_GT(middle.y, 0.0);
        EXPECT_LT(middle.y, WristPanel::kSizePx.y);
    }
    EXPECT_FALSE(WristPanel::buttonAt({2.0, 2.0}));
    // A pixel of a button is not the same as one of another: counted over all pixels.
    std::set<PanelButton> met;
    for (int y = 0; y < WristPanel::kSizePx.y; ++y)
        for (int x = 0; x < WristPanel::kSizePx.x; ++x)
            if (const auto button = WristPanel::buttonAt({x + 0.5, y + 0.5})) met.insert(*button);
    EXPECT_EQ(met.size(), kAll.size());
}

TEST(WristPanel, ShowsWhatIsPointedAtAndWhatCannotBePressed) {
    PanelTexts texts;
    texts.preset = "CT-Bone";
    texts.knife = "Knife: on";
    const PanelPicture usual = WristPanel::draw(texts, RoomWords(), {});
    EXPECT_NE(WristPanel::draw(texts, RoomWords(), PanelButton::knife), usual);
    EXPECT_EQ(WristPanel::draw(texts, RoomWords(), PanelButton::undo), usual) << "there is nothing to undo";
    texts.canUndo = true;
    EXPECT_NE(WristPanel::draw(texts, RoomWords(), {}), usual);
    EXPECT_EQ(usual.sizePx(), WristPanel::kSizePx);
}

// What does not fit is cut, and a button that is cut says nothing.
TEST(WristPanel, WordsFitTheirButtons) {
    const RoomWords words;
    const int half = (188 + 2) / 12;
    for (const std::string& text :
         {words.knifeOn, words.knifeOff, filled(words.hold, words.nothing), words.resetClips, words.undo,
          words.takePicture, words.otherWrist, words.realSize, words.recentre})
        EXPECT_LE(int(signsOf(text).size()), half) << text;
    for (const scene::HandTool& shape : scene::handTools())
        EXPECT_LE(int(signsOf(filled(words.hold, words.of(ClipTool{shape.key}))).size()), half) << shape.key;
    for (const std::string& text : {words.isRealSize, words.isBeforeYou, words.nothingLeft, words.noMoreCuts,
                                    words.lostPlace, filled(words.pictureWritten, "macula-headset-100.png")})
        EXPECT_LE(int(signsOf(text).size()), 52) << text;
    for (const std::string& text :
         {filled(words.quality, words.fast), filled(words.quality, words.balanced),
          filled(words.quality, words.fine), filled(words.larger, "100.00"), filled(words.smaller, "100.00"),
          words.notCalibrated, words.notForDiagnosis})
        EXPECT_LE(int(signsOf(text).size()), (384 + 2) / 12) << text;
    RoomWords others;
    others.undo =
        "Zur\xc3\xbc"
        "ck";
    EXPECT_NE(WristPanel::draw({}, others, {}), WristPanel::draw({}, words, {}));
}

TEST(RoomWords, OfATitleAndItsCopies) {
    RoomWords words;
    words.edited = "bearbeitet";
    words.titles = {{"Cinematic bone", "Cinematic Knochen"}};
    EXPECT_EQ(words.ofTitle("Cinematic bone"), "Cinematic Knochen");
    EXPECT_EQ(words.ofTitle("Cinematic bone (edited 2)"), "Cinematic Knochen (bearbeitet 2)");
    EXPECT_EQ(words.ofTitle("Cinematic bone (edited)"), "Cinematic Knochen (bearbeitet)");
    for (const char* own :
         {"Mine", "Mine (edited by hand)", "Mine (edited 2", "Mine (edited )", "Mine (editedly)"})
        EXPECT_EQ(words.ofTitle(own), own) << "whoever made it named it so";
    EXPECT_EQ(words.ofTitle(""), "");
    EXPECT_EQ(words.say(Text("The disk is full.")), "The disk is full.");
    EXPECT_EQ(filled("no place", "x"), "no place");
}

int dotsIn(const PanelPicture& picture, const PanelColour& colour) {
    return int(std::count(picture.pixels().begin(), picture.pixels().end(), colour));
}

TEST(PanelPicture, LettersAreWhereTheyAreWritten) {
    const PanelColour dark(0, 0, 0, 255);
    const PanelColour light(255, 255, 255, 255);
    PanelPicture picture({24, 12}, dark);
    picture.write("L", {2, 3}, 1, light);
    for (int y = 0; y < 7; ++y) EXPECT_EQ(picture.at({2, 3 + y}), light) << y;
    for (int x = 0; x < 5; ++x) EXPECT_EQ(picture.at({2 + x, 9}), light) << x;
    EXPECT_EQ(dotsIn(picture, light), 11);
    PanelPicture small({24, 12}, dark);
    small.write("l", {2, 3}, 1, light);
    EXPECT_EQ(small, picture) << "capitals";
    // Beyond the border nothing is written.
    picture.write("HHHHHHHH", {20, 8}, 3, light);
    EXPECT_EQ(picture.sizePx(), glm::ivec2(24, 12));
}

TEST(PanelPicture, LongTextsAreCutAndSignsWithoutLettersAreBoxes) {
    EXPECT_EQ(signsOf("a\xc3\xa4z"), U"a\u00e4z");
    EXPECT_EQ(signsOf("\xc3\x9f"), U"SS");
    EXPECT_EQ(signsOf("\xe2\x82\xac"), U"\uFFFD") << "a euro has no letter";
    EXPECT_EQ(signsOf("\xc3"), U"\uFFFD") << "cut off";
    EXPECT_EQ(signsOf("\x80"), U"") << "no sign begins so";
    for (const char32_t* pair : {U"\u00e4\u00c4", U"\u00f6\u00d6", U"\u00fc\u00dc"}) {
        EXPECT_EQ(lettersOf(pair[0]), lettersOf(pair[1]));
        EXPECT_NE(lettersOf(pair[0]), lettersOf(U'\uFFFD'));
    }
    EXPECT_EQ(lettersOf(U'\uFFFD')[0], 0x1f);
    EXPECT_NE(lettersOf(U'A'), lettersOf(U'B'));
    const PanelColour dark(0, 0, 0, 255);
    const PanelColour light(255, 255, 255, 255);
    PanelPicture cut({60, 10}, dark);
    cut.writeInto("A name that is much too long \xc3\xa4\xc3\xb6\xc3\xbc", {0, 0}, {60, 10}, 1, light);
    PanelPicture wanted({60, 10}, dark);
    wanted.writeInto("A name t..", {0, 0}, {60, 10}, 1, light);
    EXPECT_EQ(cut, wanted);
    EXPECT_EQ(PanelPicture::widthPx("", 3), 0);
    EXPECT_EQ(PanelPicture::widthPx("AB", 2), 22);
}

}  // namespace
}  // namespace macula::xr
