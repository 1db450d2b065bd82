#include "base/printable.h"

#include <gtest/gtest.h>

namespace macula {
namespace {

TEST(Printable, TextStaysAsItIs) {
    for (const char* text : {"", "CT Abdomen 1.0", "M\u00fcller", "\u5c71\u7530", "\U0001f9b4"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, NothingSteersTheTerminal) {
    EXPECT_EQ(printable("a\x1b[2Jb"), "a?[2Jb");
    EXPECT_EQ(printable("a\r\n\tb\x7f"), "a???b?");
    EXPECT_EQ(printable("a\xc2\x9b"
                        "2J"),
              "a?2J")
        << "C1 as UTF-8";
    EXPECT_EQ(printable("a\x9b"
                        "2J"),
              "a?2J")
        << "C1 as a byte";
}

// "gnp.exe" that reads as "exe.png", and numbers that change places.
TEST(Printable, NothingTurnsTheDirection) {
    for (const char* control : {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202b",
                                "\u202c", "\u202d", "\u202e", "\u2066", "\u2067", "\u2068", "\u2069"}) {
        const std::string text = std::string("a") + control + "gnp.exe";
        EXPECT_EQ(unmixed(text), "a?gnp.exe");
        EXPECT_EQ(printable(text), "a?gnp.exe");
    }
    // Neighbours of these, Arabic and Hebrew, and what is cut off.
    for (const char* text : {"\u2027", "\u202f", "\u2065", "\u206a", "\u200d", "\u061b",
                             "\u0642\u0628\u0627\u0646\u064a", "\u05d0\u05d1", "\xe2\x80", "\xe2", ""})
        EXPECT_EQ(unmixed(text), text);
}

}  // namespace
}  // namespace macula
