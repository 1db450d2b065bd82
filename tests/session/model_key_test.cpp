// What a model is found under, and what a study is called.
#include "session/model_key.h"

#include "session/support.h"

namespace macula::session {
namespace {

using test::digestOf;
using test::keyOf;

TEST(ModelKeys, EveryPartCountsAndItsPlaceDoesNot) {
    const ModelKey key = keyOf("chest");
    ModelKey turned = key;
    std::swap(turned.parts[0], turned.parts[1]);
    EXPECT_EQ(turned.digest(), key.digest());
    ModelKey other = key;
    other.trainer = 8;
    EXPECT_NE(other.digest(), key.digest());
    EXPECT_NE(keyOf("chest", "lung").digest(), key.digest());
    EXPECT_NE(keyOf("head").digest(), key.digest());
    other = key;
    other.parts.pop_back();
    EXPECT_NE(other.digest(), key.digest());
}

TEST(ModelKeys, AreValidOrNot) {
    ModelKey key = keyOf("chest");
    EXPECT_TRUE(key.isValid());
    key.parts.push_back(key.parts.front());
    EXPECT_FALSE(key.isValid()) << "the same name twice";
    key = keyOf("chest");
    key.parts[0].digest = "Anna";
    EXPECT_FALSE(key.isValid());
    key = keyOf("chest");
    key.parts[0].name = "Clip 1";
    EXPECT_FALSE(key.isValid());
    key = keyOf("chest");
    key.volume.pop_back();
    EXPECT_FALSE(key.isValid());
    EXPECT_TRUE((ModelKey{.volume = digestOf("a")}).isValid()) << "without parts";
}

TEST(ModelKeys, PartsGoIntoTextAndBack) {
    const ModelKey key = keyOf("chest");
    std::vector<KeyPart> parts;
    EXPECT_TRUE(partsOfText(textOfParts(key.parts), parts));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "clip");
    EXPECT_EQ(parts[1].name, "transfer-function");
    for (const char* text : {"clip", "clip=\n", "=\n", "clip=0123\n", "\n"})
        EXPECT_FALSE(partsOfText(text, parts)) << text;
    EXPECT_FALSE(partsOfText("clip=" + digestOf("a") + "\nclip=" + digestOf("a") + "\n", parts));
    EXPECT_FALSE(partsOfText("clip=" + digestOf("a"), parts)) << "cut off";
}

TEST(ModelKeys, NameWhatDiffers) {
    using Names = std::vector<std::string>;
    const ModelKey key = keyOf("chest");
    EXPECT_EQ(differences(key, key), Names{});
    EXPECT_EQ(differences(key, keyOf("chest", "lung")), Names{"transfer-function"});
    ModelKey other = keyOf("head", "lung", "half");
    other.trainer = 8;
    EXPECT_EQ(differences(key, other), (Names{"clip", "trainer", "transfer-function", "volume"}));
    other = key;
    other.parts.push_back({"lights", digestOf("studio")});
    EXPECT_EQ(differences(key, other), Names{"lights"});
    EXPECT_EQ(differences(other, key), Names{"lights"});
}

TEST(Identities, AreDigestsOfTheirOwn) {
    EXPECT_TRUE(isDigest(studyIdentity("1.2.3")));
    EXPECT_EQ(studyIdentity("1.2.3"), studyIdentity("1.2.3"));
    EXPECT_NE(studyIdentity("1.2.3"), digestOf("1.2.3"));
    EXPECT_NE(seriesIdentity("1.2", "3"), seriesIdentity("1.23", "")) << "the border counts";
    EXPECT_NE(seriesIdentity("1.2", "7"), seriesIdentity("1.3", "7")) << "a series copied to another study";
    EXPECT_FALSE(isDigest(""));
    EXPECT_FALSE(isDigest(std::string(64, 'A')));
    EXPECT_FALSE(isDigest(std::string(63, 'a')));
}

}  // namespace
}  // namespace macula::session
