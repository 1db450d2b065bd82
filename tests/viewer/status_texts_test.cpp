// What the status line says of the preview.
#include "viewer/status/status_texts.h"

#include <gtest/gtest.h>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class StatusTextsTest : public test::OffscreenTest {};

TEST_F(StatusTextsTest, SayAtTheFirstStartWhyThePreviewTakesLonger) {
    using hybrid::ModelStage;
    const auto says = [](ModelStage stage, bool isSharp, bool isFirstStart) {
        const hybrid::ModelNews model{.stage = stage, .steps = 30, .isSharp = isSharp};
        return modelText(model, isFirstStart) + '|' + aboutModel(model, isFirstStart);
    };
    for (const auto stage : {ModelStage::searching, ModelStage::learning}) {
        EXPECT_TRUE(says(stage, false, true).contains(QStringLiteral("longer at the first start|At its")));
        EXPECT_FALSE(says(stage, false, false).contains(QStringLiteral("first start")));
    }
    EXPECT_FALSE(says(ModelStage::learning, true, true).contains(QStringLiteral("first start")));
    EXPECT_FALSE(says(ModelStage::none, false, true).contains(QStringLiteral("first start")));
}

}  // namespace
}  // namespace macula::viewer
