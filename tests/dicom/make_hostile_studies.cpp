// make_hostile_studies FOLDER: writes every hostile study into a folder of its own, to try them with the
// command, the window, and other programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hostile_studies.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "make_hostile_studies FOLDER\n");
        return 2;
    }
    for (const auto& study : macula::dicom::test::hostileStudies()) {
        study.write(std::filesystem::path(argv[1]) / study.name);
        fmt::print("{}\n", study.name);
    }
    return 0;
}
