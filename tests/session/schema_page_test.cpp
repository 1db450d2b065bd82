// docs/session-schema.md tells of the schema that there is.
#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <set>
#include <sstream>

#include "base/paths.h"
#include "session/migrations.h"
#include "session/rows.h"
#include "session/support.h"

namespace macula::session {
namespace {

using Lines = std::vector<std::string>;

// "name type null" of each column, by table; and names of all else under "".
using Schema = std::map<std::string, Lines>;

std::string betweenBackticks(const std::string& text) {
    const std::size_t first = text.find('`');
    return text.substr(first + 1, text.find('`', first + 1) - first - 1);
}

Schema schemaOfPage() {
    Schema schema;
    std::istringstream page(test::textOf(macula::test::projectFolder() / "docs" / "session-schema.md"));
    std::string table;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("### `")) table = betweenBackticks(line);
        if (line.starts_with("## ")) table.clear();
        if (!line.starts_with("| `")) continue;
        std::istringstream cells(line.substr(1));
        std::string name;
        std::string type;
        std::string null;
        std::getline(cells, name, '|');
        std::getline(cells, type, '|');
        std::getline(cells, null, '|');
        schema[table].push_back(table.empty() ? betweenBackticks(name)
                                              : betweenBackticks(name) + type + null);
    }
    return schema;
}

class SchemaPage : public test::StoreTest {
  protected:
    SchemaPage() : store_(open()), sqlite_((folder_ / "sessions.db").string()) {}
    Lines columnsOf(const std::string& table) {
        Lines columns;
        SQLite::Statement info(sqlite_, "SELECT name, type, \"notnull\" FROM pragma_table_info(?)");
        info.bind(1, table);
        while (info.executeStep())
            columns.push_back(info.getColumn(0).getString() + " " + info.getColumn(1).getString() +
                              (info.getColumn(2).getInt() != 0 ? "  no " : "  yes "));
        return columns;
    }
    Schema schemaOfDatabase() {
        Schema schema;
        SQLite::Statement rows(
            sqlite_, "SELECT type, name FROM sqlite_schema WHERE name NOT LIKE 'sqlite_%' ORDER BY rowid");
        while (rows.executeStep()) {
            const std::string name = rows.getColumn(1).getString();
            if (rows.getColumn(0).getString() == "table") {
                schema[name] = columnsOf(name);
            } else {
                schema[""].push_back(name);
            }
        }
        return schema;
    }

    Store store_;
    SQLite::Database sqlite_;
};

TEST_F(SchemaPage, NamesEveryTableColumnIndexAndTrigger) {
    const Schema page = schemaOfPage();
    const Schema real = schemaOfDatabase();
    ASSERT_EQ(real.size(), 8u) << "seven tables, and the rest";
    for (const auto& [table, columns] : real) {
        const auto told = page.find(table);
        ASSERT_NE(told, page.end()) << table;
        EXPECT_EQ(told->second, columns) << table;
    }
    EXPECT_EQ(page.size(), real.size());
}

TEST_F(SchemaPage, NamesVersionAndApplication) {
    const std::string page = test::textOf(macula::test::projectFolder() / "docs" / "session-schema.md");
    EXPECT_NE(page.find("the number of the last migration: " + std::to_string(newestVersion()) + "."),
              std::string::npos);
    EXPECT_NE(page.find("0x4d616375"), std::string::npos);
    EXPECT_EQ(sqlite_.execAndGet("PRAGMA application_id").getInt(), kApplicationId);
    EXPECT_EQ(sqlite_.execAndGet("PRAGMA user_version").getInt(), newestVersion());
}

TEST_F(SchemaPage, NamesEveryKind) {
    const std::string page = test::textOf(macula::test::projectFolder() / "docs" / "session-schema.md");
    const auto expectNamed = [&](std::string_view name) {
        EXPECT_NE(page.find("`" + std::string(name) + "`"), std::string::npos) << name;
    };
    for (int i = 0; i <= static_cast<int>(DocumentKind::calibration); ++i)
        expectNamed(nameOf(static_cast<DocumentKind>(i)));
    for (int i = 0; i <= static_cast<int>(AuditAction::expired); ++i)
        expectNamed(nameOf(static_cast<AuditAction>(i)));
    for (int i = 0; i <= static_cast<int>(AuditKind::store); ++i)
        expectNamed(nameOf(static_cast<AuditKind>(i)));
}

// The tables that the code knows are those of the schema, in the same order of columns.
TEST_F(SchemaPage, RowsHaveTheColumnsOfTheirTables) {
    for (const Table* table : allTables()) {
        Lines known;
        for (const Column& column : table->columns)
            known.push_back(std::string(column.name) + (column.isInteger ? " INTEGER" : " TEXT") +
                            (column.mayBeNull || column.name == "id" ? "  yes " : "  no "));
        known.push_back("row_check INTEGER  no ");
        EXPECT_EQ(columnsOf(std::string(table->name)), known) << table->name;
    }
}

}  // namespace
}  // namespace macula::session
