#include "app/model/model_key.h"

#include <gtest/gtest.h>

#include "app/choice/clip_choice.h"
#include "app/choice/lights_choice.h"
#include "app/choice/preset_choice.h"
#include "base/phantom.h"

namespace macula::app {
namespace {

class ModelKey : public testing::Test {
  protected:
    std::string key() const { return trainingKey(volume_, function_, clip_, lights_); }
    // What a training of `before` says when it may not go on with what there is now.
    std::string refusal(const std::string& before) const {
        const auto checked = checkTrainingKey(before, key(), "model.macula");
        return checked ? std::string() : checked.error().message;
    }

    Volume volume_ = phantom::make({.size = {24, 20, 16}});
    TransferFunction function_ = choosePreset("cinematic-bone")->function;
    Clip clip_;
    trace::Environment lights_ = *chooseLights("studio");
};

TEST_F(ModelKey, isOfWhatThingsAreAndNotOfTheirNames) {
    const std::string before = key();
    volume_ = phantom::make({.size = {24, 20, 16}});
    function_.name = "doe-john";
    function_.title = "Another title";
    EXPECT_EQ(key(), before);
    EXPECT_EQ(before.find("doe"), std::string::npos);
    EXPECT_EQ(refusal(before), "");
}

TEST_F(ModelKey, tellsWhatIsNotTheSame) {
    const std::string before = key();
    function_.opacity.front().value -= 1.0;
    EXPECT_EQ(refusal(before), "The saved training is of another preset.");
    lights_ = *chooseLights("even");
    EXPECT_EQ(refusal(before), "The saved training is of another preset and other lights.");
    volume_ = phantom::make({.size = {24, 20, 17}});
    clip_ = clipFor(*chooseClip("left-half"), volume_);
    EXPECT_EQ(refusal(before),
              "The saved training is of another study and another preset and another clip and other lights.");
    EXPECT_EQ(refusal("of another program\n"), "The saved training does not say what its pictures show.");
}

}  // namespace
}  // namespace macula::app
