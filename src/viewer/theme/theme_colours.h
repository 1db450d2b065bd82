// All colours of the window, in one table for each variant.
#pragma once

#include <QRgb>
#include <array>

namespace macula::viewer {

// 0xRRGGBB. Text has a contrast of at least 7:1 to its ground; disabled text and lines have 3:1 (WCAG 2.1,
// 1.4.6 and 1.4.11); see textPairs and linePairs.
struct ThemeColours {
    QRgb window;  // also around pictures
    QRgb field;   // lists and text fields
    QRgb otherRow;
    QRgb button;
    QRgb tip;
    QRgb text;
    QRgb faintText;  // in an empty field
    QRgb disabledText;
    QRgb link;
    QRgb line;       // around a control, and of drag handles
    QRgb accent;     // keyboard focus, check marks
    QRgb selection;  // behind selected text
    QRgb selectionText;
    QRgb onAccent;  // a check mark
    QRgb error;     // behind barText
    QRgb note;
    QRgb barText;
    QRgb finalBadge;  // around the badge of a final picture
    QRgb preliminaryBadge;
};

// For a dark room: nothing beside a picture is bright.
inline constexpr ThemeColours kDarkColours{.window = 0x1b1d20,
                                           .field = 0x24272b,
                                           .otherRow = 0x2a2e33,
                                           .button = 0x2f343a,
                                           .tip = 0x33383e,
                                           .text = 0xd6d9dc,
                                           .faintText = 0xb3b8bd,
                                           .disabledText = 0x858c93,
                                           .link = 0x8cc7d4,
                                           .line = 0x7a828b,
                                           .accent = 0x5aa9bd,
                                           .selection = 0x1f5563,
                                           .selectionText = 0xf2f5f6,
                                           .onAccent = 0x101214,
                                           .error = 0x7a1f1f,
                                           .note = 0x5c4a12,
                                           .barText = 0xffffff,
                                           .finalBadge = 0x6fbf82,
                                           .preliminaryBadge = 0xd9a441};

inline constexpr ThemeColours kHighContrastColours{.window = 0x000000,
                                                   .field = 0x000000,
                                                   .otherRow = 0x1a1a1a,
                                                   .button = 0x1a1a1a,
                                                   .tip = 0x000000,
                                                   .text = 0xffffff,
                                                   .faintText = 0xd0d0d0,
                                                   .disabledText = 0xa0a0a0,
                                                   .link = 0xffff00,
                                                   .line = 0xffffff,
                                                   .accent = 0xffff00,
                                                   .selection = 0x4d4d4d,
                                                   .selectionText = 0xffffff,
                                                   .onAccent = 0x000000,
                                                   .error = 0x8b0000,
                                                   .note = 0x4a3b00,
                                                   .barText = 0xffffff,
                                                   .finalBadge = 0x00ff00,
                                                   .preliminaryBadge = 0xffa500};

struct ColourPair {
    const char* what;
    QRgb front;
    QRgb back;
};

// Text and its ground.
constexpr std::array<ColourPair, 11> textPairs(const ThemeColours& c) {
    return {{{"text on the window", c.text, c.window},
             {"text in a field", c.text, c.field},
             {"text in every other row", c.text, c.otherRow},
             {"text on a button", c.text, c.button},
             {"text of a tool tip", c.text, c.tip},
             {"text in an empty field", c.faintText, c.field},
             {"text that is chosen", c.selectionText, c.selection},
             {"a link on the window", c.link, c.window},
             {"a link in a field", c.link, c.field},
             {"an error", c.barText, c.error},
             {"a note", c.barText, c.note}}};
}

// Lines, marks and disabled text, and their ground.
constexpr std::array<ColourPair, 14> linePairs(const ThemeColours& c) {
    return {{{"disabled text on the window", c.disabledText, c.window},
             {"disabled text in a field", c.disabledText, c.field},
             {"disabled text in every other row", c.disabledText, c.otherRow},
             {"disabled text on a button", c.disabledText, c.button},
             {"the line of a control on the window", c.line, c.window},
             {"the line of a field", c.line, c.field},
             {"the line of a button", c.line, c.button},
             {"focus on the window", c.accent, c.window},
             {"focus on a field", c.accent, c.field},
             {"focus on a button", c.accent, c.button},
             {"focus on what is chosen", c.accent, c.selection},
             {"a check mark", c.onAccent, c.accent},
             {"the badge of a final picture", c.finalBadge, c.window},
             {"the badge of a preliminary picture", c.preliminaryBadge, c.window}}};
}

}  // namespace macula::viewer
