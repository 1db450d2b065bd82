// What a bar shows in the columns that there are.
#include "base/progress_bar.h"

#include <gtest/gtest.h>

namespace macula {
namespace {

TEST(ProgressBar, FitsAndSaysHowLongItTakes) {
    const ProgressUpdate update{Text("Tracing until the noise is gone"), 0.5};
    EXPECT_EQ(progressLine({Text("Tracing"), 0.5}, -1.0, 79),
              "Tracing [" + std::string(15, '=') + std::string(15, ' ') + "]  50 %");
    EXPECT_NE(progressLine(update, 12.3, 79).find("] 50 %, 13 s left") == std::string::npos, false);
    for (const double left : {-1.0, 9.0, 5000.0, 100000.0}) {
        for (int columns = 24; columns <= 200; ++columns) {
            const std::string line = progressLine(update, left, columns);
            EXPECT_LE(line.size(), static_cast<std::size_t>(columns)) << line;
            EXPECT_NE(line.find(" 50 %"), std::string::npos) << line;
        }
    }
    const std::string narrow = progressLine(update, 90.0, 39);
    EXPECT_NE(narrow.find("90 s left"), std::string::npos) << narrow;
    EXPECT_TRUE(narrow.starts_with("Tracing until")) << narrow;
}

}  // namespace
}  // namespace macula
