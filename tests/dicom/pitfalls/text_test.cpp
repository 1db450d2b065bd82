// D20 character sets, D21 times, D22 display windows, D26 identity.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D20CharacterSets = Pitfall;
using D21Times = Pitfall;
using D22Windows = Pitfall;
using D26Identity = Pitfall;

// The patient's name as it is shown, when the file has these bytes and declares this.
Opened named(const TemporaryFolder& folder, const char* declared, const std::string& bytes) {
    SyntheticSeries series;
    series.size = {2, 2, 3};
    series.patientName = bytes;
    series.edits.push_back([declared](DcmItem& item) {
        if (declared) put(item, DCM_SpecificCharacterSet, declared);
    });
    writeFiles(folder.path(), series);
    return Opened(folder.path());
}

// PS3.5 annexes H to K have these names, and PS3.3 C.12.1.1.2 the terms.
TEST_F(D20CharacterSets, ToUtf8) {
    struct Case {
        const char* declared;
        std::string bytes;
        const char* name;
    };
    const Case cases[] = {
        {nullptr, "Yamada^Tarou", "Yamada^Tarou"},
        {"ISO_IR 192", "Wang^XiaoDong=王^小東=", "Wang^XiaoDong=王^小東="},
        {"ISO_IR 100", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},
        {"ISO_IR 101", "W\xB3odarski", "Włodarski"},
        {"ISO_IR 144", "\xBB\xEE\xDA\x63\x65\xDC\xD1\x79\x70\xD3", "Люкceмбypг"},
        {"ISO_IR 126", "\xC4\xE9\xEF\xED\xF5\xF3\xE9\xEF\xF2", "Διονυσιος"},
        {"ISO_IR 127", "\xE2\xC8\xC7\xE6\xEA^\xE4\xE6\xD2\xC7\xD1", "قباني^لنزار"},
        {"ISO_IR 138", "\xF9\xF8\xE5\xEF^\xE3\xE1\xE5\xF8\xE4", "שרון^דבורה"},
        {"ISO_IR 13", "\xD4\xCF\xC0\xDE^\xC0\xDB\xB3=\x59\x61\x6D\x61\x64\x61", "ﾔﾏﾀﾞ^ﾀﾛｳ=Yamada"},
        {"GB18030", "Wang^XiaoDong=\xCD\xF5^\xD0\xA1\xB6\xAB=", "Wang^XiaoDong=王^小东="},
        {"GBK", "Wang^XiaoDong=\xCD\xF5^\xD0\xA1\xB6\xAB=", "Wang^XiaoDong=王^小东="},
        {"\\ISO 2022 IR 87",
         "Yamada^Tarou=\x1B\x24\x42\x3B\x33\x45\x44\x1B\x28\x42^\x1B\x24\x42\x42\x40\x4F\x3A\x1B\x28\x42=",
         "Yamada^Tarou=山田^太郎="},
        {"\\ISO 2022 IR 149",
         "Hong^Gildong=\x1B\x24\x29\x43\xFB\xF3^\x1B\x24\x29\x43\xD1\xCE\xD4\xD7=", "Hong^Gildong=洪^吉洞="},
        {"\\ISO 2022 IR 58", "Zhang^XiaoDong=\x1B\x24\x29\x41\xD5\xC5^\x1B\x24\x29\x41\xD0\xA1\xB6\xAB=",
         "Zhang^XiaoDong=张^小东="},
        // The terms as they are often misspelt.
        {"ISO-IR 100", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},
        {"ISO 2022 IR 100", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(fmt::format("{} {}", c.declared ? c.declared : "none", c.name));
        const TemporaryFolder own;
        const Opened opened = named(own, c.declared, c.bytes);
        ASSERT_EQ(opened.scan().studies.size(), 1u);
        EXPECT_EQ(opened.scan().studies[0].patientName, c.name);
        EXPECT_FALSE(opened.says(key::kCharsetFallback)) << opened.keys();
    }
}

bool isUtf8(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t more = c < 0x80 ? 0 : c >> 5 == 6 ? 1 : c >> 4 == 14 ? 2 : c >> 3 == 30 ? 3 : 9;
        if (i + more >= text.size()) return false;
        for (std::size_t n = 1; n <= more; ++n)
            if ((static_cast<unsigned char>(text[i + n]) & 0xC0) != 0x80) return false;
        i += more + 1;
    }
    return true;
}

// Undeclared, wrongly declared, unheard of: something readable comes out, it is UTF-8, and it is marked.
TEST_F(D20CharacterSets, WrongDeclarationsAreMarked) {
    struct Case {
        const char* declared;
        std::string bytes;
        const char* name;  // null: whatever, as long as it is UTF-8
    };
    const Case cases[] = {
        {nullptr, "Buc^J\xE9r\xF4me", "Buc^Jérôme"},  // Latin-1 without saying so
        {"ISO_IR 6", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},
        {"ISO_IR 192", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},  // says UTF-8 and is not
        {"NONSENSE", "Buc^J\xE9r\xF4me", "Buc^Jérôme"},
        {"\\ISO 2022 IR 87", "\x1B\x24\x42\x7F\x7F\x7F", nullptr},
        {"GB18030", "\x81\xFF\xFF", nullptr},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(fmt::format("{} {}", c.declared ? c.declared : "none", c.name ? c.name : ""));
        const TemporaryFolder own;
        const Opened opened = named(own, c.declared, c.bytes);
        ASSERT_EQ(opened.scan().studies.size(), 1u);
        const std::string& name = opened.scan().studies[0].patientName;
        EXPECT_TRUE(isUtf8(name));
        if (c.name) {
            EXPECT_EQ(name, c.name);
        }
        EXPECT_TRUE(opened.says(key::kCharsetFallback)) << opened.keys();
        EXPECT_EQ(opened.volumes().size(), 1u);
    }
}

// Undeclared UTF-8 is UTF-8: nothing else makes sense of these bytes.
TEST_F(D20CharacterSets, UndeclaredUtf8) {
    const TemporaryFolder own;
    const Opened opened = named(own, nullptr, "Müller^Jürgen");
    ASSERT_EQ(opened.scan().studies.size(), 1u);
    EXPECT_EQ(opened.scan().studies[0].patientName, "Müller^Jürgen");
    EXPECT_TRUE(opened.says(key::kCharsetFallback)) << opened.keys();
}

// Injected 10 minutes before midnight, scanned 50 minutes after it.
void petTimes(DcmItem& item) {
    put(item, DCM_Units, "BQML");
    put(item, DCM_CorrectedImage, "ATTN\\DECY");
    put(item, DCM_DecayCorrection, "START");
    put(item, DCM_PatientWeight, "70");
    put(item, DCM_SeriesDate, "20200103");
    put(item, DCM_SeriesTime, "0050");  // no seconds
    put(item, DCM_AcquisitionDate, "20200103");
    put(item, DCM_AcquisitionTime, "0050");
    DcmItem& drug = nested(item, DCM_RadiopharmaceuticalInformationSequence);
    put(drug, DCM_RadiopharmaceuticalStartTime, "235000.00");
    put(drug, DCM_RadionuclideTotalDose, "400000000");
    put(drug, DCM_RadionuclideHalfLife, "6000");
}

TEST_F(D21Times, DecayOverMidnight) {
    series.modality = "PT";
    series.edits.push_back(petTimes);
    writeFiles(folder.path(), series);
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 1u) << opened.keys();
    ASSERT_TRUE(opened.volumes()[0]->suvFactor) << opened.keys();
    // 3600 s of a half-life of 6000 s; 70 kg are 70 000 g.
    const double dose = 4e8 * std::exp2(-3600.0 / 6000.0);
    EXPECT_NEAR(*opened.volumes()[0]->suvFactor, 70000.0 / dose, 1e-9 * 70000.0 / dose);
}

TEST_F(D21Times, NoUptakeValuesWithoutAllOfTheTags) {
    const DcmTagKey needed[] = {DCM_Units, DCM_PatientWeight};
    const DcmTagKey neededOfDrug[] = {DCM_RadiopharmaceuticalStartTime, DCM_RadionuclideTotalDose,
                                      DCM_RadionuclideHalfLife};
    std::vector<Edit> removals;
    for (const DcmTagKey& tag : needed) removals.push_back([tag](DcmItem& item) { erase(item, tag); });
    for (const DcmTagKey& tag : neededOfDrug) {
        removals.push_back(
            [tag](DcmItem& item) { erase(nested(item, DCM_RadiopharmaceuticalInformationSequence), tag); });
    }
    removals.push_back([](DcmItem& item) { put(item, DCM_PatientWeight, "0"); });
    removals.push_back([](DcmItem& item) { put(item, DCM_Units, "CNTS"); });
    removals.push_back([](DcmItem& item) {
        put(nested(item, DCM_RadiopharmaceuticalInformationSequence), DCM_RadiopharmaceuticalStartTime,
            "later");
    });
    // Of kBq, MBq and GBq instead of Bq (PS3.3 C.8.9.2), and of grams (C.7.2.2).
    for (const char* dose : {"400000", "400", "0.4"}) {
        removals.push_back([dose](DcmItem& item) {
            put(nested(item, DCM_RadiopharmaceuticalInformationSequence), DCM_RadionuclideTotalDose, dose);
        });
    }
    removals.push_back([](DcmItem& item) { put(item, DCM_PatientWeight, "70000"); });
    for (std::size_t n = 0; n < removals.size(); ++n) {
        SCOPED_TRACE(n);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size.z = 3;
        s.modality = "PT";
        s.edits = {petTimes, removals[n]};
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        ASSERT_EQ(opened.volumes().size(), 1u) << opened.keys();
        EXPECT_FALSE(opened.volumes()[0]->suvFactor);
        EXPECT_TRUE(opened.says(key::kSuvUnavailable)) << opened.keys();
        expectOnlyVolume(opened, s);
    }
}

// A newborn and a mouse are given less, and more of it for each gram.
TEST_F(D21Times, UptakeValuesOfTheSmallest) {
    const std::pair<const char*, const char*> given[]{{"0.5", "150000"}, {"0.02", "10000000"}};
    for (const auto& [weight, dose] : given) {
        SCOPED_TRACE(weight);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size.z = 3;
        s.modality = "PT";
        s.edits = {petTimes, [&](DcmItem& item) {
                       put(item, DCM_PatientWeight, weight);
                       put(nested(item, DCM_RadiopharmaceuticalInformationSequence),
                           DCM_RadionuclideTotalDose, dose);
                   }};
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        ASSERT_EQ(opened.volumes().size(), 1u) << opened.keys();
        EXPECT_TRUE(opened.volumes()[0]->suvFactor) << opened.keys();
    }
}

TEST_F(D22Windows, AllOfThemWithTheirNames) {
    series.edits.push_back([](DcmItem& item) {
        put(item, DCM_WindowCenter, "40\\-600");
        put(item, DCM_WindowWidth, "400\\1500");
        put(item, DCM_WindowCenterWidthExplanation, "SOFT\\LUNG");
        put(item, DCM_VOILUTFunction, "LINEAR_EXACT");
    });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    ASSERT_EQ(volume->windows().size(), 2u);
    EXPECT_EQ(volume->windows()[0], (DisplayWindow{40, 400, "SOFT", "LINEAR_EXACT"}));
    EXPECT_EQ(volume->windows()[1], (DisplayWindow{-600, 1500, "LUNG", "LINEAR_EXACT"}));
}

// VR LO counts characters, of which UTF-8 has up to four bytes each.
TEST_F(D22Windows, ALongNameIsCutBetweenCharacters) {
    series.edits.push_back([](DcmItem& item) {
        std::string name = "a";
        for (int i = 0; i < 40; ++i) name += "ä";
        put(item, DCM_SpecificCharacterSet, "ISO_IR 192");
        put(item, DCM_WindowCenter, "40");
        put(item, DCM_WindowWidth, "400");
        put(item, DCM_WindowCenterWidthExplanation, name.c_str());
    });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    ASSERT_EQ(volume->windows().size(), 1u);
    const std::string& name = volume->windows()[0].explanation;
    EXPECT_EQ(name.size(), 63u);
    EXPECT_TRUE(name.ends_with("ä"));
}

TEST_F(D22Windows, BrokenOnesAreNoWindowAndStopNothing) {
    const Edit breaks[] = {
        [](DcmItem& item) {
            put(item, DCM_WindowCenter, "40");
            put(item, DCM_WindowWidth, "0");
        },
        [](DcmItem& item) {
            put(item, DCM_WindowCenter, "40\\50");
            put(item, DCM_WindowWidth, "NaN");
        },
        [](DcmItem& item) {
            DcmItem& lut = nested(item, DCM_VOILUTSequence);
            put(lut, DCM_LUTExplanation, "BROKEN");
            const std::vector<Uint16> descriptor{65535, 0, 77};
            item.putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), descriptor.data(), 3);
        },
    };
    for (const Edit& spoil : breaks) {
        const TemporaryFolder own;
        SyntheticSeries s;
        s.edits = {spoil};
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        expectOnlyVolume(opened, s);
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_TRUE(volume->windows().empty());
    }
}

// A VOI LUT (PS3.3 C.11.2.1.1) is left out, and that is told.
TEST_F(D22Windows, TablesAreToldOf) {
    series.edits.push_back([](DcmItem& item) {
        DcmItem& table = nested(item, DCM_VOILUTSequence);
        const std::vector<Uint16> descriptor{4, 1000, 16};
        const std::vector<Uint16> entries{0, 100, 400, 65535};
        item.putAndInsertString(DCM_WindowCenter, "");
        table.putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), descriptor.data(), 3);
        table.putAndInsertUint16Array(DcmTag(DCM_LUTData, EVR_US), entries.data(), 4);
        put(table, DCM_LUTExplanation, "BRAIN");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.says(key::kDisplayTable)) << opened.keys();
}

// The window of the middle slice is that of the volume.
TEST_F(D22Windows, OfTheMiddleSlice) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([n = slice.place](DcmItem& item) {
            put(item, DCM_WindowCenter, std::to_string(100 + n));
            put(item, DCM_WindowWidth, "50");
        });
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    ASSERT_EQ(volume->windows().size(), 1u);
    EXPECT_EQ(volume->windows()[0].center, 106.0);
}

// Two patients, anonymised with the same UIDs.
TEST_F(D26Identity, SameUidsOfTwoPatients) {
    SyntheticSeries other = series;
    other.patientId = "SYN2";
    other.patientName = "SYNTHETIC^TWO";
    other.ramp = series.rampOf(1);
    writeFiles(folder / "one", series);
    writeFiles(folder / "two", other);
    const Opened opened = open();
    ASSERT_EQ(opened.scan().studies.size(), 2u);
    EXPECT_EQ(opened.frames(), 24u);
    EXPECT_TRUE(opened.says(key::kSeveralPatients)) << opened.keys();
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
        const bool first = opened.scan().studies[n].patientId == "SYN1";
        expectVolumeOf(*opened.load(*volumes[n]), first ? series : other);
    }
}

// Missing PatientID is legal; two names are still two patients.
TEST_F(D26Identity, WithoutPatientId) {
    SyntheticSeries other = series;
    series.patientId = other.patientId = "";
    other.patientName = "SYNTHETIC^TWO";
    other.seriesUid = "2.25.1009";
    other.studyUid = "2.25.1008";
    writeFiles(folder / "one", series);
    writeFiles(folder / "two", other);
    const Opened opened = open();
    EXPECT_EQ(opened.scan().studies.size(), 2u);
    EXPECT_EQ(opened.scan().patients, 2);
    EXPECT_EQ(opened.volumes().size(), 2u);
}

TEST_F(D26Identity, NothingSaidNamesThePatient) {
    series.patientName = "XYZZY^PATIENT";
    series.patientId = "PLUGH77";
    series.phases = 2;
    auto slices = slicesOf(series);
    slices.resize(17);
    const auto files = writeFiles(folder / "XYZZY", series, slices);
    std::filesystem::resize_file(files[3], std::filesystem::file_size(files[3]) - 40);
    const Opened opened = open();
    std::string said;
    for (const Message* message : opened.messages())
        said += message->sentence.english() + message->action.english();
    EXPECT_FALSE(said.empty());
    EXPECT_EQ(said.find("XYZZY"), std::string::npos) << said;
    EXPECT_EQ(said.find("PLUGH77"), std::string::npos) << said;
}

// A name where only terms should stand: RescaleType, Units, DoseUnits, the code of a mapping.
TEST_F(D26Identity, NoTextThatShouldBeATermIsRepeated) {
    for (const char* modality : {"CT", "MR", "PT", "RTDOSE"}) {
        SCOPED_TRACE(modality);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.modality = modality;
        s.edits.push_back([](DcmItem& item) {
            put(item, DCM_RescaleType, "XYZZY^PATIENT");
            put(item, DCM_Units, "XYZZY");
            put(item, DCM_DoseUnits, "XYZZY");
            DcmItem& map = nested(item, DCM_RealWorldValueMappingSequence);
            putNumber(map, DCM_RealWorldValueSlope, 2.0);
            putNumber(map, DCM_RealWorldValueIntercept, 1.0);
            put(nested(map, DCM_MeasurementUnitsCodeSequence), DCM_CodeValue, "XYZZY");
        });
        auto slices = slicesOf(s);
        for (Slice& slice : slices) {
            if (slice.place < 5) slice.edits.push_back([](DcmItem& i) { put(i, DCM_RescaleType, "XYZZYX"); });
        }
        writeFiles(own.path(), s, slices);
        const Opened opened(own.path());
        std::string said;
        for (const Message* message : opened.messages())
            said += message->sentence.english() + message->action.english();
        for (const Stack* stack : opened.volumes()) {
            for (const StackLabel& label : stack->splitBy) said += label.value;
            const auto volume = opened.load(*stack);
            ASSERT_NE(volume, nullptr);
            said += volume->unitName();
            for (const Text& assumption : volume->provenance().assumptions) said += assumption.english();
        }
        EXPECT_EQ(said.find("XYZZY"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace macula::dicom::test
