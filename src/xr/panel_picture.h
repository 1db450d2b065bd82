// A small picture with letters for what floats in the room: panels, notices, outlines. No library draws it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace macula::xr {

// 8 bits each, encoded for display, alpha straight: 255 hides what is behind it.
using PanelColour = glm::u8vec4;

// Row 0 on top. What is drawn beyond a border is left out.
class PanelPicture {
  public:
    // Of a letter, and with the gap behind it, at scale 1.
    static constexpr glm::ivec2 kLetterPx{5, 7};
    static constexpr int kAdvancePx = 6;

    PanelPicture(const glm::ivec2& sizePx, const PanelColour& colour);

    const glm::ivec2& sizePx() const { return sizePx_; }
    const std::vector<PanelColour>& pixels() const { return pixels_; }
    PanelColour at(const glm::ivec2& px) const;  // within the picture

    void fill(const glm::ivec2& fromPx, const glm::ivec2& sizePx, const PanelColour& colour);
    void frame(const glm::ivec2& fromPx, const glm::ivec2& sizePx, int widthPx, const PanelColour& colour);
    // A ring, or a disc where `innerPx` is 0, of these radii.
    void ring(const glm::dvec2& middlePx, double innerPx, double outerPx, const PanelColour& colour);
    // Capitals; a sign that there is no letter for is a box. `atPx` is the left upper corner.
    void write(std::string_view text, const glm::ivec2& atPx, int scale, const PanelColour& colour);
    // In the middle of a rectangle, cut off with two dots where it is too long.
    void writeInto(std::string_view text, const glm::ivec2& fromPx, const glm::ivec2& sizePx, int scale,
                   const PanelColour& colour);

    static int widthPx(std::string_view text, int scale);

    bool operator==(const PanelPicture&) const = default;

  private:
    glm::ivec2 sizePx_;
    std::vector<PanelColour> pixels_;
};

}  // namespace macula::xr
