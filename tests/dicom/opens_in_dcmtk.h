// Whether DCMTK opens a file: its library always, and dcmdump where that is installed.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace macula::dicom::test {

// What dcmdump does: it reads all of the file, strictly as it stands, and prints each element.
inline void expectOpensInDcmtk(const std::filesystem::path& file) {
    DcmFileFormat format;
    const OFCondition loaded = format.loadFile(file.c_str());
    ASSERT_TRUE(loaded.good()) << loaded.text();
    ASSERT_TRUE(format.loadAllDataIntoMemory().good());
    std::ostringstream printed;
    format.print(printed, DCMTypes::PF_shortenLongTagValues);
    EXPECT_NE(printed.str().find("SOPInstanceUID"), std::string::npos);
    if (std::system("command -v dcmdump >/dev/null 2>&1") != 0) return;
    const std::string command = "dcmdump '" + file.string() + "' >/dev/null 2>&1";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace macula::dicom::test
