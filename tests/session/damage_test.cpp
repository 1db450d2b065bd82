// Files with changed bytes: never a crash, never a wrong value that passes for a right one.
//
// MACULA_SESSION_MUTATIONS: how many changed databases, and how many changed blobs; 60 unless it is set.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <map>
#include <random>

#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::blobOf;
using test::digestOf;
using test::isOk;
using test::keyOf;
using test::troubleIn;
using test::valueOf;

constexpr int kStudies = 12;
constexpr int kModels = 6;
constexpr int kDocuments = 8;

class Damage : public test::StoreTest {
  protected:
    Damage() {
        Store store = open();
        for (int i = 0; i < kStudies; ++i) EXPECT_TRUE(isOk(store.recordOpened(openedOf(i))));
        for (int i = 0; i < kModels; ++i)
            EXPECT_TRUE(isOk(store.saveModel(modelKey(i), blobOf(number(i), 3000))));
        for (int i = 0; i < kDocuments; ++i)
            EXPECT_TRUE(isOk(store.putDocument(documentId(i), i, jsonOf(i), {})));
        database_ = test::textOf(folder_ / "sessions.db");
    }
    static std::uint32_t number(int i) { return static_cast<std::uint32_t>(i); }
    OpenedVolume openedOf(int i) const {
        OpenedVolume volume = opened(std::to_string(i), "1", "volume " + std::to_string(i));
        volume.readableStudy = "readable " + std::to_string(i);
        return volume;
    }
    static ModelKey modelKey(int i) {
        return keyOf("volume " + std::to_string(i / 2), std::to_string(i % 2));
    }
    static DocumentId documentId(int i) {
        return {DocumentKind::view, studyIdentity(std::to_string(i / 2)), "view " + std::to_string(i % 2)};
    }
    // The longer ones go over several pages.
    static std::string jsonOf(int i) {
        return "{\"n\": \"" + std::string(static_cast<std::size_t>(i * i) * 200, static_cast<char>('a' + i)) +
               "\"}";
    }
    // Whatever the store still gives is as it was; says how much that is.
    std::size_t expectNothingWrong(Store& store) {
        std::size_t right = 0;
        const auto studies = store.listStudies();
        if (studies.ok()) {
            for (const StudyEntry& study : studies->entries) {
                if (!study.readable) continue;  // made for a row whose own was lost
                const std::string i = study.readable->substr(study.readable->find(' ') + 1);
                EXPECT_EQ(study.identity, studyIdentity(i));
                EXPECT_EQ(study.lastOpenedMs, nowMs_);
                ++right;
            }
        }
        for (int i = 0; i < kModels; ++i) {
            const auto info = store.findModel(modelKey(i));
            if (!info || !*info) continue;
            const auto model = store.readModel(**info);
            if (!model) continue;
            EXPECT_EQ(model->blob, blobOf(number(i), 3000));
            ++right;
        }
        for (int i = 0; i < kDocuments; ++i) {
            const auto document = store.getDocument(documentId(i));
            if (!document || !*document) continue;
            EXPECT_EQ((*document)->json, jsonOf(i));
            EXPECT_EQ((*document)->version, i);
            ++right;
        }
        return right;
    }
    static constexpr std::size_t kAll = kStudies + kModels + kDocuments;
    std::string database_;
};

std::string mutated(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    switch (below(5)) {
        case 0:  // a bit
            bytes[below(bytes.size())] ^= static_cast<char>(1u << below(8));
            break;
        case 1:  // some bytes
            for (std::size_t i = 0, n = 1 + below(64); i < n; ++i)
                bytes[below(bytes.size())] = static_cast<char>(below(256));
            break;
        case 2:  // a sector of zeros
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() / 512) * 512), 512,
                        '\0');
            break;
        case 3:  // cut off
            bytes.resize(below(bytes.size()));
            break;
        default: {  // a page in the place of another
            const std::size_t pages = bytes.size() / 4096;
            const std::string page = bytes.substr(below(pages) * 4096, 4096);
            bytes.replace(below(pages) * 4096, 4096, page);
        }
    }
    return bytes;
}

TEST_F(Damage, OfTheDatabaseGivesNothingWrong) {
    const int count = test::numberFromEnvironment("MACULA_SESSION_MUTATIONS", 60);
    std::mt19937 random(29);
    std::map<std::string, int> outcomes;
    std::size_t right = 0;
    for (int i = 0; i < count; ++i) {
        test::putText(folder_ / "sessions.db", mutated(database_, random));
        // Models are set aside as well, and blobs moved with a damaged file.
        for (int model = 0; model < kModels; ++model) {
            const auto blob = blobOf(number(model), 3000);
            const std::string bytes(reinterpret_cast<const char*>(blob.data()), blob.size());
            test::putText(folder_ / "models" / (digestOf(bytes) + ".model"), bytes);
        }
        auto store = Store::open(options());
        if (!store) {
            const auto trouble = troubleOf(store.error());
            EXPECT_TRUE(trouble == Trouble::newerSchema || trouble == Trouble::notOurs)
                << store.error().message;
            ++outcomes[store.error().message.english()];
            continue;
        }
        ++outcomes[store->notes().setAside ? "set aside" : store->notes().isNew ? "empty" : "opened"];
        right += expectNothingWrong(*store);
        // It can be used on.
        if (store->notes().setAside) {
            EXPECT_TRUE(isOk(store->saveModel(keyOf("new"), blobOf(77, 100)))) << i;
        }
    }
    for (const auto& [outcome, times] : outcomes) std::printf("%5d %s\n", times, outcome.c_str());
    std::printf("%.1f %% of all values were given\n", 100.0 * static_cast<double>(right) / (count * kAll));
}

TEST_F(Damage, IsRescuedFromWithoutTheTree) {
    // The page with the schema loses its head: nothing leads to a row any more.
    std::string bytes = database_;
    bytes.replace(100, 8, std::string(8, '\xff'));
    test::putText(folder_ / "sessions.db", bytes);
    Store store = open();
    ASSERT_TRUE(store.notes().setAside);
    const SetAside aside = *store.notes().setAside;
    EXPECT_EQ(aside.modelsRescued, static_cast<std::size_t>(kModels));
    EXPECT_EQ(aside.documentsRescued, static_cast<std::size_t>(kDocuments));
    EXPECT_EQ(expectNothingWrong(store), kAll);
    EXPECT_EQ(valueOf(store.listAudit(1000)).entries.size(), static_cast<std::size_t>(kStudies));
    EXPECT_EQ(test::textOf(aside.folder / "sessions.db"), bytes) << "as it was";
    Progress progress;
    EXPECT_TRUE(valueOf(store.verify(progress)).isSound());
    EXPECT_FALSE(open().notes().setAside);
}

TEST_F(Damage, OfAllKeepsBlobsBesideTheFile) {
    test::putText(folder_ / "sessions.db", std::string(20'000, 'x'));
    Store store = open();
    ASSERT_TRUE(store.notes().setAside);
    EXPECT_EQ(store.notes().setAside->rowsRescued, 0u);
    EXPECT_TRUE(fs::is_empty(folder_ / "models"));
    EXPECT_EQ(test::filesBelow(store.notes().setAside->folder / "models").size(), std::size_t{kModels});
}

// Blobs are written after the tables are: without tables, something is lost.
TEST_F(Damage, ThatEmptiesTheFileKeepsBlobs) {
    test::putText(folder_ / "sessions.db", "");
    Store store = open();
    ASSERT_TRUE(store.notes().setAside);
    EXPECT_TRUE(fs::is_empty(folder_ / "models"));
    EXPECT_EQ(test::filesBelow(store.notes().setAside->folder / "models").size(), std::size_t{kModels});
    ASSERT_TRUE(isOk(store.collectGarbage()));
    EXPECT_EQ(test::filesBelow(store.notes().setAside->folder / "models").size(), std::size_t{kModels});
}

TEST_F(Damage, OfAReferenceIsFoundByAFullCheck) {
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(sqlite.exec("DELETE FROM studies WHERE readable = 'readable 5'"), 1);
    }
    Progress progress;
    EXPECT_FALSE(valueOf(open().verify(progress)).isDatabaseSound);
    StoreOptions with = options();
    with.check = StoreOptions::Check::full;
    Store store = open(with);
    EXPECT_TRUE(store.notes().setAside);
    EXPECT_TRUE(valueOf(store.verify(progress)).isSound());
    EXPECT_EQ(expectNothingWrong(store), kAll - 1) << "all but the readable text of that study";
}

TEST_F(Damage, OfALinkIsCountedAndNotShown) {
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(sqlite.exec("UPDATE series_volumes SET row_check = row_check + 1"), kStudies);
    }
    const auto series = valueOf(open().listSeries(studyIdentity("3")));
    ASSERT_EQ(series.entries.size(), 1u);
    EXPECT_TRUE(series.entries[0].volumes.empty());
    EXPECT_EQ(series.damaged, 1u);
}

TEST_F(Damage, OfAStudyOrAModelIsCountedAndNotListed) {
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(
            sqlite.exec("UPDATE studies SET last_opened = last_opened + 1 WHERE readable = 'readable 4'"), 1);
        EXPECT_EQ(sqlite.exec("UPDATE studies SET readable = NULL WHERE readable = 'readable 5'"), 1);
        EXPECT_EQ(sqlite.exec("UPDATE models SET bytes = bytes + 1000 WHERE id = 1"), 1);
    }
    const auto studies = valueOf(open().listStudies());
    EXPECT_EQ(studies.damaged, 2u);
    ASSERT_EQ(studies.entries.size(), std::size_t{kStudies - 2});
    for (const StudyEntry& study : studies.entries) {
        EXPECT_NE(study.readable, "readable 4");
        EXPECT_NE(study.identity, studyIdentity("5"));
        if (study.identity == studyIdentity("0")) {
            EXPECT_EQ(study.models, 1u) << "of two";
            EXPECT_EQ(study.modelBytes, 3000u);
        }
    }
}

TEST_F(Damage, IsNotWhatOtherToolsMeasure) {
    SQLite::Database((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE).exec("ANALYZE");
    EXPECT_FALSE(open().notes().setAside);
}

TEST_F(Damage, OfAnIndexIsFoundByAFullCheck) {
    // An entry of the index by key gets another key: quick_check does not compare tables and indexes.
    std::string bytes = database_;
    const std::string digest = modelKey(0).digest();
    std::size_t last = std::string::npos;
    for (std::size_t at = bytes.find(digest); at != std::string::npos; at = bytes.find(digest, at + 1))
        last = at;
    ASSERT_NE(last, std::string::npos);
    bytes[last + 63] = bytes[last + 63] == '0' ? '1' : '0';
    test::putText(folder_ / "sessions.db", bytes);
    {
        Store store = open();
        Progress progress;
        const auto verified = valueOf(store.verify(progress));
        EXPECT_FALSE(verified.isSound());
        EXPECT_LE(expectNothingWrong(store), kAll);
    }
    StoreOptions with = options();
    with.check = StoreOptions::Check::full;
    Store store = open(with);
    EXPECT_TRUE(store.notes().setAside);
    EXPECT_EQ(expectNothingWrong(store), kAll);
}

TEST_F(Damage, OfBlobsIsAlwaysSeen) {
    const int count = test::numberFromEnvironment("MACULA_SESSION_MUTATIONS", 60);
    std::mt19937 random(30);
    Store store = open();
    const auto blob = blobOf(5, 20'000);
    const std::string whole(reinterpret_cast<const char*>(blob.data()), blob.size());
    for (int i = 0; i < count; ++i) {
        const ModelInfo info = valueOf(store.saveModel(keyOf("damaged"), blob)).info;
        const std::string bytes = mutated(whole, random);
        test::putText(folder_ / "models" / (info.checksum + ".model"), bytes);
        const auto model = store.readModel(info);
        if (bytes == whole) {
            EXPECT_TRUE(model.ok());
        } else {
            EXPECT_EQ(troubleIn(model), Trouble::modelDamaged) << i;
        }
    }
}

}  // namespace
}  // namespace macula::session
