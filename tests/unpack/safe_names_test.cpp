// Names of archives become names inside of the folder, and of nobody.
#include "unpack/safe_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace macula::unpack {
namespace {

bool isInside(const std::filesystem::path& path) {
    return !path.empty() && path.is_relative() &&
           std::none_of(path.begin(), path.end(),
                        [](const auto& part) { return part == ".." || part == "."; });
}

TEST(SafeNames, KeepNamesThatADirectoryOfAMediumRefersTo) {
    SafeNames names;
    for (const char* name : {"DICOMDIR", "DICOM/PAT1/CT/IM0001", "a/b-1_2.dcm", "1.2.840.1.dcm"}) {
        const SafeNames::Place place = names.placeOf(name);
        EXPECT_EQ(place.path, name);
        EXPECT_FALSE(place.wasOutside);
    }
    EXPECT_EQ(names.placeOf("./a//b/./c").path, "a/b/c");
    EXPECT_EQ(names.placeOf("DICOM\\PAT1\\IM1").path, "DICOM/PAT1/IM1");
}

TEST(SafeNames, StayInTheFolder) {
    SafeNames names;
    for (const char* name : {"../../etc/x", "/etc/x", "a/../../x", "..", "a/..", "\\\\server\\x", "..\\x"}) {
        const SafeNames::Place place = names.placeOf(name);
        EXPECT_TRUE(isInside(place.path)) << name << ": " << place.path;
        EXPECT_TRUE(place.wasOutside) << name;
    }
    for (const std::string& name : {std::string(), std::string("/"), std::string("."), std::string("C:\\x"),
                                    std::string(100'000, 'a'), std::string(100'000, '/') + "x"})
        EXPECT_TRUE(isInside(names.placeOf(name).path));
    std::string deep;
    for (int i = 0; i < 1000; ++i) deep += "a/";
    EXPECT_EQ(names.placeOf(deep + "x").path.parent_path(), "");
}

TEST(SafeNames, NameNobodyAndHoldNoControlCharacters) {
    SafeNames names;
    for (const char* name : {"DOE^JANE/IM 1.dcm", "M\xc3\xbcller, Hans/x\n1", "a\x1b[31m/b", "\xff\xfe/x",
                             ".hidden/x", "a\xe2\x80\xaetxt/x"}) {
        const std::string place = names.placeOf(name).path.string();
        EXPECT_EQ(place.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789./"), std::string::npos)
            << place;
        EXPECT_EQ(place.find("DOE"), std::string::npos);
    }
}

TEST(SafeNames, KeepTheFilesOfAFolderTogetherAndApartFromOthers) {
    SafeNames names;
    const auto one = names.placeOf("DOE^JANE/1");
    const auto two = names.placeOf("DOE^JANE/2");
    const auto other = names.placeOf("DOE^JIM/1");
    EXPECT_EQ(one.path.parent_path(), two.path.parent_path());
    EXPECT_NE(one.path.parent_path(), other.path.parent_path());
    EXPECT_EQ(names.placeOf("my scan.zip").path.extension(), ".zip");
}

TEST(SafeNames, LeaveOutWhatMacOsAdds) {
    EXPECT_TRUE(SafeNames::isLeftByMacOs("__MACOSX/a/._IM1"));
    EXPECT_TRUE(SafeNames::isLeftByMacOs("a/.DS_Store"));
    EXPECT_FALSE(SafeNames::isLeftByMacOs("a/_IM1"));
}

}  // namespace
}  // namespace macula::unpack
