#include "session/fixture.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "base/paths.h"
#include "session/support.h"

namespace macula::session::test {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kStartMs = 1'700'000'000'000;

StoreOptions fixtureOptions(const fs::path& folder) {
    return {.folder = folder, .nowMs = [now = kStartMs]() mutable { return now += 1000; }};
}

OpenedVolume chest() {
    return {.study = studyIdentity("1.2.3"),
            .series = seriesIdentity("1.2.3", "4"),
            .volume = digestOf("chest"),
            .readableStudy = "readable O'Neill",
            .readableSeries = {}};
}

std::string quoted(SQLite::Column column) {
    if (column.isNull()) return "NULL";
    if (column.isInteger()) return std::to_string(column.getInt64());
    std::string text = "'";
    for (const char c : column.getString()) text += c == '\'' ? std::string("''") : std::string(1, c);
    return text + "'";
}

std::string rowsOf(SQLite::Database& sqlite, const std::string& table) {
    std::string text;
    SQLite::Statement rows(sqlite, "SELECT * FROM " + table + " ORDER BY rowid");
    while (rows.executeStep()) {
        text += "INSERT INTO " + table + " VALUES (";
        for (int i = 0; i < rows.getColumnCount(); ++i)
            text += (i > 0 ? ", " : "") + quoted(rows.getColumn(i));
        text += ");\n";
    }
    return text;
}

}  // namespace

void fillFixture(const fs::path& folder) {
    Store store = valueOf(Store::open(fixtureOptions(folder)));
    ASSERT_TRUE(isOk(store.recordOpened(chest())));
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("nifti")})));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "lung"), blobOf(2, 2000))));
    ASSERT_TRUE(isOk(store.touchModel(keyOf("chest"))));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::studyState, studyIdentity("1.2.3"), "last"}, 1,
                                       R"({"preset": "bone"})", {})));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::calibration, "", "gpu"}, 2, R"({"ms": 4.5})", {})));
    ASSERT_TRUE(isOk(store.addAudit(AuditAction::exported, AuditKind::picture, studyIdentity("1.2.3"), 3)));
}

void expectFixture(Store& store) {
    const auto studies = valueOf(store.listStudies());
    ASSERT_EQ(studies.entries.size(), 1u);
    EXPECT_EQ(studies.entries[0].identity, studyIdentity("1.2.3"));
    EXPECT_EQ(studies.entries[0].readable, "readable O'Neill");
    EXPECT_EQ(studies.entries[0].models, 2u);
    EXPECT_EQ(valueOf(store.listSeries(studyIdentity("1.2.3"))).entries.at(0).volumes,
              std::vector{digestOf("chest")});
    for (const char* transfer : {"bone", "lung"}) {
        const auto info = valueOf(store.findModel(keyOf("chest", transfer)));
        ASSERT_TRUE(info);
        EXPECT_EQ(numberOf(valueOf(store.readModel(*info)).blob), transfer == std::string("bone") ? 1u : 2u);
    }
    EXPECT_EQ(valueOf(store.listModels()).entries.at(0).key.digest(), keyOf("chest").digest()) << "used last";
    const auto session =
        valueOf(store.getDocument({DocumentKind::studyState, studyIdentity("1.2.3"), "last"}));
    ASSERT_TRUE(session);
    EXPECT_EQ(session->json, R"({"preset": "bone"})");
    EXPECT_EQ(valueOf(store.getDocument({DocumentKind::calibration, "", "gpu"}))->version, 2);
    const auto trail = valueOf(store.listAudit(10));
    ASSERT_EQ(trail.entries.size(), 3u);
    EXPECT_EQ(trail.entries[2].amount, 3);
    Progress progress;
    EXPECT_TRUE(valueOf(store.verify(progress)).isSound());
}

std::string sqlOf(const fs::path& database) {
    SQLite::Database sqlite(database.string());
    std::string tables;
    std::string rows;
    std::string others;
    SQLite::Statement schema(
        sqlite, "SELECT type, name, sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY rowid");
    while (schema.executeStep()) {
        const std::string name = schema.getColumn(1).getString();
        const bool isTable = schema.getColumn(0).getString() == "table";
        if (isTable) rows += rowsOf(sqlite, name);
        if (name == "sqlite_sequence") continue;  // SQLite makes it
        (isTable ? tables : others) += schema.getColumn(2).getString() + ";\n";
    }
    const auto pragma = [&](const std::string& name) {
        return "PRAGMA " + name + " = " + sqlite.execAndGet("PRAGMA " + name).getString() + ";\n";
    };
    // Rows of sqlite_sequence are there by then; they are set, not added.
    return pragma("application_id") + pragma("user_version") + tables + "DELETE FROM sqlite_sequence;\n" +
           rows + others;
}

void makeDatabase(const std::string& sql, const fs::path& database) {
    SQLite::Database sqlite(database.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    sqlite.exec("PRAGMA synchronous = OFF; BEGIN");
    sqlite.exec(sql);
    sqlite.exec("COMMIT");
}

fs::path fixtureFile(int version) {
    return macula::test::projectFolder() / "tests" / "session" / "fixtures" /
           ("version_" + std::to_string(version) + ".sql");
}

void makeFixture(int version, const fs::path& folder) {
    fs::create_directories(folder / "models");
    makeDatabase(textOf(fixtureFile(version)), folder / "sessions.db");
    for (const std::uint32_t number : {1u, 2u}) {
        const auto blob = blobOf(number, 1000 * number);
        const std::string bytes(reinterpret_cast<const char*>(blob.data()), blob.size());
        putText(folder / "models" / (digestOf(bytes) + ".model"), bytes);
    }
}

}  // namespace macula::session::test
