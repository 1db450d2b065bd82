// The look of the window: dark and calm, as a reading room is.
#pragma once

#include <QPalette>

#include "viewer/theme/theme_colours.h"

class QApplication;

namespace macula::viewer {

inline constexpr double kSmallestFontScale = 0.8;
inline constexpr double kLargestFontScale = 2.0;

struct ThemeChoice {
    bool highContrast = false;
    double fontScale = 1.0;  // times the font of the desktop; from kSmallestFontScale to kLargestFontScale

    bool operator==(const ThemeChoice&) const = default;
};

// A scale beyond its range is taken as the nearest in it, one that is no number as 1.
ThemeChoice usable(ThemeChoice choice);

// The application's style, palette and fonts. No style sheet: with one, palettes and fonts of widgets do not
// go to what is in them. May be called again: scales do not add up.
void applyTheme(QApplication& application, ThemeChoice choice);

// Times the letters over pictures: patients' names, measurements and sides have a size of their own, which
// is never smaller. Of the theme that was applied last, 1 before.
double fontScaleOverPictures();

// Of the theme that was applied last, the dark one before; for what a palette has no role for. On the UI
// thread. Who keeps a colour listens to QEvent::StyleChange.
const ThemeColours& themeColours();

QPalette paletteOf(const ThemeColours& colours);

}  // namespace macula::viewer
