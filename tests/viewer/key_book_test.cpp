// Keys that a person has chosen: what can be taken, what is told, and which actions have them.
#include "viewer/settings/key_book.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "viewer/keys/keys.h"
#include "viewer/offscreen.h"
#include "viewer/settings/keys_page.h"

namespace macula::viewer {
namespace {

QKeySequence key(const char* text) {
    return QKeySequence(QString::fromLatin1(text), QKeySequence::PortableText);
}

KeyEntry entry(const char* usual, const char* title, bool isOfPicture = false) {
    return {.id = QString::fromLatin1(usual),
            .title = QString::fromLatin1(title),
            .usual = key(usual),
            .isOfPicture = isOfPicture};
}

class KeyBookTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        window_.emplace();
        QMenu* file = window_->menuBar()->addMenu(QStringLiteral("&File"));
        open_ = file->addAction(QStringLiteral("&Open && Close…"));
        open_->setShortcut(key("Ctrl+O"));
        nameless_ = file->addAction(QStringLiteral("No name"));
        named_ = file->addMenu(QStringLiteral("More"))->addAction(QStringLiteral("Named"));
        named_->setObjectName(QStringLiteral("named"));
        look_ = file->addAction(QStringLiteral("Anterior"));
        KeyBook::showPictureKey(*look_, key("A"));
    }
    void TearDown() override {
        KeyBook::ofProgram().setOwn({});
        window_.reset();
        OffscreenTest::TearDown();
    }
    void choose(const QMap<QString, QString>& own) {
        KeyBook::ofProgram().setOwn(own);
        KeyBook::ofProgram().applyTo(*window_);
    }

    std::optional<QMainWindow> window_;
    QAction* open_ = nullptr;
    QAction* nameless_ = nullptr;
    QAction* named_ = nullptr;
    QAction* look_ = nullptr;
};

TEST_F(KeyBookTest, KnowsWhatStandsInMenus) {
    const QList<KeyEntry> entries = KeyBook::entriesOf(*window_);
    ASSERT_EQ(entries.size(), 3) << "what has neither key nor name cannot be found again";
    EXPECT_EQ(entries[0].id, QStringLiteral("Ctrl+O"));
    EXPECT_EQ(entries[0].title, QStringLiteral("File: Open & Close…"));
    EXPECT_EQ(entries[1].id, QStringLiteral("#named"));
    EXPECT_EQ(entries[1].title, QStringLiteral("File, More: Named"));
    EXPECT_TRUE(entries[2].isOfPicture);
}

TEST_F(KeyBookTest, ActionsGetWhatWasChosenAndTheUsualKeysAgain) {
    choose({{QStringLiteral("Ctrl+O"), QStringLiteral("Ctrl+Alt+O")},
            {QStringLiteral("#named"), QStringLiteral("F12")},
            {QStringLiteral("A"), QStringLiteral("Q")}});
    EXPECT_EQ(open_->shortcut(), key("Ctrl+Alt+O"));
    EXPECT_EQ(named_->shortcut(), key("F12"));
    EXPECT_TRUE(look_->shortcut().isEmpty()) << "the viewport has its key";
    EXPECT_EQ(look_->text(), QStringLiteral("Anterior\tQ"));
    EXPECT_EQ(KeyBook::entriesOf(*window_)[0].id, QStringLiteral("Ctrl+O")) << "whatever is chosen";
    choose({{QStringLiteral("Ctrl+O"), QString()}});
    EXPECT_TRUE(open_->shortcut().isEmpty());
    choose({});
    EXPECT_EQ(open_->shortcut(), key("Ctrl+O"));
    EXPECT_TRUE(named_->shortcut().isEmpty());
    EXPECT_EQ(look_->text(), QStringLiteral("Anterior\tA"));
}

TEST_F(KeyBookTest, WhatIsNoKeyIsLeftOut) {
    choose({{QStringLiteral("Ctrl+O"), QStringLiteral("Ctrl+K, Ctrl+O")}});
    EXPECT_EQ(open_->shortcut(), key("Ctrl+O"));
}

TEST_F(KeyBookTest, HelpShowsTheKeysThatAreChosen) {
    const auto help = [](KeyAction action) {
        return chosenFor(*std::ranges::find(kKeys, action, &KeyRow::action));
    };
    EXPECT_EQ(help(KeyAction::panes), QStringLiteral("F5 to F9"));
    EXPECT_EQ(help(KeyAction::openFolder), QStringLiteral("Drop a folder or a file, Ctrl+O"));
    choose({{QStringLiteral("F6"), QStringLiteral("F12")},
            {QStringLiteral("Ctrl+O"), QStringLiteral("Ctrl+L")}});
    EXPECT_EQ(help(KeyAction::panes), QStringLiteral("F5, F12, F7, F8, F9"));
    EXPECT_EQ(help(KeyAction::openFolder), QStringLiteral("Drop a folder or a file, Ctrl+L"));
    EXPECT_EQ(help(KeyAction::orbit), QStringLiteral("Left drag, arrows"));
}

TEST(KeyTrouble, IsToldInASentence) {
    const QList<KeyEntry> all{entry("Ctrl+O", "File: Open"), entry("F3", "View: Panel"),
                              entry("A", "View: Anterior", true)};
    const auto trouble = [&](const char* wanted, int of, const QMap<QString, QString>& own = {}) {
        return troubleWith(key(wanted), all[of], all, own);
    };
    EXPECT_EQ(trouble("", 0), std::nullopt) << "no key at all";
    EXPECT_EQ(trouble("Ctrl+O", 0), std::nullopt) << "its own";
    EXPECT_EQ(trouble("Ctrl+Alt+P", 0), std::nullopt);
    ASSERT_TRUE(trouble("F3", 0).has_value());
    EXPECT_TRUE(trouble("F3", 0)->contains(QStringLiteral("View: Panel")));
    EXPECT_EQ(trouble("F3", 0, {{QStringLiteral("F3"), QStringLiteral("F12")}}), std::nullopt)
        << "it is free now";
    EXPECT_TRUE(trouble("F12", 0, {{QStringLiteral("F3"), QStringLiteral("F12")}}).has_value());
    for (const char* taken : {"Left", "Space", "Tab", "5", "Esc", "+", "Shift+Up"})
        EXPECT_TRUE(trouble(taken, 0).has_value()) << taken;
    EXPECT_TRUE(trouble("Ctrl+K, Ctrl+O", 0).has_value());
    EXPECT_TRUE(trouble("Ctrl+B", 2).has_value()) << "a picture has one key alone";
    EXPECT_EQ(trouble("B", 2), std::nullopt);
}

TEST(KeyTrouble, AFileThatWasEditedByHandLosesOnlyWhatCannotBe) {
    const QList<KeyEntry> all{entry("F3", "One"), entry("F4", "Two"), entry("F5", "Three")};
    const QMap<QString, QString> swapped{{QStringLiteral("F3"), QStringLiteral("F4")},
                                         {QStringLiteral("F4"), QStringLiteral("F3")}};
    EXPECT_EQ(withoutTrouble(swapped, all), swapped);
    const QMap<QString, QString> wrong{{QStringLiteral("F3"), QStringLiteral("F5")},
                                       {QStringLiteral("F4"), QStringLiteral("F9")}};
    EXPECT_EQ(withoutTrouble(wrong, all),
              (QMap<QString, QString>{{QStringLiteral("F4"), QStringLiteral("F9")}}));
}

class KeysPageTest : public test::OffscreenTest {
  protected:
    static void take(KeysPage& page, const char* wanted) {
        auto* edit = page.findChild<QKeySequenceEdit*>(QStringLiteral("keys-key"));
        edit->setKeySequence(key(wanted));
        Q_EMIT edit->editingFinished();
    }
};

TEST_F(KeysPageTest, TakesAKeyTellsAConflictAndGoesBack) {
    KeysPage page({entry("F3", "One"), entry("F4", "Two")}, {});
    take(page, "F4");
    EXPECT_TRUE(page.own().isEmpty());
    EXPECT_TRUE(page.trouble().contains(QStringLiteral("Two")));
    take(page, "Ctrl+K");
    EXPECT_EQ(page.own(), (QMap<QString, QString>{{QStringLiteral("F3"), QStringLiteral("Ctrl+K")}}));
    EXPECT_TRUE(page.trouble().isEmpty());
    take(page, "F3");
    EXPECT_TRUE(page.own().isEmpty()) << "the usual one is nothing of one's own";
}

TEST_F(KeysPageTest, SearchFindsWordsAndKeys) {
    KeysPage page({entry("F3", "File: Open"), entry("F4", "View: Clip")}, {});
    auto* list = page.findChild<QTreeWidget*>(QStringLiteral("keys-list"));
    auto* search = page.findChild<QLineEdit*>(QStringLiteral("keys-search"));
    search->setText(QStringLiteral("clip view"));
    EXPECT_TRUE(list->topLevelItem(0)->isHidden());
    EXPECT_FALSE(list->topLevelItem(1)->isHidden());
    EXPECT_EQ(list->currentItem(), list->topLevelItem(1)) << "a key is taken for what is seen";
    search->setText(QStringLiteral("f3"));
    EXPECT_EQ(list->currentItem(), list->topLevelItem(0));
    search->setText(QStringLiteral("nothing has this"));
    EXPECT_EQ(list->currentItem(), nullptr);
    take(page, "Ctrl+K");
    EXPECT_TRUE(page.own().isEmpty());
    KeysPage empty({}, {});
    EXPECT_TRUE(empty.own().isEmpty());
}

}  // namespace
}  // namespace macula::viewer
