// Which files of a folder are looked at: all that lie in it, each once, and none that do not.
#include "dicom/read/folder.h"

#include <algorithm>
#include <fstream>

#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

void touch(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << 'x';
}

FolderListing list(const fs::path& path) {
    Progress progress;
    auto listing = listFiles(path, progress);
    EXPECT_TRUE(listing);
    return listing ? *listing : FolderListing{};
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::path& file : list(folder).files) names.push_back(file.lexically_relative(folder).native());
    return names;
}

using Names = std::vector<std::string>;

TEST(Folder, LinksInsideAddNothing) {
    const TemporaryFolder folder;
    touch(folder / "a/one");
    touch(folder / "b/two");
    fs::create_symlink("../a", folder / "b/toA");
    fs::create_symlink("a/one", folder / "toOne");
    fs::create_directory_symlink(folder.path(), folder / "a/toTop");
    fs::create_symlink(folder / "toOne", folder / "toTheLink");
    fs::create_symlink("loop", folder / "loop");
    fs::create_symlink("nowhere", folder / "broken");
    EXPECT_EQ(namesIn(folder.path()), (Names{"a/one", "b/two"}));
    EXPECT_EQ(list(folder.path()).linksOutside, 0u);
}

TEST(Folder, LinksOutsideAreRefusedAndCounted) {
    const TemporaryFolder folder, elsewhere;
    touch(elsewhere / "secret");
    touch(elsewhere / "more/secret");
    touch(folder / "one");
    fs::create_symlink(elsewhere / "secret", folder / "file");
    fs::create_directory_symlink(elsewhere.path(), folder / "folder");
    fs::create_directory_symlink("..", folder / "up");
    // A name that only begins like the folder's.
    const fs::path sibling = folder.path().native() + "-sibling";
    touch(sibling / "secret");
    fs::create_directory_symlink(sibling, folder / "sibling");
    // A link inside to a link that leads outside.
    fs::create_symlink("file", folder / "twice");
    const FolderListing listing = list(folder.path());
    EXPECT_EQ(namesIn(folder.path()), Names{"one"});
    EXPECT_EQ(listing.linksOutside, 5u);
    fs::remove_all(sibling);
}

TEST(Folder, MayItselfBeALink) {
    const TemporaryFolder folder, elsewhere;
    touch(elsewhere / "a/one");
    fs::create_symlink("a/one", elsewhere / "toOne");
    fs::create_directory_symlink(elsewhere.path(), folder / "link");
    fs::create_symlink(elsewhere / "a/one", folder / "fileLink");
    const FolderListing listing = list(folder / "link");
    ASSERT_EQ(listing.files.size(), 1u);
    EXPECT_EQ(listing.files[0], folder / "link/a/one") << "named as it was chosen";
    EXPECT_EQ(listing.linksOutside, 0u);
    EXPECT_EQ(list(folder / "fileLink").files.size(), 1u);
    EXPECT_EQ(list(folder.path()).linksOutside, 2u);
}

TEST(Folder, WhatMacOsLeaves) {
    const TemporaryFolder folder;
    touch(folder / "one");
    touch(folder / "._one");
    touch(folder / ".DS_Store");
    touch(folder / "__MACOSX/sub/two");
    touch(folder / "sub/._three");
    touch(folder / "sub/.hidden");
    touch(folder / "sub/__MACOSX.dcm");
    fs::create_symlink("__MACOSX/sub", folder / "link");
    const FolderListing listing = list(folder.path());
    EXPECT_EQ(namesIn(folder.path()), (Names{"one", "sub/.hidden", "sub/__MACOSX.dcm"}));
    EXPECT_EQ(listing.linksOutside, 0u);
}

TEST(Folder, NamesInAnyEncoding) {
    const TemporaryFolder folder;
    const Names names{"\xE9t\xE9", "Größe/Дом", "山田", "line\nbreak", " "};
    for (const std::string& name : names) touch(folder.path() / name);
    Names expected = names;
    std::sort(expected.begin(), expected.end());
    Names found = namesIn(folder.path());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);

    // And they are read.
    const auto files = write(smallVolume(), folder / "in");
    fs::create_directories(folder.path() / "\xE9t\xE9 山田");
    for (std::size_t k = 0; k < files.size(); ++k)
        fs::rename(files[k], folder.path() / "\xE9t\xE9 山田" / ("\xFF" + std::to_string(k)));
    EXPECT_NE(loadFolder(folder.path()), nullptr);
}

TEST(Folder, WhatIsNoFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(std::system(("mkfifo '" + (folder / "pipe").string() + "'").c_str()), 0);
    touch(folder / "one");
    EXPECT_EQ(namesIn(folder.path()), Names{"one"});
    EXPECT_EQ(readHeader(folder / "pipe").state, FileState::unreadable) << "and nobody waits for it";
    Progress progress;
    EXPECT_FALSE(listFiles(folder / "pipe", progress));
    EXPECT_FALSE(listFiles(folder / "missing", progress));
}

TEST(Folder, ListingCanBeCancelled) {
    const TemporaryFolder folder;
    touch(folder / "one");
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto listing = listFiles(folder.path(), progress);
    ASSERT_FALSE(listing);
    EXPECT_EQ(listing.error().code, ErrorCode::cancelled);
}

TEST(Folder, Inside) {
    EXPECT_TRUE(liesInside("/a/b/c", "/a/b"));
    EXPECT_TRUE(liesInside("/a/b", "/a/b"));
    EXPECT_TRUE(liesInside("/a", "/"));
    EXPECT_FALSE(liesInside("/a/bc", "/a/b"));
    EXPECT_FALSE(liesInside("/a", "/a/b"));
}

}  // namespace
}  // namespace macula::dicom::test
