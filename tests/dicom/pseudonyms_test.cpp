// Deidentified objects: whose they are, and whether a face may be seen.
#include "dicom/write/object_owner.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "dicom/read/placeholder.h"

namespace macula::dicom::test {
namespace {

const PatientIdentity kJane{.id = "0042", .name = "doe^jane", .birthDate = "19700102", .sex = "F"};

TEST(Pseudonyms, AreOnePatientsAndOneStudys) {
    const Pseudonym first = pseudonymOf(kJane, "1.2.3");
    EXPECT_EQ(first.patientId, pseudonymOf(kJane, "1.2.3").patientId);
    EXPECT_EQ(first.studyInstanceUid, pseudonymOf(kJane, "1.2.3").studyInstanceUid);
    const Pseudonym later = pseudonymOf(kJane, "1.2.4");
    EXPECT_EQ(first.patientId, later.patientId) << "a prior stays one";
    EXPECT_NE(first.studyInstanceUid, later.studyInstanceUid);
    PatientIdentity other = kJane;
    other.id = "0043";
    EXPECT_NE(first.patientId, pseudonymOf(other, "1.2.3").patientId);
    EXPECT_NE(first.studyInstanceUid, pseudonymOf(other, "1.2.3").studyInstanceUid);
}

TEST(Pseudonyms, OfNobodyEachStudyIsAPatient) {
    const PatientIdentity nobody{.id = "0000", .name = "anonymous", .birthDate = {}, .sex = {}};
    EXPECT_EQ(pseudonymOf(nobody, "1.2.3").patientId, pseudonymOf(nobody, "1.2.3").patientId);
    EXPECT_NE(pseudonymOf(nobody, "1.2.3").patientId, pseudonymOf(nobody, "1.2.4").patientId);
}

TEST(Pseudonyms, AreByChanceAndNoPlaceholders) {
    std::set<std::string> ids;
    for (int n = 0; n < 100; ++n) {
        const Pseudonym made = newPseudonym();
        EXPECT_LE(made.patientId.size(), 64u);
        EXPECT_FALSE(isPlaceholder(made.patientId)) << made.patientId;
        ids.insert({made.patientId, made.studyInstanceUid});
    }
    EXPECT_EQ(ids.size(), 200u);
}

TEST(VisibleFace, IsOnlyRuledOutBelowTheChest) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const char* part : {"ABDOMEN", "Abdomen", "KNEE", "PELVIS", "FOOT", "ABDOMEN PELVIS", "LSPINE"}) {
        EXPECT_FALSE(mayShowFace(part, 400.0)) << part;
        EXPECT_TRUE(mayShowFace(part, 900.0)) << part << ": the whole body";
        EXPECT_TRUE(mayShowFace(part, kNaN)) << part;
        EXPECT_TRUE(mayShowFace(part, std::nullopt)) << part;
    }
    for (const char* part :
         {"", "HEAD", "BRAIN", "NECK", "CHEST", "CSPINE", "WHOLEBODY", "HAND", "WRIST", "EXTREMITY", "?"})
        EXPECT_TRUE(mayShowFace(part, 100.0)) << part;
}

}  // namespace
}  // namespace macula::dicom::test
