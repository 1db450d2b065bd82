// A store with much in it.
//
// MACULA_SESSION_STUDIES: how many studies; 1 000 unless it is set.
#include "session/large_store.h"

#include <chrono>

#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

using test::isOk;
using test::valueOf;

class LargeStores : public test::StoreTest {
  protected:
    template <class Work>
    static auto timed(const char* what, Work&& work) {
        const auto start = std::chrono::steady_clock::now();
        auto result = work();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        std::printf("%-28s %7.1f ms\n", what, time.count());
        return result;
    }
};

// Times are printed and not judged: machines differ.
TEST_F(LargeStores, AreListedSearchedAndKeptToTheCap) {
    const int count = test::largeStudies(1'000);
    const int modelCount = count / test::kStudiesOfAModel;
    const int half = modelCount / 2;
    timed("filling", [&] { return test::fillLargeStore(folder_, count), 0; });
    StoreOptions with = options();
    Store store = timed("opening", [&] { return open(with); });
    const auto studies = timed("listing studies", [&] { return valueOf(store.listStudies()); });
    ASSERT_EQ(studies.entries.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(studies.damaged, 0u);
    EXPECT_EQ(studies.entries.front().identity, test::largeStudy(count - 1)) << "opened last";
    std::size_t series = 0;
    std::size_t models = 0;
    std::uint64_t bytes = 0;
    for (const StudyEntry& study : studies.entries) {
        series += study.series;
        models += study.models;
        bytes += study.modelBytes;
    }
    EXPECT_EQ(series, studies.entries.size() * test::kSeriesOfAStudy);
    EXPECT_EQ(models, static_cast<std::size_t>(modelCount));
    EXPECT_EQ(bytes, models * test::kLargeModelBytes);
    EXPECT_EQ(timed("listing models", [&] { return valueOf(store.listModels()); }).entries.size(), models);
    EXPECT_EQ(
        timed("listing series of a study", [&] { return valueOf(store.listSeries(test::largeStudy(77))); })
            .entries.size(),
        5u);
    EXPECT_TRUE(
        timed("finding a model", [&] { return valueOf(store.findModel(test::largeModelKey(half))); }));
    EXPECT_EQ(
        timed("nearest models", [&] { return valueOf(store.nearestModels(test::largeModelKey(half), 8)); })
            .size(),
        1u);
    const auto saved = timed("saving 1 MB", [&] {
        return valueOf(store.saveModel(test::keyOf("new"), test::blobOf(1, 1'000'000)));
    });
    EXPECT_EQ(saved.evicted.models, 0u);
    const std::uint64_t left =
        static_cast<std::uint64_t>(modelCount - half) * test::kLargeModelBytes + 1'000'000;
    const auto evicted = timed("evicting half of them", [&] { return valueOf(store.evictModels(left)); });
    EXPECT_EQ(evicted.models, static_cast<std::size_t>(half));
    EXPECT_LE(evicted.bytesLeft, left);
    EXPECT_EQ(valueOf(store.findModel(test::largeModelKey(half - 1))), std::nullopt);
    EXPECT_TRUE(valueOf(store.findModel(test::largeModelKey(half)))) << "used later";
    const auto opened = this->opened("new", "1", "new");
    EXPECT_TRUE(isOk(timed("recording what was opened", [&] { return store.recordOpened(opened); })));
    with.check = StoreOptions::Check::full;
    EXPECT_FALSE(timed("opening with a full check", [&] { return open(with); }).notes().setAside);
    EXPECT_EQ(timed("purging a study",
                    [&] { return valueOf(store.purgeStudy(test::largeStudy(5), DamagedFiles::keep)); })
                  .volumes,
              5u);
}

}  // namespace
}  // namespace macula::session
