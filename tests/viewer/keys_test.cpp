// The table of keys: no key does two things, and docs/window.md says what it says.
#include "viewer/keys/keys.h"

#include <gtest/gtest.h>

#include <QKeyEvent>
#include <fstream>
#include <set>
#include <sstream>

#include "base/paths.h"

namespace macula::viewer {
namespace {

TEST(Keys, NoKeyDoesTwoThingsAndNoActionIsForgotten) {
    std::set<QString> keys;
    for (const trace::LookTraits& look : trace::kLooks) keys.insert(keyOf(look.look).toString());
    int action = 0;
    std::set<KeyAction> actions;
    for (const KeyRow& row : kKeys) {
        actions.insert(row.action);
        if (row.sequence[0] == '\0') continue;
        EXPECT_FALSE(keyOf(row.action).isEmpty()) << row.sequence;
        EXPECT_TRUE(keys.insert(keyOf(row.action).toString()).second) << row.sequence;
    }
    while (action <= int(KeyAction::help)) EXPECT_TRUE(actions.contains(KeyAction(action++)));
    EXPECT_EQ(actions.size(), kKeys.size());
}

TEST(Keys, ALetterIsFoundByItsEvent) {
    const auto pressed = [](Qt::Key key) {
        return actionOf(QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier));
    };
    EXPECT_EQ(pressed(Qt::Key_F), KeyAction::fit);
    EXPECT_EQ(pressed(Qt::Key_L), KeyAction::left);
    EXPECT_EQ(viewDirectionOf(KeyAction::left), ViewDirection::left);
    EXPECT_EQ(pressed(Qt::Key_X), KeyAction::scissors);
    EXPECT_EQ(pressed(Qt::Key_Y), std::nullopt);
    EXPECT_EQ(pressed(Qt::Key_T), std::nullopt) << "only with Ctrl";
}

TEST(Keys, ThePageHasTheSameTable) {
    std::ifstream file(macula::test::projectFolder() / "docs/window.md");
    std::stringstream page;
    page << file.rdbuf();
    std::string table = "| key or gesture | does |\n|---|---|\n";
    for (const KeyRow& row : kKeys) table += "| " + pressedFor(row).toStdString() + " | " + row.does + " |\n";
    EXPECT_NE(page.str().find(table), std::string::npos) << "docs/window.md should say:\n" << table;
}

}  // namespace
}  // namespace macula::viewer
