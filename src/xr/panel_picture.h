// A small picture with letters for panels, notices and outlines that float in the room. Drawn without a
// library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace macula::xr {

// 8 bits each, encoded for display, with straight alpha: 255 is opaque.
using PanelColour = glm::u8vec4;

// Row 0 on top. Drawing is clipped to the picture.
class PanelPicture {
  public:
    // The size of a letter, and its width with the gap after it, at scale 1.
    static constexpr glm::ivec2 kLetterPx{5, 7};
    static constexpr int kAdvancePx = 6;

    PanelPicture(const glm::ivec2& sizePx, const PanelColour& colour);

    const glm::ivec2& sizePx() const { return sizePx_; }
    const std::vector<PanelColour>& pixels() const { return pixels_; }
    PanelColour at(const glm::ivec2& px) const;  // within the picture

    void fill(const glm::ivec2& fromPx, const glm::ivec2& sizePx, const PanelColour& colour);
    void frame(const glm::ivec2& fromPx, const glm::ivec2& sizePx, int widthPx, const PanelColour& colour);
    // A ring of these radii, or a disc if `innerPx` is 0.
    void ring(const glm::dvec2& middlePx, double innerPx, double outerPx, const PanelColour& colour);
    // Writes in capitals; a character without a glyph is a box. `atPx` is the upper left corner.
    void write(std::string_view text, const glm::ivec2& atPx, int scale, const PanelColour& colour);
    // Centred in a rectangle; text that is too long is cut off with two dots.
    void writeInto(std::string_view text, const glm::ivec2& fromPx, const glm::ivec2& sizePx, int scale,
                   const PanelColour& colour);

    static int widthPx(std::string_view text, int scale);

    bool operator==(const PanelPicture&) const = default;

  private:
    glm::ivec2 sizePx_;
    std::vector<PanelColour> pixels_;
};

}  // namespace macula::xr
