// Several processes, and processes that are killed at any moment.
//
// MACULA_SESSION_KILLS: how often each test of Kills kills; 8 unless it is set.
// MACULA_SESSION_SECONDS: how long two processes write at once; 2 unless it is set.
#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "session/fixture.h"
#include "session/migrations.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using test::blobOf;
using test::digestOf;
using test::isOk;
using test::keyOf;
using test::valueOf;

constexpr std::uint32_t kModelNames = 5;

ModelKey keyNumber(std::uint32_t i) {
    return keyOf("chest", "preset " + std::to_string(i));
}

class Processes : public test::StoreTest {
  protected:
    StoreOptions patient() const {
        StoreOptions with = options();
        with.patience = std::chrono::seconds(10);
        return with;
    }
    void expectSound(Store& store) {
        Progress progress;
        EXPECT_FALSE(store.notes().setAside);
        const VerifyReport report = valueOf(store.verify(progress));
        EXPECT_TRUE(report.isSound());
        EXPECT_EQ(report.setAside, 0u);
    }
};

// Saves, reads what the other saves, adds to the audit trail. 0 when all went well.
int writeFor(const StoreOptions& with, std::uint32_t writer, Clock::duration time, int out) {
    auto store = Store::open(with);
    if (!store) return 2;
    const Clock::time_point end = Clock::now() + time;
    std::uint32_t count = 0;
    for (; Clock::now() < end; ++count) {
        const std::uint32_t mine = writer * 1'000'000 + count;
        if (!store->saveModel(keyOf("own", std::to_string(writer)), blobOf(mine, 5000))) return 3;
        if (!store->saveModel(keyOf("shared"), blobOf(mine, 3000))) return 4;
        const DocumentId document{DocumentKind::studyState, studyIdentity("1"),
                                  "of " + std::to_string(writer)};
        if (!store->putDocument(document, count, "{}", {})) return 5;
        for (const ModelKey& key : {keyOf("shared"), keyOf("own", std::to_string(1 - writer))}) {
            const auto info = store->findModel(key);
            if (!info) return 6;
            if (!*info) continue;
            const auto model = store->readModel(**info);
            if (!model || !test::numberOf(model->blob)) return 7;
        }
        if (count % 10 == 0 && !store->collectGarbage()) return 8;
    }
    return write(out, &count, sizeof count) == sizeof count ? 0 : 9;
}

TEST_F(Processes, TwoWriteAtOnce) {
    const std::chrono::seconds time(test::numberFromEnvironment("MACULA_SESSION_SECONDS", 2));
    int pipes[2][2];
    pid_t children[2];
    for (std::uint32_t writer = 0; writer < 2; ++writer) {
        ASSERT_EQ(pipe(pipes[writer]), 0);
        children[writer] = fork();
        if (children[writer] == 0) _exit(writeFor(patient(), writer, time, pipes[writer][1]));
    }
    std::uint32_t counts[2]{};
    for (int writer = 0; writer < 2; ++writer) {
        int status = 0;
        waitpid(children[writer], &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        ASSERT_EQ(WEXITSTATUS(status), 0);
        ASSERT_EQ(read(pipes[writer][0], &counts[writer], sizeof counts[writer]), ssize_t{sizeof counts[0]});
        EXPECT_GT(counts[writer], 3u);
    }
    std::printf("%u and %u rounds of writing\n", counts[0], counts[1]);
    StoreOptions with = patient();
    with.check = StoreOptions::Check::full;
    Store store = open(with);
    expectSound(store);
    for (std::uint32_t writer = 0; writer < 2; ++writer) {
        const auto own = valueOf(store.findModel(keyOf("own", std::to_string(writer))));
        ASSERT_TRUE(own);
        EXPECT_EQ(test::numberOf(valueOf(store.readModel(*own)).blob),
                  writer * 1'000'000 + counts[writer] - 1);
        const DocumentId document{DocumentKind::studyState, studyIdentity("1"),
                                  "of " + std::to_string(writer)};
        EXPECT_EQ(valueOf(store.getDocument(document))->version, counts[writer] - 1);
    }
    ASSERT_TRUE(isOk(store.collectGarbage()));
    EXPECT_EQ(test::filesBelow(folder_ / "models").size(), 3u);
}

TEST_F(Processes, OpenANewStoreAtOnce) {
    pid_t children[4];
    for (pid_t& child : children) {
        child = fork();
        if (child == 0) {
            auto store = Store::open(patient());
            const bool isSaved = store.ok() && store->saveModel(keyOf("chest"), blobOf(1, 100)).ok();
            _exit(isSaved ? 0 : 1);
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    Store store = open();
    expectSound(store);
}

// Kills a child at a random moment after it has begun, and gives the numbers that it told before.
template <class Work>
std::vector<std::uint32_t> killed(std::mt19937& random, int mostMicroseconds, Work&& work) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        work([&](std::uint32_t number) {
            if (write(ends[1], &number, sizeof number) != sizeof number) _exit(1);
        });
        _exit(0);
    }
    close(ends[1]);
    std::vector<std::uint32_t> told;
    std::uint32_t number = 0;
    if (read(ends[0], &number, sizeof number) == sizeof number) told.push_back(number);
    std::this_thread::sleep_for(
        std::chrono::microseconds(std::uniform_int_distribution<int>(0, mostMicroseconds)(random)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    while (read(ends[0], &number, sizeof number) == sizeof number) told.push_back(number);
    close(ends[0]);
    return told;
}

// Saves of five models in turns. With a cap of two and a half of them, each save evicts.
class Kills : public Processes {
  protected:
    static int count() { return test::numberFromEnvironment("MACULA_SESSION_KILLS", 8); }
    static constexpr std::size_t kBytes = 20'000;

    void killWhileSaving(std::uint64_t cap) {
        StoreOptions with = patient();
        with.modelCapBytes = cap;
        std::mt19937 random(41);
        std::map<std::uint32_t, std::uint32_t> saved;  // the last number of each model that was told
        std::uint32_t next = 1;
        for (int run = 0; run < count(); ++run) {
            const auto told = killed(random, 30'000, [&](const auto& tell) {
                auto store = Store::open(with);
                if (!store) return;
                for (std::uint32_t i = next;; ++i) {
                    if (!store->saveModel(keyNumber(i % kModelNames), blobOf(i, kBytes))) return;
                    tell(i);
                }
            });
            ASSERT_FALSE(told.empty());
            for (const std::uint32_t number : told) saved[number % kModelNames] = number;
            next = told.back() + 2;
            Store store = open(with);
            expectSaved(store, saved, told.back(), cap);
            saved.erase((told.back() + 1) % kModelNames);  // the one that was being saved may be there
        }
    }
    void expectSaved(Store& store, const std::map<std::uint32_t, std::uint32_t>& saved, std::uint32_t last,
                     std::uint64_t cap) {
        expectSound(store);
        for (std::uint32_t name = 0; name < kModelNames; ++name) {
            const auto info = valueOf(store.findModel(keyNumber(name)));
            // Of models that were saved before the last two evictions nothing is known.
            if (!info) {
                EXPECT_TRUE(cap < kModelNames * kBytes || !saved.contains(name));
                continue;
            }
            const auto number = test::numberOf(valueOf(store.readModel(*info)).blob);
            ASSERT_TRUE(number);
            const bool isNext = *number == last + 1;
            const auto known = saved.find(name);
            EXPECT_TRUE(known == saved.end() || *number == known->second || isNext);
        }
        EXPECT_TRUE(valueOf(store.findModel(keyNumber(last % kModelNames)))) << "the last committed one";
        std::uint64_t bytes = 0;
        for (const ModelInfo& info : valueOf(store.listModels()).entries) bytes += info.bytes;
        EXPECT_LE(bytes, cap);
        const std::size_t rows = valueOf(store.listModels()).entries.size();
        ASSERT_TRUE(isOk(store.collectGarbage()));
        EXPECT_EQ(test::filesBelow(folder_ / "models").size(), rows) << "no orphans";
    }
};

TEST_F(Kills, WhileSavingLeaveTheLastModel) {
    killWhileSaving(2'000'000'000);
}

TEST_F(Kills, WhileEvictingLeaveTheLastModel) {
    killWhileSaving(kBytes * 5 / 2);
}

// Migrations of the future, each of which makes a table and fills it.
std::vector<Migration> futureMigrations(std::vector<std::string>& texts, int number) {
    std::vector<Migration> all(migrations().begin(), migrations().end());
    texts.reserve(static_cast<std::size_t>(number));
    for (int i = 0; i < number; ++i) {
        const std::string name = "future_" + std::to_string(i);
        texts.push_back(
            "CREATE TABLE " + name +
            " (a INTEGER, b TEXT) STRICT; WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
            "FROM n WHERE i < 500) INSERT INTO " +
            name + " SELECT i, hex(zeroblob(50)) FROM n; UPDATE volumes SET last_opened = " +
            std::to_string(i) + ";");
        all.push_back({newestVersion() + 1 + i, "future", texts.back()});
    }
    return all;
}

TEST_F(Kills, WhileMigratingLeaveOneVersionOrTheNext) {
    std::vector<std::string> texts;
    const auto all = futureMigrations(texts, 40);
    std::mt19937 random(43);
    int between = 0;
    for (int run = 0; run < count(); ++run) {
        fs::remove_all(folder_);
        test::makeFixture(1, folder_);
        const fs::path file = folder_ / "sessions.db";
        killed(random, 15'000, [&](const auto& tell) {
            tell(0);
            auto connection = connect(file, {});
            if (connection.ok()) static_cast<void>(migrate(**connection, all));
        });
        const auto connection = valueOf(connect(file, {}));
        SQLite::Database& sqlite = connection->sqlite;
        EXPECT_EQ(sqlite.execAndGet("PRAGMA integrity_check").getString(), "ok");
        const int version = sqlite.execAndGet("PRAGMA user_version").getInt();
        const int future = version - newestVersion();
        between += version > 1 && version < all.back().number ? 1 : 0;
        for (int i = 0; i < 40; ++i) {
            const std::string name = "future_" + std::to_string(i);
            ASSERT_EQ(sqlite.tableExists(name), i < future) << version;
            if (i >= future) continue;
            EXPECT_EQ(sqlite.execAndGet("SELECT count(*) FROM " + name).getInt(), 500);
        }
        if (future > 0) {
            EXPECT_EQ(sqlite.execAndGet("SELECT max(last_opened) FROM volumes").getInt(), future - 1);
        }
        EXPECT_TRUE(isOk(migrate(*connection, all))) << "and it goes on";
    }
    std::printf("%d of %d were stopped between two versions\n", between, count());
}

// A store that is being made is there afterwards, or can be made.
TEST_F(Kills, WhileMakingAStoreLeaveOneThatOpens) {
    std::mt19937 random(47);
    for (int run = 0; run < count(); ++run) {
        fs::remove_all(folder_);
        killed(random, 4'000, [&](const auto& tell) {
            tell(0);
            auto store = Store::open(patient());
            if (store.ok()) static_cast<void>(store->saveModel(keyOf("chest"), blobOf(1, 1000)));
        });
        Store store = open();
        expectSound(store);
    }
}

// Rescue is stopped at any moment: the damaged file is in one place or the other.
TEST_F(Kills, WhileRescuingLoseNothing) {
    {
        Store store = open();
        ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
        for (std::uint32_t i = 0; i < kModelNames; ++i)
            ASSERT_TRUE(isOk(store.saveModel(keyNumber(i), blobOf(i, 1000))));
    }
    std::string damaged = test::textOf(folder_ / "sessions.db");
    damaged.replace(0, 200, std::string(200, 'x'));
    std::mt19937 random(53);
    for (int run = 0; run < count(); ++run) {
        fs::remove_all(folder_ / "damaged");
        test::putText(folder_ / "sessions.db", damaged);
        killed(random, 8'000, [&](const auto& tell) {
            tell(0);
            static_cast<void>(Store::open(patient()));
        });
        Store store = open(patient());
        for (std::uint32_t i = 0; i < kModelNames; ++i) {
            const auto info = valueOf(store.findModel(keyNumber(i)));
            ASSERT_TRUE(info) << run;
            EXPECT_EQ(test::numberOf(valueOf(store.readModel(*info)).blob), i);
        }
        bool isKept = false;
        for (const fs::path& file : test::filesBelow(folder_ / "damaged"))
            isKept = isKept || test::textOf(folder_ / "damaged" / file) == damaged;
        EXPECT_TRUE(isKept);
    }
}

}  // namespace
}  // namespace macula::session
