#include "viewer/theme/theme.h"

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QFontDatabase>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "viewer/theme/theme_style.h"

namespace macula::viewer {

namespace {

const ThemeColours* applied = &kDarkColours;
double appliedFontScale = 1.0;

// Scales the desktop's font, not the one applied before.
QFont scaledFont(double scale) {
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    if (font.pointSizeF() > 0.0)
        font.setPointSizeF(font.pointSizeF() * scale);
    else
        font.setPixelSize(std::max(1, int(std::lround(font.pixelSize() * scale))));
    return font;
}

}  // namespace

ThemeOptions usable(ThemeOptions choice) {
    choice.fontScale = std::isnan(choice.fontScale)
                           ? 1.0
                           : std::clamp(choice.fontScale, kSmallestFontScale, kLargestFontScale);
    return choice;
}

QPalette paletteOf(const ThemeColours& colours) {
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, QRgb colour) { palette.setColor(role, QColor(colour)); };
    set(QPalette::Window, colours.window);
    set(QPalette::WindowText, colours.text);
    set(QPalette::Base, colours.field);
    set(QPalette::AlternateBase, colours.otherRow);
    set(QPalette::Text, colours.text);
    set(QPalette::PlaceholderText, colours.faintText);
    set(QPalette::Button, colours.button);
    set(QPalette::ButtonText, colours.text);
    set(QPalette::BrightText, colours.selectionText);
    set(QPalette::ToolTipBase, colours.tip);
    set(QPalette::ToolTipText, colours.text);
    set(QPalette::Highlight, colours.selection);
    set(QPalette::HighlightedText, colours.selectionText);
    set(QPalette::Link, colours.link);
    set(QPalette::LinkVisited, colours.link);
    // For edges that look raised.
    palette.setColor(QPalette::Light, QColor(colours.button).lighter(130));
    palette.setColor(QPalette::Midlight, QColor(colours.button).lighter(115));
    palette.setColor(QPalette::Mid, QColor(colours.line).darker(150));
    palette.setColor(QPalette::Dark, QColor(colours.window).darker(150));
    palette.setColor(QPalette::Shadow, QColor(Qt::black));

    const auto setDisabled = [&](QPalette::ColorRole role, QRgb colour) {
        palette.setColor(QPalette::Disabled, role, QColor(colour));
    };
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText,
          QPalette::HighlightedText, QPalette::Link, QPalette::LinkVisited})
        setDisabled(role, colours.disabledText);
    setDisabled(QPalette::Highlight, colours.button);
    return palette;
}

void applyTheme(QApplication&, ThemeOptions choice) {
    choice = usable(choice);
    applied = choice.highContrast ? &kHighContrastColours : &kDarkColours;
    appliedFontScale = choice.fontScale;
    const QPalette palette = paletteOf(*applied);
    QApplication::setStyle(new ThemeStyle(*applied, choice.fontScale));  // the application owns it
    QApplication::setPalette(palette);
    QApplication::setFont(scaledFont(choice.fontScale));
    QToolTip::setPalette(palette);
}

double fontScaleOverPictures() {
    return std::max(1.0, appliedFontScale);
}

const ThemeColours& themeColours() {
    return *applied;
}

}  // namespace macula::viewer
