// The flat pictures that float in the room. Knows no OpenXR.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "xr/eyes.h"
#include "xr/panel_picture.h"
#include "xr/room_words.h"
#include "xr/wrist_panel.h"

namespace macula::xr {

enum class RoomPicture { panel, notice, pointer, tile, ring };
inline constexpr std::size_t kRoomPictures = 5;

// A flat picture in the stage: x to the right, y up, seen from its +z.
struct Floating {
    RoomPicture picture = RoomPicture::panel;
    Pose pose;
    glm::dvec2 sizeM{0.0};
};

// Holds the pictures, and redraws one only when it changes.
class FloatingPictures {
  public:
    FloatingPictures();

    const PanelPicture& picture(RoomPicture which) const { return pictures_.at(std::size_t(which)).picture; }
    // Changes when the picture does.
    std::uint64_t number(RoomPicture which) const { return pictures_.at(std::size_t(which)).number; }

    void drawPanel(const PanelTexts& texts, const RoomWords& words, std::optional<PanelButton> pointedAt);
    void drawNotice(const std::string& text);

    // The placement of a sentence before that head.
    static Floating noticeBefore(const Pose& head);
    // Marks where the pointing ray meets the panel, in the panel's pixels.
    static Floating pointerOn(const Pose& panel, const glm::dvec2& px);

  private:
    struct Drawn {
        PanelPicture picture;
        std::uint64_t number = 1;
    };

    void draw(RoomPicture which, PanelPicture picture);

    std::array<Drawn, kRoomPictures> pictures_;
    PanelTexts texts_;  // as drawn on the panel
    std::optional<PanelButton> pointedAt_;
    std::string notice_;
};

}  // namespace macula::xr
