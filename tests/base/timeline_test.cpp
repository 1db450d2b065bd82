#include "base/timeline.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <thread>

namespace macula {
namespace {

using std::chrono::milliseconds;

const StageTimes* find(const std::vector<StageTimes>& stages, std::string_view name) {
    for (const StageTimes& stage : stages)
        if (stage.name == name) return &stage;
    return nullptr;
}

double sumMs(const std::vector<StageTimes>& stages) {
    return std::accumulate(stages.begin(), stages.end(), 0.0,
                           [](double sum, const StageTimes& stage) { return sum + stage.ms; });
}

TEST(Timeline, AnInstantBelongsToTheInnermostStage) {
    Timeline timeline;
    const auto start = std::chrono::steady_clock::now();
    {
        const Timeline::Watch watch(timeline);
        const TimelineStage outer("outer");
        std::this_thread::sleep_for(milliseconds(3));
        for (int i = 0; i < 2; ++i) {
            const TimelineStage inner("inner");
            std::this_thread::sleep_for(milliseconds(8));
        }
    }
    const double allMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(timeline.stages().size(), 2u);
    const StageTimes* outer = find(timeline.stages(), "outer");
    const StageTimes* inner = find(timeline.stages(), "inner");
    ASSERT_TRUE(outer != nullptr && inner != nullptr);
    EXPECT_EQ(outer->times, 1u);
    EXPECT_EQ(inner->times, 2u);
    EXPECT_GE(outer->ms, 3.0);
    EXPECT_GE(inner->ms, 16.0);
    EXPECT_GE(inner->longestMs, 8.0);
    EXPECT_LE(inner->longestMs, inner->ms);
    EXPECT_LE(sumMs(timeline.stages()), allMs);
    EXPECT_LE(outer->ms, allMs - 16.0);  // what the inner ones took is not the outer one's
}

TEST(Timeline, AWaitIsTheInnermostStages) {
    Timeline timeline;
    {
        const Timeline::Watch watch(timeline);
        const TimelineStage outer("outer");
        const TimelineStage inner("inner");
        const TimelineWait wait;
        std::this_thread::sleep_for(milliseconds(4));
    }
    EXPECT_GE(find(timeline.stages(), "inner")->waitedMs, 4.0);
    EXPECT_LE(find(timeline.stages(), "inner")->waitedMs, find(timeline.stages(), "inner")->ms);
    EXPECT_EQ(find(timeline.stages(), "outer")->waitedMs, 0.0);
}

TEST(Timeline, WatchesItsThreadForAsLongAsItIsTold) {
    Timeline timeline;
    { const TimelineStage nobody("before"); }
    {
        const Timeline::Watch watch(timeline);
        std::thread([] { const TimelineStage other("another thread"); }).join();
        Timeline nested;
        {
            const Timeline::Watch within(nested);
            const TimelineStage stage("nested");
        }
        EXPECT_NE(find(nested.stages(), "nested"), nullptr);
        const TimelineStage stage("watched");
    }
    {
        const TimelineStage nobody("after");
        const TimelineWait wait;
    }
    ASSERT_EQ(timeline.stages().size(), 1u);
    EXPECT_EQ(timeline.stages()[0].name, "watched");
}

TEST(Timeline, ToldSinceAnEarlierState) {
    const std::vector<StageTimes> before{{"train", 2, 10.0, 4.0, 7.0}, {"draw", 1, 1.0, 0.0, 1.0}};
    const std::vector<StageTimes> now{
        {"train", 5, 25.0, 6.0, 9.0}, {"draw", 1, 1.0, 0.0, 1.0}, {"new", 1, 2.0, 1.0, 2.0}};
    const std::vector<StageTimes> between = since(before, now);
    ASSERT_EQ(between.size(), 2u);
    EXPECT_EQ(between[0].name, "train");
    EXPECT_EQ(between[0].times, 3u);
    EXPECT_DOUBLE_EQ(between[0].ms, 15.0);
    EXPECT_DOUBLE_EQ(between[0].waitedMs, 2.0);
    EXPECT_EQ(between[1].name, "new");
    EXPECT_TRUE(since(now, now).empty());
}

}  // namespace
}  // namespace macula
