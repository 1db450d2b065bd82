// Documents, and what the database itself refuses.
#include <SQLiteCpp/SQLiteCpp.h>

#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

using test::isOk;
using test::troubleIn;
using test::valueOf;

class Documents : public test::StoreTest {
  protected:
    std::string database() const { return (folder_ / "sessions.db").string(); }
};

TEST_F(Documents, ComeBackWordForWord) {
    const DocumentId id{DocumentKind::preset, "", "Knochen, warm — мягкий"};
    const std::string json = "{ \"version\": 3,\n  \"points\": [1, 2.50] }";
    ASSERT_TRUE(isOk(open().putDocument(id, 3, json, {})));
    Store store = open();
    const auto document = valueOf(store.getDocument(id));
    ASSERT_TRUE(document);
    EXPECT_EQ(document->json, json);
    EXPECT_EQ(document->version, 3);
    EXPECT_EQ(document->createdMs, nowMs_);
    EXPECT_EQ(valueOf(store.getDocument({DocumentKind::clip, "", id.name})), std::nullopt);
}

TEST_F(Documents, KeepWhatAnOlderProgramDoesNotKnow) {
    Store store = open();
    const DocumentId id{DocumentKind::studyState, studyIdentity("1"), "last"};
    ASSERT_TRUE(isOk(store.putDocument(id, 2, R"({"preset": "a", "fog": {"density": 0.5}})", {})));
    nowMs_ += 100;
    const std::string_view known[]{"preset"};
    ASSERT_TRUE(isOk(store.putDocument(id, 1, R"({"preset": "b"})", known)));
    const auto document = valueOf(store.getDocument(id));
    EXPECT_EQ(document->json, R"({"fog":{"density":0.5},"preset":"b"})");
    EXPECT_EQ(document->version, 1);
    EXPECT_EQ(document->createdMs + 100, document->changedMs);
}

// A second program that writes meanwhile waits: what was read is what is replaced.
TEST_F(Documents, AreChangedByWhatIsStored) {
    Store store = open();
    const DocumentId id{DocumentKind::studyState, studyIdentity("1"), "last"};
    std::vector<std::optional<std::string>> seen;
    const auto change = [&](const std::string& json) {
        const std::string_view known[]{"a", "b"};
        return store.changeDocument(
            id, 1,
            [&](const std::optional<std::string>& stored) {
                seen.push_back(stored);
                return json;
            },
            known);
    };
    ASSERT_TRUE(isOk(change(R"({"a":1})")));
    ASSERT_TRUE(isOk(change(R"({"b":2,"c":3})")));
    ASSERT_TRUE(isOk(change(R"({"a":4})")));
    EXPECT_EQ(seen,
              (std::vector<std::optional<std::string>>{std::nullopt, R"({"a":1})", R"({"b":2,"c":3})"}));
    EXPECT_EQ(valueOf(store.getDocument(id))->json, R"({"a":4,"c":3})");
    EXPECT_EQ(troubleIn(change("[]")), Trouble::documentInvalid);
    EXPECT_EQ(valueOf(store.getDocument(id))->json, R"({"a":4,"c":3})");
}

TEST_F(Documents, AreListedByNameAndRemoved) {
    Store store = open();
    for (const char* name : {"b", "a"})
        ASSERT_TRUE(isOk(store.putDocument({DocumentKind::favourite, "", name}, 1, "{}", {})));
    const auto list = valueOf(store.listDocuments(DocumentKind::favourite, ""));
    ASSERT_EQ(list.entries.size(), 2u);
    EXPECT_EQ(list.entries[0].id.name, "a");
    EXPECT_TRUE(valueOf(store.removeDocument({DocumentKind::favourite, "", "a"})));
    EXPECT_FALSE(valueOf(store.removeDocument({DocumentKind::favourite, "", "a"})));
    EXPECT_EQ(valueOf(store.listDocuments(DocumentKind::favourite, "")).entries.size(), 1u);
    EXPECT_EQ(valueOf(store.listAudit(10)).entries.at(0).action, "deleted");
}

// Of another page, too: a long text overflows.
TEST_F(Documents, LeaveNoByteWhenTheyAreRemovedOrReplaced) {
    Store store = open();
    const std::string json = "{\"note\": \"" + std::string(10'000, '.') + "MARKER\"}";
    for (const char* name : {"removed", "replaced", "short"}) {
        const std::string text = name == std::string("short") ? R"({"note": "MARKER"})" : json;
        ASSERT_TRUE(isOk(store.putDocument({DocumentKind::view, "", name}, 1, text, {})));
    }
    EXPECT_NE(test::textOf(database()).find("MARKER"), std::string::npos);
    ASSERT_TRUE(isOk(store.removeDocument({DocumentKind::view, "", "removed"})));
    const std::string_view known[]{"note"};
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::view, "", "replaced"}, 1, "{}", known)));
    ASSERT_TRUE(isOk(store.removeDocument({DocumentKind::view, "", "short"})));
    for (const auto& file : test::filesBelow(folder_))
        EXPECT_EQ(test::textOf(folder_ / file).find("MARKER"), std::string::npos) << file;
}

TEST_F(Documents, ThatAreNoObjectsAreRefused) {
    Store store = open();
    const DocumentId id{DocumentKind::view, "", "a"};
    EXPECT_EQ(troubleIn(store.putDocument(id, 1, "[]", {})), Trouble::documentInvalid);
    EXPECT_EQ(valueOf(store.getDocument(id)), std::nullopt);
}

// A person types them: no error of the program.
TEST_F(Documents, WithoutAUsableNameAreRefused) {
    Store store = open();
    for (const std::string& name : {std::string(), std::string(201, 'a')}) {
        const DocumentId id{DocumentKind::preset, "", name};
        EXPECT_EQ(troubleIn(store.putDocument(id, 1, "{}", {})), Trouble::documentInvalid);
        EXPECT_EQ(valueOf(store.getDocument(id)), std::nullopt);
        EXPECT_FALSE(valueOf(store.removeDocument(id)));
    }
    EXPECT_TRUE(isOk(store.putDocument({DocumentKind::preset, "", std::string(200, 'a')}, 1, "{}", {})));
}

TEST_F(Documents, WithAChangedBitAreSetAside) {
    const DocumentId id{DocumentKind::view, "", "apex"};
    ASSERT_TRUE(isOk(open().putDocument(id, 1, R"({"fov": 30})", {})));
    {
        SQLite::Database sqlite(database(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(sqlite.exec("UPDATE documents SET json = '{\"fov\": 31}'"), 1);
    }
    Store store = open();
    EXPECT_EQ(valueOf(store.listDocuments(DocumentKind::view, "")).damaged, 1u);
    EXPECT_EQ(troubleIn(store.getDocument(id)), Trouble::documentDamaged);
    EXPECT_EQ(valueOf(store.getDocument(id)), std::nullopt);
    ASSERT_TRUE(isOk(store.putDocument(id, 1, R"({"fov": 32})", {})));
    EXPECT_EQ(valueOf(store.getDocument(id))->json, R"({"fov": 32})");
    EXPECT_EQ(SQLite::Database(database()).execAndGet("SELECT count(*) FROM documents").getInt(), 2);
}

TEST_F(Documents, OfTheAuditTrailCannotBeChanged) {
    ASSERT_TRUE(isOk(open().recordOpened(opened("1", "1", "chest"))));
    SQLite::Database sqlite(database(), SQLite::OPEN_READWRITE);
    for (const char* sql :
         {"UPDATE audit SET at = 1", "DELETE FROM audit",
          "INSERT OR REPLACE INTO audit SELECT id, 1, action, kind, subject, amount, row_check FROM audit"})
        EXPECT_THROW(sqlite.exec(sql), SQLite::Exception) << sql;
    EXPECT_EQ(valueOf(open().listAudit(10)).entries.size(), 1u);
}

}  // namespace
}  // namespace macula::session
