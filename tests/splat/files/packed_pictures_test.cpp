// Pictures that were packed once are not packed again.
#include "pipeline/splat/files/packed_pictures.h"

#include <gtest/gtest.h>

#include <sstream>

#include "pipeline/splat/files/byte_planes.h"
#include "pipeline/splat/files/training_file.h"
#include "splat/training_support.h"

namespace macula::splat {
namespace {

using Views = std::vector<std::shared_ptr<const TrainingView>>;

Views viewsOf(const TrainingState& state) {
    Views views;
    for (const TrainingState::View& view : state.views) views.push_back(view.given);
    return views;
}

std::vector<std::byte> plain(const TrainingView& view) {
    const auto bytes = std::as_bytes(std::span(view.pixels));
    return {bytes.begin(), bytes.end()};
}

TEST(PackedPictures, ArePackedOnceAndForgottenWithTheirViews) {
    Views views = viewsOf(testing::randomState(3, 0, 3, {9, 8}, 41));
    PackedPictures packed;
    ASSERT_TRUE(packed.pack(views).ok());
    std::vector<const std::byte*> places;
    for (const auto& view : views) {
        std::vector<std::byte> back(view->pixels.size() * sizeof(glm::vec4));
        EXPECT_TRUE(unpackPlanes(packed.of(view), sizeof(glm::vec4), back).value());
        EXPECT_EQ(back, plain(*view));
        places.push_back(packed.of(view).data());
    }
    // One goes, one of the same size comes, another is named twice.
    const std::weak_ptr<const TrainingView> gone = views[0];
    views[0] = std::make_shared<const TrainingView>(*views[1]);
    views.push_back(views[2]);
    EXPECT_TRUE(gone.expired()) << "no view is held";
    ASSERT_TRUE(packed.pack(views).ok());
    EXPECT_EQ(packed.of(views[1]).data(), places[1]);
    EXPECT_EQ(packed.of(views[2]).data(), places[2]);
    EXPECT_NE(packed.of(views[0]).data(), places[1]);
    EXPECT_EQ(packed.of(views[0]).size(), packed.of(views[1]).size());
    ASSERT_TRUE(packed.pack(Views{views[0]}).ok());
    EXPECT_DEATH((void)packed.of(views[1]), "packed_");
    ASSERT_TRUE(packed.pack({}).ok());
}

TEST(PackedPictures, ChangeNothingInAFile) {
    const TrainingState state = testing::randomState(5, 1, 3, {17, 9}, 43);
    std::ostringstream alone;
    ASSERT_TRUE(writeTraining(alone, state).ok());
    PackedPictures packed;
    for (int time = 0; time < 2; ++time) {
        ASSERT_TRUE(packed.pack(viewsOf(state)).ok());
        std::ostringstream stream;
        ASSERT_TRUE(writeTraining(stream, state, {}, packed).ok());
        EXPECT_EQ(stream.str(), alone.str());
    }
}

}  // namespace
}  // namespace macula::splat
