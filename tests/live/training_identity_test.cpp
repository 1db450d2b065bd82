#include "live/model/training_identity.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {
namespace {

class ModelKey : public testing::Test {
  protected:
    std::string key() const { return trainingIdentity(volume_, function_, clip_, lights_); }
    // What a training of `before` says when it may not go on with what there is now.
    std::string refusal(const std::string& before) const {
        const auto checked = checkTrainingIdentity(before, key(), "model.macula");
        return checked ? std::string() : checked.error().message.english();
    }

    Volume volume_ = phantom::make({.size = {24, 20, 16}});
    TransferFunction function_ = scene::choosePreset("cinematic-bone")->function;
    Clip clip_;
    trace::Environment lights_ = *scene::chooseLights("studio");
};

TEST_F(ModelKey, IsOfWhatThingsAreAndNotOfTheirNames) {
    const std::string before = key();
    volume_ = phantom::make({.size = {24, 20, 16}});
    function_.name = "doe-john";
    function_.title = "Another title";
    EXPECT_EQ(key(), before);
    EXPECT_EQ(before.find("doe"), std::string::npos);
    EXPECT_EQ(refusal(before), "");
}

TEST_F(ModelKey, TellsWhatIsNotTheSame) {
    const std::string before = key();
    function_.opacity.front().value -= 1.0;
    EXPECT_EQ(refusal(before), "The saved training is of another preset.");
    lights_ = *scene::chooseLights("even");
    EXPECT_EQ(refusal(before), "The saved training is of another preset and other lights.");
    volume_ = phantom::make({.size = {24, 20, 17}});
    clip_ = clipFor(*scene::chooseClip("left-half"), volume_);
    EXPECT_EQ(refusal(before),
              "The saved training is of another study and another preset and another clip and other lights.");
    EXPECT_EQ(refusal("of another program\n"), "The saved training does not say what its pictures show.");
}

TEST_F(ModelKey, IsOfWhatIsBesideTheVolumeToo) {
    Additions added;
    added.second.emplace();
    added.second->volume = in16Bits(std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}})));
    added.second->function = std::make_shared<const TransferFunction>(function_);
    const auto keyWith = [&] { return trainingIdentity(volume_, function_, clip_, lights_, added); };
    const std::string mixed = keyWith();
    EXPECT_EQ(keyWith(), mixed);
    EXPECT_EQ(refusal(mixed), "The saved training is of another second volume or other colours of segments.");
    const auto checked = checkTrainingIdentity(key(), mixed, "model.macula");
    ASSERT_FALSE(checked);
    EXPECT_NE(checked.error().message.english().find("another second volume"), std::string::npos);
    added.second->secondFromVolumeMm[3].x = 1.0;
    EXPECT_NE(keyWith(), mixed);
    EXPECT_FALSE(checkTrainingIdentity(mixed, keyWith(), "model.macula"));
    EXPECT_TRUE(checkTrainingIdentity(keyWith(), keyWith(), "model.macula").ok());
    EXPECT_EQ(trainingIdentity(volume_, function_, clip_, lights_, Additions{}), key())
        << "nothing is as before";
    EXPECT_EQ(refusal("additions of nothing\n"), "The saved training does not say what its pictures show.");
}

}  // namespace
}  // namespace macula::live
