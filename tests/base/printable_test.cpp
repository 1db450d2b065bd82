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

}  // namespace
}  // namespace macula
