#include "xr/panel_picture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.h"
#include "xr/panel_letters.h"

namespace macula::xr {

PanelPicture::PanelPicture(const glm::ivec2& sizePx, const PanelColour& colour) : sizePx_(sizePx) {
    MACULA_CHECK(sizePx.x > 0 && sizePx.y > 0);
    pixels_.assign(std::size_t(sizePx.x) * std::size_t(sizePx.y), colour);
}

PanelColour PanelPicture::at(const glm::ivec2& px) const {
    MACULA_CHECK(px.x >= 0 && px.y >= 0 && px.x < sizePx_.x && px.y < sizePx_.y);
    return pixels_[std::size_t(px.y) * std::size_t(sizePx_.x) + std::size_t(px.x)];
}

void PanelPicture::fill(const glm::ivec2& fromPx, const glm::ivec2& sizePx, const PanelColour& colour) {
    const glm::ivec2 from = glm::clamp(fromPx, glm::ivec2(0), sizePx_);
    const glm::ivec2 to = glm::clamp(fromPx + sizePx, glm::ivec2(0), sizePx_);
    for (int y = from.y; y < to.y; ++y) {
        const auto row = pixels_.begin() + std::ptrdiff_t(y) * sizePx_.x;
        if (from.x < to.x) std::fill(row + from.x, row + to.x, colour);
    }
}

void PanelPicture::frame(const glm::ivec2& fromPx, const glm::ivec2& sizePx, int widthPx,
                         const PanelColour& colour) {
    fill(fromPx, {sizePx.x, widthPx}, colour);
    fill({fromPx.x, fromPx.y + sizePx.y - widthPx}, {sizePx.x, widthPx}, colour);
    fill(fromPx, {widthPx, sizePx.y}, colour);
    fill({fromPx.x + sizePx.x - widthPx, fromPx.y}, {widthPx, sizePx.y}, colour);
}

void PanelPicture::ring(const glm::dvec2& middlePx, double innerPx, double outerPx,
                        const PanelColour& colour) {
    for (int y = 0; y < sizePx_.y; ++y) {
        for (int x = 0; x < sizePx_.x; ++x) {
            const double far = glm::length(glm::dvec2(x + 0.5, y + 0.5) - middlePx);
            if (far >= innerPx && far <= outerPx)
                pixels_[std::size_t(y) * std::size_t(sizePx_.x) + std::size_t(x)] = colour;
        }
    }
}

void PanelPicture::write(std::string_view text, const glm::ivec2& atPx, int scale,
                         const PanelColour& colour) {
    glm::ivec2 pen = atPx;
    for (const char32_t sign : signsOf(text)) {
        const LetterRows& rows = lettersOf(sign);
        for (int y = 0; y < kLetterPx.y; ++y)
            for (int x = 0; x < kLetterPx.x; ++x)
                if (rows[std::size_t(y)] & (16 >> x))
                    fill(pen + scale * glm::ivec2(x, y), glm::ivec2(scale), colour);
        pen.x += scale * kAdvancePx;
    }
}

void PanelPicture::writeInto(std::string_view text, const glm::ivec2& fromPx, const glm::ivec2& sizePx,
                             int scale, const PanelColour& colour) {
    const int most = (sizePx.x + scale) / (scale * kAdvancePx);
    std::string shown(text);
    if (int(signsOf(shown).size()) > most) {
        // Removes whole UTF-8 characters: a continuation byte belongs to the one before.
        while (!shown.empty() && int(signsOf(shown).size()) > std::max(most - 2, 0)) {
            while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0) == 0x80)
                shown.pop_back();
            if (!shown.empty()) shown.pop_back();
        }
        shown += "..";
    }
    const glm::ivec2 textPx(widthPx(shown, scale), scale * kLetterPx.y);
    write(shown, fromPx + (sizePx - textPx) / 2, scale, colour);
}

int PanelPicture::widthPx(std::string_view text, int scale) {
    const int signs = int(signsOf(text).size());
    return signs == 0 ? 0 : scale * (signs * kAdvancePx - (kAdvancePx - kLetterPx.x));
}

}  // namespace macula::xr
