// How fast a store is on a disk: bench_session [FOLDER]. docs/measurements/session.md tells how to call it.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>

#include "session/blob_files.h"
#include "session/large_store.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::session::test {
namespace {

namespace fs = std::filesystem;

struct Times {
    double median = 0.0;
    double worst = 0.0;
};

// Milliseconds of so many calls.
Times timesOf(int count, const std::function<void(int)>& work) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work(i);
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(times);
    return {times[times.size() / 2], times.back()};
}

void print(const std::string& what, Times times) {
    std::printf("%-44s %8.1f %8.1f\n", what.c_str(), times.median, times.worst);
}

SQLite::Database makeDatabase(const fs::path& file, const std::string& mode) {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    sqlite.exec("PRAGMA journal_mode = " + mode +
                "; PRAGMA synchronous = FULL; PRAGMA secure_delete = ON; CREATE TABLE t (a INTEGER PRIMARY "
                "KEY, b BLOB)");
    return sqlite;
}

void compareJournals(const fs::path& folder) {
    for (const char* mode : {"TRUNCATE", "DELETE", "PERSIST", "WAL"}) {
        SQLite::Database sqlite = makeDatabase(folder / mode, mode);
        print(std::string("commit of one row, ") + mode, timesOf(100, [&](int) {
                  SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
                  sqlite.exec("INSERT INTO t (b) VALUES (hex(randomblob(100)))");
                  transaction.commit();
              }));
    }
}

void writeRow(SQLite::Database& sqlite, std::span<const std::byte> blob) {
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement insert(sqlite, "INSERT OR REPLACE INTO t VALUES (1, ?)");
    insert.bindNoCopy(1, blob.data(), static_cast<int>(blob.size()));
    insert.exec();
    transaction.commit();
}

// A file is written, synchronised and renamed, and its checksum is made; a row has none.
void compareBlobs(const fs::path& folder, std::size_t megabytes) {
    constexpr int kTimes = 9;
    const std::string size = std::to_string(megabytes) + " MB, ";
    const auto blobs = valueOf(BlobFiles::open(folder / "files"));
    std::vector<std::byte> blob = blobOf(1, megabytes * 1'000'000);
    std::string digest;
    print(size + "file, write", timesOf(kTimes, [&](int i) {
              blob[100] = static_cast<std::byte>(i);
              const auto prepared = valueOf(blobs.prepare(blob));
              EXPECT_TRUE(isOk(blobs.putInPlace(prepared)));
              digest = prepared.digest;
          }));
    print(size + "file, read", timesOf(kTimes, [&](int) {
              EXPECT_EQ(valueOf(blobs.read(digest, blob.size())).bytes.size(), blob.size());
          }));
    for (const char* mode : {"TRUNCATE", "WAL"}) {
        SQLite::Database sqlite = makeDatabase(folder / (size + mode), mode);
        print(size + "row, write, " + mode, timesOf(kTimes, [&](int i) {
                  blob[100] = static_cast<std::byte>(i);
                  writeRow(sqlite, blob);
              }));
        print(size + "row, read, " + mode, timesOf(kTimes, [&](int) {
                  SQLite::Statement select(sqlite, "SELECT b FROM t WHERE a = 1");
                  EXPECT_TRUE(select.executeStep());
                  const SQLite::Column column = select.getColumn(0);
                  const auto* first = static_cast<const std::byte*>(column.getBlob());
                  const std::vector<std::byte> copy(first, first + column.getBytes());
                  EXPECT_EQ(copy.size(), blob.size());
              }));
    }
}

void measureStore(const fs::path& folder, std::size_t megabytes) {
    const std::string size = std::to_string(megabytes) + " MB, ";
    Store store = valueOf(Store::open({.folder = folder / "store"}));
    std::vector<std::byte> blob = blobOf(1, megabytes * 1'000'000);
    print(size + "store, save over the one before", timesOf(9, [&](int i) {
              blob[100] = static_cast<std::byte>(i);
              EXPECT_TRUE(isOk(store.saveModel(keyOf("chest"), blob)));
          }));
    print(size + "store, find and read", timesOf(9, [&](int) {
              EXPECT_TRUE(isOk(store.readModel(*valueOf(store.findModel(keyOf("chest"))))));
          }));
}

void measureLargeStore(const fs::path& folder) {
    const int studies = largeStudies(10'000);
    fillLargeStore(folder / "large", studies);
    const StoreOptions options{.folder = folder / "large"};
    print("many studies, open", timesOf(5, [&](int) { valueOf(Store::open(options)); }));
    print("many studies, open and list them", timesOf(5, [&](int) {
              Store store = valueOf(Store::open(options));
              EXPECT_EQ(valueOf(store.listStudies()).entries.size(), static_cast<std::size_t>(studies));
          }));
    Store store = valueOf(Store::open(options));
    print("many studies, list them", timesOf(9, [&](int) { valueOf(store.listStudies()); }));
    print("many studies, find a model",
          timesOf(9, [&](int i) { valueOf(store.findModel(largeModelKey(i))); }));
    print("many studies, touch a model",
          timesOf(9, [&](int i) { EXPECT_TRUE(isOk(store.touchModel(largeModelKey(i)))); }));
}

}  // namespace
}  // namespace macula::session::test

int main(int argc, char** argv) {
    using namespace macula::session::test;
    const fs::path parent = argc > 1 ? argv[1] : fs::temp_directory_path();
    const fs::path folder = parent / "macula-bench-session";
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::printf("%-44s %8s %8s\n", "milliseconds", "median", "worst");
    compareJournals(folder);
    for (const std::size_t megabytes : {1, 10, 50}) compareBlobs(folder, megabytes);
    for (const std::size_t megabytes : {1, 10, 50}) measureStore(folder, megabytes);
    measureLargeStore(folder);
    fs::remove_all(folder);
    return 0;
}
