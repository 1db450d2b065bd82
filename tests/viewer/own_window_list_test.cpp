// Windows of one's own between two runs, and where they cannot be kept.
#include "viewer/slices/slice_windowing.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "live/store/machine_documents.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class OwnWindowListTest : public test::OffscreenTest {
  protected:
    static scene::OwnWindow window(const std::string& name) {
        return {.name = name,
                .window = {.center = 60.0, .width = 300.0, .explanation = {}, .function = {}},
                .unit = "HU"};
    }
    std::string stored() const {
        const auto json = live::machineDocument(
            folder(), {.kind = session::DocumentKind::preset, .study = {}, .name = "windows of slices"});
        return json ? json->value_or(std::string()) : std::string();
    }
    bool isStored(const char* name) const { return stored().find(name) != std::string::npos; }
    std::filesystem::path folder() const {
        return std::filesystem::path(folder_.path().toStdString()) / "sessions";
    }

    QTemporaryDir folder_;
};

TEST_F(OwnWindowListTest, WithoutAStoreTheyLastForTheRun) {
    OwnWindowList list(std::nullopt);
    ASSERT_TRUE(list.add(window("Kidney")).ok());
    EXPECT_FALSE(list.add(window(" ")).ok());
    EXPECT_EQ(list.all().size(), 1u);
    list.remove(window("Kidney"));
    list.remove(window("Kidney"));
    EXPECT_TRUE(list.all().empty());
}

TEST_F(OwnWindowListTest, TheyComeBack) {
    {
        OwnWindowList list(folder());
        // Before what was kept is read.
        ASSERT_TRUE(list.add(window("Kidney")).ok());
        ASSERT_TRUE(list.add(window("Liver")).ok());
        const auto isKept = [this] {
            const auto json = live::machineDocument(
                folder(), {.kind = session::DocumentKind::preset, .study = {}, .name = "windows of slices"});
            return json && *json && (*json)->find("Liver") != std::string::npos;
        };
        EXPECT_TRUE(waitUntil(isKept));
    }
    OwnWindowList again(folder());
    EXPECT_TRUE(waitUntil([&] { return again.all().size() == 2; }));
    EXPECT_EQ(again.all().front(), window("Kidney"));
}

TEST_F(OwnWindowListTest, WhatCannotBeKeptIsToldAndStaysForTheRun) {
    std::ofstream(folder()) << "no folder";
    OwnWindowList list(folder());
    int told = 0;
    QObject::connect(&list, &OwnWindowList::failed, &list, [&](const Error&) { ++told; });
    ASSERT_TRUE(list.add(window("Kidney")).ok());
    EXPECT_TRUE(waitUntil([&] { return told >= 2; })) << "reading and writing";
    EXPECT_EQ(list.all().size(), 1u);
}

TEST_F(OwnWindowListTest, WhatIsAddedLastIsKeptWhenTheWindowCloses) {
    {
        OwnWindowList list(folder());
        ASSERT_TRUE(list.add(window("Kidney")).ok());
    }
    EXPECT_TRUE(isStored("Kidney"));
    {
        OwnWindowList list(folder());
        ASSERT_TRUE(waitUntil([&] { return list.all().size() == 1; }));
        list.remove(window("Kidney"));
        ASSERT_TRUE(list.add(window("Liver")).ok());
    }
    EXPECT_FALSE(isStored("Kidney"));
    EXPECT_TRUE(isStored("Liver"));
}

TEST_F(OwnWindowListTest, TwoWindowsKeepTheOnesOfEachOther) {
    OwnWindowList first(folder());
    OwnWindowList second(folder());
    int read = 0;
    QObject::connect(&first, &OwnWindowList::changed, &first, [&] { ++read; });
    QObject::connect(&second, &OwnWindowList::changed, &first, [&] { ++read; });
    ASSERT_TRUE(waitUntil([&] { return read == 2; }));
    ASSERT_TRUE(first.add(window("Kidney")).ok());
    ASSERT_TRUE(waitUntil([&] { return isStored("Kidney"); }));
    ASSERT_TRUE(second.add(window("Liver")).ok());
    ASSERT_TRUE(waitUntil([&] { return isStored("Liver"); }));
    EXPECT_TRUE(isStored("Kidney"));
    EXPECT_TRUE(waitUntil([&] { return second.all().size() == 2; }));
}

TEST_F(OwnWindowListTest, WhatCouldNotBeReadIsNotOverwritten) {
    {
        OwnWindowList list(folder());
        ASSERT_TRUE(list.add(window("Kidney")).ok());
    }
    const std::filesystem::path away = folder().string() + ".away";
    std::filesystem::rename(folder(), away);
    std::ofstream(folder()) << "no folder";
    OwnWindowList list(folder());
    int told = 0;
    QObject::connect(&list, &OwnWindowList::failed, &list, [&](const Error&) { ++told; });
    ASSERT_TRUE(waitUntil([&] { return told == 1; }));
    std::filesystem::remove(folder());
    std::filesystem::rename(away, folder());
    ASSERT_TRUE(list.add(window("Liver")).ok());
    ASSERT_TRUE(waitUntil([&] { return isStored("Liver"); }));
    EXPECT_TRUE(isStored("Kidney"));
}

}  // namespace
}  // namespace macula::viewer
