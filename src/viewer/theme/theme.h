// The dark theme of the window, made for a reading room.
#pragma once

#include <QPalette>

#include "viewer/theme/theme_colours.h"

class QApplication;

namespace macula::viewer {

inline constexpr double kSmallestFontScale = 0.8;
inline constexpr double kLargestFontScale = 2.0;

struct ThemeOptions {
    bool highContrast = false;
    double fontScale = 1.0;  // times the font of the desktop; from kSmallestFontScale to kLargestFontScale

    bool operator==(const ThemeOptions&) const = default;
};

// Clamps the scale to its range; a NaN becomes 1.
ThemeOptions usable(ThemeOptions choice);

// Sets the application's style, palette and fonts. Uses no style sheet, because child widgets would no longer
// inherit palettes and fonts. May be called again: scales do not add up.
void applyTheme(QApplication& application, ThemeOptions choice);

// The factor for letters over pictures: names, measurements and side letters have their own size, which a
// small font scale does not reduce. From the last applied theme; 1 before.
double fontScaleOverPictures();

// The colours of the last applied theme (dark before), for uses without a palette role. On the UI thread. A
// widget that keeps a colour must handle QEvent::StyleChange.
const ThemeColours& themeColours();

QPalette paletteOf(const ThemeColours& colours);

}  // namespace macula::viewer
