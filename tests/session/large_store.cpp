#include "session/large_store.h"

#include <algorithm>

#include "session/rows.h"
#include "session/store_state.h"
#include "session/support.h"

namespace macula::session::test {

namespace {

constexpr std::int64_t kStartMs = 1'700'000'000'000;

std::string volumeName(int series) {
    return "volume " + std::to_string(series);
}

void putStudies(Connection& connection, int count) {
    RowWriter studies(connection, kStudies);
    RowWriter seriesRows(connection, kSeries);
    RowWriter volumes(connection, kVolumes);
    RowWriter links(connection, kSeriesVolumes);
    for (int i = 0; i < count; ++i) {
        const std::int64_t at = kStartMs + i;
        studies.put({{largeStudy(i), Value(), at, at}});
        for (int j = 0; j < kSeriesOfAStudy; ++j) {
            const int number = kSeriesOfAStudy * i + j;
            const std::string series = digestOf("series " + std::to_string(number));
            const std::string volume = digestOf(volumeName(number));
            seriesRows.put({{series, largeStudy(i), Value(), at, at}});
            volumes.put({{volume, at, at}});
            links.put({{series, volume}});
        }
    }
}

}  // namespace

int largeStudies(int otherwise) {
    return std::max(numberFromEnvironment("MACULA_SESSION_STUDIES", otherwise), 100);
}

std::string largeStudy(int i) {
    return digestOf("study " + std::to_string(i));
}

// Two models of each volume that has any.
ModelKey largeModelKey(int i) {
    return keyOf(volumeName(i / 2 * 20), i % 2 == 0 ? "bone" : "lung");
}

void fillLargeStore(const std::filesystem::path& folder, int studies) {
    valueOf(Store::open({.folder = folder}));
    const auto connection = valueOf(connect(folder / "sessions.db", {}));
    ASSERT_TRUE(isOk(inTransaction(*connection, [&]() -> Result<void> {
        putStudies(*connection, studies);
        for (int i = 0; i < studies / kStudiesOfAModel; ++i) {
            ModelInfo info{.id = i + 1, .key = largeModelKey(i), .bytes = kLargeModelBytes};
            info.checksum = digestOf("blob " + std::to_string(i));
            info.createdMs = info.savedMs = info.usedMs = kStartMs + i;
            putRow(*connection, kModels, rowOf(info));
        }
        return {};
    })));
}

}  // namespace macula::session::test
