// Small documents of the machine, beside a store that is open.
#include "live/store/machine_documents.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>

#include "support.h"

namespace macula::live {
namespace {

const session::DocumentId kId{.kind = session::DocumentKind::preset, .study = {}, .name = "a name"};

TEST(MachineDocuments, AreKeptBesideAStoreThatIsOpen) {
    const dicom::test::TemporaryFolder folder;
    session::StoreOptions options;
    options.folder = folder.path() / "sessions";
    const auto open = session::Store::open(options);
    ASSERT_TRUE(open.ok());
    const auto none = machineDocument(options.folder, kId);
    ASSERT_TRUE(none.ok());
    EXPECT_FALSE(*none);
    ASSERT_TRUE(keepMachineDocument(options.folder, kId, 1, R"({"a": 1, "b": 2})").ok());
    ASSERT_TRUE(keepMachineDocument(options.folder, kId, 1, R"({"a": 3})").ok());
    const auto kept = machineDocument(options.folder, kId);
    ASSERT_TRUE(kept.ok() && *kept);
    EXPECT_NE((*kept)->find("3"), std::string::npos);
    EXPECT_FALSE(keepMachineDocument(options.folder, kId, 1, "no object").ok());
    EXPECT_EQ(*machineDocument(options.folder, kId), *kept) << "what is kept is as it was";
}

TEST(MachineDocuments, AFolderThatIsNoneIsAnError) {
    const dicom::test::TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "not a folder";
    EXPECT_FALSE(machineDocument(folder.path() / "file", kId).ok());
    EXPECT_FALSE(keepMachineDocument(folder.path() / "file", kId, 1, "{}").ok());
    std::ifstream file(folder.path() / "file");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "not a folder");
}

}  // namespace
}  // namespace macula::live
