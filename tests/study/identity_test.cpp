#include "study/open/identity.h"

#include <gtest/gtest.h>

namespace macula::study {
namespace {

using Lines = std::vector<std::string>;

Lines englishLines(const Identity& identity) {
    Lines lines;
    for (const Text& line : linesOf(identity)) lines.push_back(line.english());
    return lines;
}

TEST(Identity, NamesPatientStudyAndSeries) {
    const Identity identity{.patientName = "DOE^JOHN^Q^DR^MD",
                            .patientId = "4711 ",
                            .birthDate = "19500102",
                            .sex = "M",
                            .studyDate = "20200304",
                            .studyDescription = "Chest",
                            .series = Text("CT, series 3: Lung")};
    EXPECT_EQ(englishLines(identity), (Lines{"DOE, JOHN Q, DR, MD", "ID 4711, born 1950-01-02, M",
                                             "2020-03-04, Chest", "CT, series 3: Lung"}));
    EXPECT_EQ(titleOf(identity),
              "DOE, JOHN Q, DR, MD \u00b7 4711 \u00b7 2020-03-04, Chest \u00b7 "
              "CT, series 3: Lung");
}

TEST(Identity, SaysWhatIsMissing) {
    EXPECT_EQ(englishLines({.patientName = " ^ ", .series = Text("MR, series 1")}),
              (Lines{"No patient name", "No patient ID", "no study date", "MR, series 1"}));
    EXPECT_EQ(titleOf({.series = Text("MR, series 1")}),
              "No patient name \u00b7 no patient ID \u00b7 no study date \u00b7 MR, series 1");
    EXPECT_EQ(englishLines({.series = Text("Built-in phantom"), .isOfNobody = true}),
              Lines{"Built-in phantom"});
}

TEST(Identity, NamesAndDatesAreForPeople) {
    EXPECT_EQ(nameForPeople("Doe^Jane"), "Doe, Jane");
    EXPECT_EQ(nameForPeople("Doe"), "Doe");
    EXPECT_EQ(nameForPeople("Yamada^Tarou=\u5c71\u7530^\u592a\u90ce="),
              "Yamada, Tarou = \u5c71\u7530, \u592a\u90ce");
    EXPECT_EQ(nameForPeople("^^^^"), "");
    EXPECT_EQ(dateForPeople("20200304"), "2020-03-04");
    EXPECT_EQ(dateForPeople("2020.03.04"), "2020.03.04");  // as in the file
}

}  // namespace
}  // namespace macula::study
