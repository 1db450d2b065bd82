// A small picture with letters for panels, notices and outlines that float in the room. Drawn without a
// library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace macula::xr {

// From the top; the bit of value 16 is the leftmost of five dots.
using LetterRows = std::array<std::uint8_t, 7>;

// The glyph of a character; a box if there is none.
const LetterRows& lettersOf(char32_t sign);

// The characters of UTF-8 text. A sharp s becomes two; a sequence of more than two bytes becomes one without
// a glyph.
std::u32string signsOf(std::string_view text);

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
