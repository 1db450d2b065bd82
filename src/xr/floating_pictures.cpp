#include "xr/floating_pictures.h"

#include <utility>

namespace macula::xr {

namespace {

constexpr glm::ivec2 kNoticePx{640, 40};
constexpr glm::dvec2 kNoticeM{0.64, 0.04};
constexpr glm::dvec3 kNoticeFromHeadM{0.0, -0.22, -0.9};
constexpr double kPointerM = 0.012;

constexpr PanelColour kClear{0, 0, 0, 0};
constexpr PanelColour kNoticeBack{24, 28, 34, 200};
constexpr PanelColour kWhite{235, 238, 242, 255};
constexpr PanelColour kPointer{255, 190, 60, 255};
constexpr PanelColour kOutline{255, 120, 60, 230};
constexpr PanelColour kCutAway{255, 120, 60, 40};

PanelPicture tile() {
    PanelPicture picture(glm::ivec2(128), kCutAway);
    picture.frame({0, 0}, glm::ivec2(128), 3, kOutline);
    return picture;
}

PanelPicture ring() {
    PanelPicture picture(glm::ivec2(128), kClear);
    picture.ring(glm::dvec2(64.0), 0.0, 63.0, kCutAway);
    picture.ring(glm::dvec2(64.0), 60.0, 63.5, kOutline);
    return picture;
}

PanelPicture pointer() {
    PanelPicture picture(glm::ivec2(32), kClear);
    picture.ring(glm::dvec2(16.0), 0.0, 15.0, kPointer);
    return picture;
}

}  // namespace

FloatingPictures::FloatingPictures()
    : pictures_{Drawn{PanelPicture(WristPanel::kSizePx, kClear)}, Drawn{PanelPicture(kNoticePx, kClear)},
                Drawn{pointer()}, Drawn{tile()}, Drawn{ring()}} {}

void FloatingPictures::draw(RoomPicture which, PanelPicture picture) {
    Drawn& drawn = pictures_.at(std::size_t(which));
    drawn.picture = std::move(picture);
    ++drawn.number;
}

void FloatingPictures::drawPanel(const PanelTexts& texts, const RoomWords& words,
                                 std::optional<PanelButton> pointedAt) {
    if (texts == texts_ && pointedAt_ == pointedAt) return;
    draw(RoomPicture::panel, WristPanel::draw(texts, words, pointedAt));
    texts_ = texts;
    pointedAt_ = pointedAt;
}

void FloatingPictures::drawNotice(const std::string& text) {
    if (text == notice_) return;
    PanelPicture picture(kNoticePx, kNoticeBack);
    picture.writeInto(text, {8, 0}, {kNoticePx.x - 16, kNoticePx.y}, 2, kWhite);
    draw(RoomPicture::notice, std::move(picture));
    notice_ = text;
}

Floating FloatingPictures::noticeBefore(const Pose& head) {
    const glm::dvec3 at = head.positionM + head.orientation * kNoticeFromHeadM;
    return {RoomPicture::notice, {at, head.orientation}, kNoticeM};
}

Floating FloatingPictures::pointerOn(const Pose& panel, const glm::dvec2& px) {
    return {RoomPicture::pointer, WristPanel::poseOf(panel, px), glm::dvec2(kPointerM)};
}

}  // namespace macula::xr
