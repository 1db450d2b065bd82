// What names nobody.
#include "dicom/read/placeholder.h"

#include <gtest/gtest.h>

#include <string>

namespace macula::dicom::test {
namespace {

TEST(Placeholder, NamesAndIdsThatAreOfNobody) {
    for (const char* text : {"",
                             " ",
                             "^^^^",
                             "ANONYMOUS",
                             "anonymous",
                             "Anonymous^",
                             "ANON",
                             "Anon^",
                             "Anonymized",
                             "anonymised",
                             "ANONYMIZED^PATIENT",
                             "Patient^Anonymous",
                             "ANONYMOUS PATIENT",
                             "DEIDENTIFIED",
                             "De-Identified",
                             "DE_IDENTIFIED",
                             "DEID",
                             "UNKNOWN",
                             "Unknown^Unknown",
                             "unknown patient",
                             "NONE",
                             "None^",
                             "0",
                             "0000",
                             "000-00-0000",
                             "00000000",
                             "NoName",
                             "No Name",
                             "NO^NAME",
                             "NONAME^",
                             "XXXX",
                             "xxx^xxx",
                             "X",
                             "X^X",
                             "N/A",
                             "n.a.",
                             "NULL",
                             "Removed",
                             "REDACTED",
                             "Patient^Unknown",
                             "No Patient Name",
                             "NOT AVAILABLE",
                             "?",
                             "---",
                             "****",
                             "Anonym",
                             "Anonyme",
                             "Unbekannt",
                             "ANONIMO",
                             "Patient ID unknown",
                             "Patient"})
        EXPECT_TRUE(isPlaceholder(text)) << '"' << text << '"';
}

// Somebody's, or a pseudonym that tells patients apart.
TEST(Placeholder, NamesAndIdsThatAreOfSomebody) {
    for (const char* text :
         {"DOE^JANE", "17", "0042", "LIDC-IDRI-0001", "ANON0017", "ANONYMOUS 3", "Anon-1", "Null^Jennifer",
          "Anon^Somchai", "Nobody^Henry", "Patient^17", "SUBJECT-4", "XXX1", "Xu^X", "100000",
          "\xE7\x8E\x8B^\xE5\xB0\x8F\xE6\x9D\xB1", "Nonemann", "MACULA-3f9a2c7d01e4b856"})
        EXPECT_FALSE(isPlaceholder(text)) << '"' << text << '"';
}

TEST(Placeholder, DatesOfBirth) {
    for (const char* text : {"", "19000101", "00010101", "1900.01.01", "00000000", "18000101", "18991230",
                             "99991231", "99999999", "1970", "unknown", "19701301", "19700100", "19700001"})
        EXPECT_TRUE(isPlaceholderDate(text)) << text;
    for (const char* text : {"19700102", "1970.01.02", "19000102", "19010101", "20240229", "18991101"})
        EXPECT_FALSE(isPlaceholderDate(text)) << text;
}

}  // namespace
}  // namespace macula::dicom::test
