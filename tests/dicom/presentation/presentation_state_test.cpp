// Presentation states: what is written is read to the last bit, has what PS3.3 asks for, and no file, however
// damaged, makes anything but a sentence.
#include "dicom/presentation/presentation_state.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "base/sha256.h"
#include "dicom/presentation/palette_tables.h"
#include "dicom/presentation/srgb_profile.h"
#include "dicom/scan.h"
#include "dicom/write/series_writer.h"
#include "dicom/write/uid.h"
#include "opens_in_dcmtk.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
    OFString all;
    item.findAndGetOFStringArray(tag, all);
    return all.c_str();
}

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class PresentationStateTest : public testing::Test {
  protected:
    void SetUp() override {
        source_ = write(smallVolume(), folder_ / "source").front();
        DcmFileFormat file;
        ASSERT_TRUE(file.loadFile(source_.c_str()).good());
        DcmDataset& dataset = *file.getDataset();
        dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
        dataset.putAndInsertString(DCM_PatientName, "M\xfcller^Anna");  // Latin 1
        dataset.putAndInsertString(DCM_PatientID, "0042");
        dataset.putAndInsertString(DCM_AccessionNumber, "A17");
        ASSERT_TRUE(file.saveFile(source_.c_str()).good());
        const std::string uid = textOf(dataset, DCM_SOPInstanceUID);
        owner_.image = SecondaryCapture::Source{source_, uid};
        owner_.softwareVersion = "1.0";
        said_.label = "MACULA 3D";
        said_.description = "Seen from the left";
        said_.creationDate = "20240229";
        said_.creationTime = "235959";
        said_.series = {.seriesInstanceUid = textOf(dataset, DCM_SeriesInstanceUID),
                        .frameOfReferenceUid = textOf(dataset, DCM_FrameOfReferenceUID),
                        .images = {{textOf(dataset, DCM_SOPClassUID), uid}, {"1.2.3", "2.25.77"}}};
        for (int i = 0; i < 257; ++i) {
            said_.palette.red.push_back(std::uint16_t(255 * i));
            said_.palette.green.push_back(std::uint16_t(65535 - i));
            said_.palette.blue.push_back(i == 128 ? 65535 : 0);
            said_.palette.alpha.push_back(std::uint16_t(i * i));
        }
        said_.palette.values = {-1024.0, 3071.0};
        said_.samplingStepMm = 0.7;
        said_.cropping.boxes = {{{-1.0, 2.0 / 3.0, -3.0}, {10.0, 20.0, 30.1}}};
        said_.cropping.planes = {{glm::normalize(glm::dvec3(1.0, 2.0, -3.0)), 12.3}, {{0.0, 0.0, 1.0}, -4.5}};
        said_.view = {.projection = Projection::perspective,
                      .positionMm = {700.1, 1.0 / 3.0, -4.0},
                      .lookAtMm = {0.1, -0.2, 0.3},
                      .up = {0.0, 0.1, 0.9},
                      .field = {-311.0, 312.0, 200.5, -200.25, 0.5, 1234.5}};
        said_.shading = PresentedShading{.isDoubleSided = false,
                                         .ambient = 0.1,
                                         .diffuse = 0.9,
                                         .specular = 1.0 / 3.0,
                                         .shininess = 0.078125,
                                         .lightDirection = glm::normalize(glm::dvec3(-1.0, 0.5, 0.25))};
        said_.ownState = R"({"version":1,"note":"\u00fc"})";
    }

    PresentationState readBack() {
        const Result<void> done = writePresentationState(path_, said_, owner_);
        EXPECT_TRUE(done.ok()) << (done ? "" : done.error().message.english());
        return read();
    }
    PresentationState read() const {
        auto state = readPresentationState(path_);
        EXPECT_TRUE(state.ok()) << (state ? "" : state.error().message.english());
        return state ? *std::move(state) : PresentationState{};
    }
    // As another program would.
    void change(const std::function<void(DcmDataset&)>& edit) const {
        DcmFileFormat file;
        ASSERT_TRUE(file.loadFile(path_.c_str()).good());
        edit(*file.getDataset());
        ASSERT_TRUE(file.saveFile(path_.c_str(), EXS_LittleEndianExplicit).good());
    }
    static DcmItem& item(DcmItem& of, const DcmTagKey& sequence, long place = 0) {
        DcmItem* found = nullptr;
        EXPECT_TRUE(of.findOrCreateSequenceItem(sequence, found, place).good()) << sequence.toString();
        return *found;
    }
    static void setPoint(DcmDataset& of, const DcmTagKey& tag, const std::array<double, 3>& xyz) {
        EXPECT_TRUE(of.putAndInsertFloat64Array(tag, xyz.data(), 3).good());
    }
    static DcmItem& component(DcmDataset& dataset) {
        return item(item(dataset, DCM_VolumeStreamSequence),
                    DCM_PresentationStateClassificationComponentSequence);
    }
    void expectRefused(const std::string& words) const {
        const auto state = readPresentationState(path_);
        ASSERT_FALSE(state.ok()) << words;
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(state.error().message.english().find(words), std::string::npos) << state.error().message;
        EXPECT_FALSE(state.error().hint.empty());
    }
    static bool tellsOf(const PresentationState& state, std::string_view key, const std::string& words) {
        return std::ranges::any_of(state.messages, [&](const Message& m) {
            return m.key == key && m.sentence.english().find(words) != std::string::npos;
        });
    }

    const TemporaryFolder folder_;
    const fs::path path_ = folder_ / "presentation.dcm";
    fs::path source_;
    VolumePresentation said_;
    NewObject owner_;
};

TEST_F(PresentationStateTest, IsReadToTheLastBit) {
    PresentationState state = readBack();
    EXPECT_EQ(state.presentation, said_);
    EXPECT_TRUE(state.messages.empty());
    EXPECT_FALSE(state.hasForeignChanges);

    // Without all that may be missing.
    said_.shading.reset();
    said_.samplingStepMm.reset();
    said_.cropping = {};
    said_.ownState.clear();
    said_.description.clear();
    said_.view.projection = Projection::orthographic;
    for (const RenderingMethod method : {RenderingMethod::maximum, RenderingMethod::minimum}) {
        said_.method = method;
        said_.palette = {.values = {0.5, 1.25}, .red = {}, .green = {}, .blue = {}, .alpha = {}};
        state = readBack();
        EXPECT_EQ(state.presentation, said_);
        EXPECT_TRUE(state.messages.empty());
    }
    // The largest table there is, whose size is written as 0.
    said_.method = RenderingMethod::volumeRendered;
    said_.palette.alpha.assign(65536, 7);
    said_.palette.alpha.back() = 65535;
    EXPECT_EQ(readBack().presentation, said_);
}

TEST_F(PresentationStateTest, AnIntervalThatTextCannotHoldIsNearAndStillMaculasOwn) {
    said_.palette.values = {-1000.0 / 3.0, 2000.0 / 7.0};
    const PresentationState state = readBack();
    EXPECT_NEAR(state.presentation.palette.values.low, said_.palette.values.low, 1e-9);
    EXPECT_NEAR(state.presentation.palette.values.high, said_.palette.values.high, 1e-9);
    EXPECT_EQ(state.presentation.ownState, said_.ownState);
}

TEST_F(PresentationStateTest, BelongsToTheStudyAndRefersToItsImages) {
    readBack();
    DcmFileFormat original;
    DcmFileFormat written;
    ASSERT_TRUE(original.loadFile(source_.c_str()).good());
    ASSERT_TRUE(written.loadFile(path_.c_str()).good());
    DcmDataset& is = *written.getDataset();
    for (const DcmTagKey& tag : {DCM_SpecificCharacterSet, DCM_PatientName, DCM_PatientID,
                                 DCM_StudyInstanceUID, DCM_AccessionNumber, DCM_FrameOfReferenceUID})
        EXPECT_EQ(textOf(is, tag), textOf(*original.getDataset(), tag)) << tag.toString();
    EXPECT_NE(textOf(is, DCM_SeriesInstanceUID), said_.series.seriesInstanceUid);
    EXPECT_EQ(textOf(is, DCM_Modality), "PR");
    // The scan lists it under its study, and takes it for no error.
    const auto scanned = scan(folder_.path());
    ASSERT_TRUE(scanned);
    EXPECT_TRUE(scanned->skipped.empty());
    // Only one of the images is of that patient: the others are a study of their own.
    const Series* series = nullptr;
    for (const Study& study : scanned->studies) {
        for (const Series& each : study.series) {
            if (each.modality != "PR") continue;
            series = &each;
            EXPECT_EQ(study.patientId, "0042");
        }
    }
    ASSERT_NE(series, nullptr);
    ASSERT_EQ(series->objects.size(), 1u);
    EXPECT_EQ(series->objects[0].label, said_.description);
    EXPECT_EQ(series->objects[0].referencedSeriesUids,
              std::vector<std::string>{said_.series.seriesInstanceUid});
    EXPECT_TRUE(hasMessage(*series, key::kPresentationState));
    EXPECT_FALSE(hasMessage(*series, key::kUnsupportedSopClass));
}

TEST_F(PresentationStateTest, OfNobodyOnlyWhoHasTheSeriesKnowsIt) {
    owner_.isDeidentified = true;
    owner_.image.reset();
    const PresentationState state = readBack();
    EXPECT_EQ(state.presentation.ownState, said_.ownState);
    EXPECT_TRUE(isSeries(state.presentation.series, sha256Hex(said_.series.seriesInstanceUid)));
    EXPECT_FALSE(isSeries(state.presentation.series, sha256Hex("2.25.1")));
    EXPECT_FALSE(isSeries(state.presentation.series, "phantom"));
    EXPECT_FALSE(isSeries(state.presentation.series, ""));
    const std::string bytes = bytesOf(path_);
    for (const std::string& uid : {said_.series.seriesInstanceUid, said_.series.frameOfReferenceUid,
                                   said_.series.images[0].sopInstanceUid, std::string("ller^Anna")})
        for (const std::string& told : {uid, uidFrom(uid), sha256Hex(uid)})
            EXPECT_EQ(bytes.find(told), std::string::npos) << told;
    EXPECT_NE(bytes.find("ANONYMOUS"), std::string::npos);
    EXPECT_NE(bytes.find("MACULA-"), std::string::npos) << "an ID of its own";
}

// Types 1 and 2 of the modules of A.80.2-1, as PS3.3 lists them.
TEST_F(PresentationStateTest, HasWhatItsModulesAskFor) {
    readBack();
    DcmFileFormat file;
    ASSERT_TRUE(file.loadFile(path_.c_str()).good());
    DcmDataset& is = *file.getDataset();
    for (const DcmTagKey& tag : {DCM_SOPClassUID,
                                 DCM_SOPInstanceUID,
                                 DCM_Modality,
                                 DCM_SeriesInstanceUID,
                                 DCM_StudyInstanceUID,
                                 DCM_FrameOfReferenceUID,
                                 DCM_Manufacturer,
                                 DCM_ManufacturerModelName,
                                 DCM_DeviceSerialNumber,
                                 DCM_SoftwareVersions,
                                 DCM_InstanceNumber,
                                 DCM_ContentLabel,
                                 DCM_PresentationCreationDate,
                                 DCM_PresentationCreationTime,
                                 DCM_VolumetricPresentationInputSetSequence,
                                 DCM_VolumetricPresentationStateInputSequence,
                                 DCM_GlobalCrop,
                                 DCM_GlobalCroppingSpecificationIndex,
                                 DCM_VolumeCroppingSequence,
                                 DCM_ViewCodeSequence,
                                 DCM_RenderProjection,
                                 DCM_ViewpointPosition,
                                 DCM_ViewpointLookAtPoint,
                                 DCM_ViewpointUpDirection,
                                 DCM_RenderFieldOfView,
                                 DCM_RenderingMethod,
                                 DCM_ShadingStyle,
                                 DCM_AmbientReflectionIntensity,
                                 DCM_LightDirection,
                                 DCM_PixelPresentation,
                                 DCM_VolumeStreamSequence,
                                 DCM_ICCProfile,
                                 DCM_ReferencedSeriesSequence})
        EXPECT_TRUE(is.tagExistsWithValue(tag)) << tag.toString();
    for (const DcmTagKey& tag :
         {DCM_PatientName, DCM_PatientBirthDate, DCM_StudyTime, DCM_ReferringPhysicianName, DCM_SeriesNumber,
          DCM_PositionReferenceIndicator, DCM_ContentDescription, DCM_ContentCreatorName})
        EXPECT_TRUE(is.tagExists(tag)) << tag.toString();
    DcmItem& set = item(is, DCM_VolumetricPresentationInputSetSequence);
    DcmItem& input = item(is, DCM_VolumetricPresentationStateInputSequence);
    DcmItem& stream = item(is, DCM_VolumeStreamSequence);
    const std::string uid = textOf(set, DCM_VolumetricPresentationInputSetUID);
    EXPECT_FALSE(uid.empty());
    EXPECT_EQ(textOf(input, DCM_VolumetricPresentationInputSetUID), uid);
    EXPECT_EQ(textOf(stream, DCM_VolumetricPresentationInputSetUID), uid);
    EXPECT_EQ(textOf(set, DCM_PresentationInputType), "VOLUME");
    EXPECT_EQ(textOf(item(set, DCM_ReferencedImageSequence, 1), DCM_ReferencedSOPInstanceUID), "2.25.77");
    EXPECT_EQ(textOf(input, DCM_Crop), "NO");
    EXPECT_EQ(textOf(component(is), DCM_ComponentType), "ONE_TO_RGBA");
    EXPECT_EQ(textOf(item(is, DCM_ViewCodeSequence), DCM_CodeMeaning), "Left");
    // The indices of C.11.23.5 are numbers of C.11.24.
    Uint16 number = 0;
    ASSERT_TRUE(is.findAndGetUint16(DCM_GlobalCroppingSpecificationIndex, number, 1).good());
    EXPECT_EQ(number, 2);
    ASSERT_TRUE(item(is, DCM_VolumeCroppingSequence, 1)
                    .findAndGetUint16(DCM_CroppingSpecificationNumber, number)
                    .good());
    EXPECT_EQ(number, 2);
}

TEST_F(PresentationStateTest, DcmtkOpensIt) {
    for (const bool isDeidentified : {false, true}) {
        owner_.isDeidentified = isDeidentified;
        readBack();
        expectOpensInDcmtk(path_);
    }
}

TEST_F(PresentationStateTest, TheCheckerFindsNoError) {
    if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "dciodvfy is not installed: packaging/bootstrap";
    for (const bool isDeidentified : {false, true}) {
        owner_.isDeidentified = isDeidentified;
        readBack();
        const fs::path report = folder_ / "report.txt";
        std::ignore =
            std::system(fmt::format("dciodvfy '{}' >'{}' 2>&1", path_.string(), report.string()).c_str());
        std::istringstream lines(bytesOf(report));
        std::size_t seen = 0;
        for (std::string line; std::getline(lines, line); ++seen) {
            // Versions up to 2022 do not know the modules of this class, and check all else.
            if (line == "Error - Information Object Not found") continue;
            EXPECT_EQ(line.find("Error"), std::string::npos) << line;
        }
        EXPECT_GT(seen, 0u);
    }
}

TEST_F(PresentationStateTest, TheProfileIsWhole) {
    const std::vector<std::uint8_t> profile = srgbProfile();
    const auto word = [&](std::size_t at) {
        return std::size_t{profile[at]} << 24 | std::size_t{profile[at + 1]} << 16 |
               std::size_t{profile[at + 2]} << 8 | profile[at + 3];
    };
    EXPECT_EQ(word(0), profile.size());
    EXPECT_EQ(profile.size() % 4, 0u);
    EXPECT_EQ(std::string(profile.begin() + 36, profile.begin() + 40), "acsp");
    ASSERT_EQ(word(128), 10u);
    std::array<double, 3> white{};
    for (std::size_t tag = 0; tag < 10; ++tag) {
        const std::size_t entry = 132 + 12 * tag;
        const std::string name(profile.begin() + std::ptrdiff_t(entry),
                               profile.begin() + std::ptrdiff_t(entry) + 4);
        const std::size_t at = word(entry + 4);
        ASSERT_LE(at + word(entry + 8), profile.size()) << name;
        if (name == "rXYZ" || name == "gXYZ" || name == "bXYZ") {
            for (std::size_t i = 0; i < 3; ++i)
                white[i] += double(std::int32_t(word(at + 8 + 4 * i))) / 65536.0;
        }
    }
    // The primaries at full make the white of the connection space.
    EXPECT_NEAR(white[0], 0.9642, 1e-3);
    EXPECT_NEAR(white[1], 1.0, 1e-3);
    EXPECT_NEAR(white[2], 0.8249, 1e-3);
}

TEST_F(PresentationStateTest, WhatDoesNotFitIsRefusedAndWritesNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::function<void(VolumePresentation&, NewObject&)>> wrongs{
        [](auto& p, auto&) { p.label = "lower case"; },
        [](auto& p, auto&) { p.label = ""; },
        [](auto& p, auto&) { p.description = std::string(65, 'a'); },
        [](auto& p, auto&) { p.description = "one\\two"; },
        [](auto& p, auto&) { p.ownState = "M\xfcller"; },
        [](auto& p, auto&) { p.ownState = std::string(300000, 'a'); },
        [](auto& p, auto&) { p.series.images.clear(); },
        [](auto& p, auto&) { p.series.frameOfReferenceUid.clear(); },
        [](auto& p, auto&) { p.palette.red.pop_back(); },
        [](auto& p, auto&) { p.palette.alpha.resize(1); },
        [](auto& p, auto&) {
            p.palette.values = {1.0, 1.0};
        },
        [&](auto& p, auto&) { p.palette.values.low = nan; },
        [&](auto& p, auto&) { p.view.positionMm.x = nan; },
        [](auto& p, auto&) { p.view.lookAtMm = p.view.positionMm; },
        [](auto& p, auto&) { p.view.field.nearMm = 0.0; },
        [](auto& p, auto&) { p.view.field.farMm = p.view.field.nearMm; },
        [&](auto& p, auto&) { p.cropping.boxes[0].low.y = nan; },
        [](auto& p, auto&) { p.cropping.planes[0].outward *= 2.0; },
        [](auto& p, auto&) { p.samplingStepMm = 0.0; },
        [](auto& p, auto&) { p.shading->ambient = 1.5; },
        [](auto&, auto& owner) { owner.image.reset(); },
        [](auto&, auto& owner) { owner.softwareVersion.clear(); },
    };
    for (std::size_t i = 0; i < wrongs.size(); ++i) {
        VolumePresentation said = said_;
        NewObject owner = owner_;
        wrongs[i](said, owner);
        const Result<void> done = writePresentationState(path_, said, owner);
        ASSERT_FALSE(done.ok()) << i;
        EXPECT_EQ(done.error().code, ErrorCode::usage) << i;
        EXPECT_FALSE(fs::exists(path_)) << i;
    }
    NewObject another = owner_;
    another.image->sopInstanceUid += "1";
    EXPECT_EQ(writePresentationState(path_, said_, another).error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(writePresentationState(folder_ / "gone" / "a.dcm", said_, owner_).error().code,
              ErrorCode::outputNotWritable);
    EXPECT_FALSE(fs::exists(path_));
}

TEST_F(PresentationStateTest, WhatAnotherProgramChangedIsNoLongerMaculasOwn) {
    readBack();
    change([](DcmDataset& is) { setPoint(is, DCM_ViewpointPosition, {500.0, 1.0, 2.0}); });
    const PresentationState state = read();
    EXPECT_TRUE(state.hasForeignChanges);
    EXPECT_TRUE(state.presentation.ownState.empty());
    EXPECT_TRUE(tellsOf(state, key::kPresentationChanged, "Another program"));
    EXPECT_EQ(state.presentation.view.positionMm.x, 500.0);
}

TEST_F(PresentationStateTest, WhatCannotBeShownIsTold) {
    struct Case {
        std::function<void(DcmDataset&)> edit;
        std::string_view key;
        std::string words;
    };
    const std::vector<Case> cases{
        {[](DcmDataset& is) { is.putAndInsertString(DCM_PresentationAnimationStyle, "SWIVEL"); },
         key::kPresentationLeftOut, "an animation"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumetricPresentationStateInputSequence, 1)
                 .putAndInsertUint16(DCM_VolumetricPresentationInputNumber, 2);
         },
         key::kPresentationLeftOut, "more than one input"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumeStreamSequence, 1)
                 .putAndInsertString(DCM_VolumetricPresentationInputSetUID, "2.25.5");
         },
         key::kPresentationLeftOut, "blended"},
        {[](DcmDataset& is) {
             item(component(is), DCM_ComponentInputSequence, 1)
                 .putAndInsertUint16(DCM_VolumetricPresentationInputIndex, 1);
         },
         key::kPresentationLeftOut, "colours of more than one"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumeCroppingSequence, 1)
                 .putAndInsertString(DCM_VolumeCroppingMethod, "INCLUDE_SEG");
         },
         key::kPresentationLeftOut, "by a segmentation"},
        {[](DcmDataset& is) {
             item(is, DCM_GraphicAnnotationSequence).putAndInsertString(DCM_GraphicLayer, "A");
         },
         key::kPresentationLeftOut, "drawings"},
        {[](DcmDataset& is) {
             item(item(is, DCM_VolumetricPresentationInputSetSequence),
                  DCM_ReferencedSpatialRegistrationSequence)
                 .putAndInsertString(DCM_ReferencedSOPInstanceUID, "2.25.6");
         },
         key::kPresentationLeftOut, "registration"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumetricPresentationStateInputSequence)
                 .putAndInsertUint16(DCM_InputSequencePositionIndex, 1);
         },
         key::kPresentationLeftOut, "in time"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumetricPresentationStateInputSequence)
                 .putAndInsertString(DCM_VOILUTFunction, "SIGMOID");
         },
         key::kPresentationApproximated, "window"},
        {[](DcmDataset& is) { is.putAndInsertString(DCM_ColorSpace, "ADOBERGB"); },
         key::kPresentationApproximated, "colours of another space"},
        {[](DcmDataset& is) { is.putAndInsertFloat64(DCM_AmbientReflectionIntensity, 3.0); },
         key::kPresentationLeftOut, "shading"},
    };
    for (const Case& c : cases) {
        readBack();
        change(c.edit);
        const PresentationState state = read();
        EXPECT_TRUE(tellsOf(state, c.key, c.words)) << c.words;
        EXPECT_TRUE(state.presentation.ownState.empty()) << c.words;
        EXPECT_FALSE(state.presentation.series.images.empty()) << c.words;
    }
}

TEST_F(PresentationStateTest, WhatAPictureCannotBeMadeWithoutIsAnError) {
    struct Case {
        std::function<void(DcmDataset&)> edit;
        std::string words;
    };
    const std::vector<Case> cases{
        {[](DcmDataset& is) { is.findAndDeleteElement(DCM_ViewpointPosition); }, "looked from"},
        {[](DcmDataset& is) { is.findAndDeleteElement(DCM_RenderFieldOfView); }, "looked from"},
        {[](DcmDataset& is) { is.putAndInsertString(DCM_RenderProjection, "FISHEYE"); }, "looked from"},
        {[](DcmDataset& is) {
             setPoint(is, DCM_ViewpointPosition, {0.0, std::numeric_limits<double>::infinity(), 0.0});
         },
         "looked from"},
        {[](DcmDataset& is) { is.putAndInsertString(DCM_RenderingMethod, "AVERAGE_IP"); }, "method"},
        {[](DcmDataset& is) { is.findAndDeleteElement(DCM_VolumeStreamSequence); }, "colours"},
        {[](DcmDataset& is) { component(is).findAndDeleteElement(DCM_GreenPaletteColorLookupTableData); },
         "colours"},
        {[](DcmDataset& is) { component(is).putAndInsertString(DCM_AlphaLUTTransferFunction, "MAGIC"); },
         "colours"},
        {[](DcmDataset& is) { is.findAndDeleteElement(DCM_VolumetricPresentationInputSetSequence); },
         "images"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumetricPresentationInputSetSequence)
                 .putAndInsertString(DCM_PresentationInputType, "SURFACE");
         },
         "no volume"},
        {[](DcmDataset& is) { is.findAndDeleteElement(DCM_ReferencedSeriesSequence); }, "images"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumeCroppingSequence).putAndInsertUint16(DCM_CroppingSpecificationNumber, 9);
         },
         "missing in the file"},
        {[](DcmDataset& is) {
             item(is, DCM_VolumeCroppingSequence).findAndDeleteElement(DCM_BoundingBoxCrop);
         },
         "damaged"},
        {[](DcmDataset& is) {
             item(item(is, DCM_VolumetricPresentationStateInputSequence), DCM_VOILUTSequence)
                 .putAndInsertString(DCM_LUTExplanation, "A");
         },
         "VOI LUT"},
        {[](DcmDataset& is) { is.putAndInsertString(DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.11.1"); },
         "no presentation state"},
    };
    for (const Case& c : cases) {
        readBack();
        change(c.edit);
        expectRefused(c.words);
    }
}

TEST_F(PresentationStateTest, WhatMayNotBeReadAndWhatIsNoDicomAreToldApart) {
    std::ofstream(path_) << "a letter to somebody, and no presentation state at all";
    expectRefused("not a DICOM presentation state");
    readBack();
    fs::permissions(path_, fs::perms::none);
    const WithoutRootsRights nobody;
    expectRefused("The file cannot be read.");
    EXPECT_NE(readPresentationState(path_).error().hint.english().find("permissions"), std::string::npos);
    EXPECT_EQ(readPresentationState(folder_ / "gone.dcm").error().message, "The file cannot be read.");
}

TEST_F(PresentationStateTest, ACutFileIsASentence) {
    readBack();
    const std::string whole = bytesOf(path_);
    const fs::path cut = folder_ / "cut.dcm";
    for (std::size_t bytes = 0; bytes < whole.size(); bytes += 61) {
        std::ofstream(cut, std::ios::binary) << whole.substr(0, bytes);
        const auto state = readPresentationState(cut);
        // All that makes the picture may be there already.
        if (state) {
            EXPECT_EQ(state->presentation.view, said_.view) << bytes;
        } else {
            EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable) << bytes;
        }
    }
    // Each byte of what steers the reading, the other way round.
    for (std::size_t at = 132; at < whole.size(); at += 97) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(~damaged[at]);
        std::ofstream(cut, std::ios::binary) << damaged;
        const auto state = readPresentationState(cut);
        EXPECT_TRUE(state.ok() || !state.error().message.empty()) << at;
    }
    EXPECT_FALSE(readPresentationState(folder_ / "gone.dcm").ok());
    EXPECT_FALSE(readPresentationState(folder_.path()).ok());
    EXPECT_FALSE(readPresentationState(source_).ok()) << "a CT image";
}

TEST_F(PresentationStateTest, OfOtherProgramsTheWindowAndThePlanesCountAsTheyAreMeant) {
    said_.cropping.planes = {{{0.0, 0.0, 1.0}, -4.5}};
    readBack();
    change([](DcmDataset& is) {
        DcmItem& input = item(is, DCM_VolumetricPresentationStateInputSequence);
        input.putAndInsertString(DCM_WindowCenter, "40");
        input.putAndInsertString(DCM_WindowWidth, "400");
        input.findAndDeleteElement(DCM_VOILUTFunction);
        // The same plane, at another scale and sign; the normal says the side.
        const std::array<double, 4> plane{0.0, 0.0, -2.0, -9.0};
        item(item(is, DCM_VolumeCroppingSequence, 1), DCM_ObliqueCroppingPlaneSequence)
            .putAndInsertFloat64Array(DCM_Plane, plane.data(), 4);
    });
    PresentationState state = read();
    EXPECT_EQ(state.presentation.palette.values, (ValueRange{-160.0, 239.0})) << "LINEAR, C.11.2.1.2.1";
    EXPECT_EQ(state.presentation.cropping.planes, said_.cropping.planes);
    change([](DcmDataset& is) {
        DcmItem& input = item(is, DCM_VolumetricPresentationStateInputSequence);
        input.findAndDeleteElement(DCM_WindowCenter);
        input.findAndDeleteElement(DCM_WindowWidth);
    });
    EXPECT_EQ(read().presentation.palette.values, (ValueRange{0.0, 256.0})) << "the entries themselves";
}

TEST(PaletteSegments, AreExpandedAndNeverTrusted) {
    using Words = std::vector<std::uint16_t>;
    // Two entries, a line to 100 over four, and both once more by their place.
    const Words words{0, 2, 0, 20, 1, 4, 100, 2, 2, 0, 0};
    const auto expanded = expandSegments(words, 12);
    ASSERT_TRUE(expanded);
    EXPECT_EQ(*expanded, (Words{0, 20, 40, 60, 80, 100, 0, 20, 40, 60, 80, 100}));
    EXPECT_FALSE(expandSegments(words, 11));
    EXPECT_FALSE(expandSegments(words, 13));
    EXPECT_FALSE(expandSegments(words, 70000));
    EXPECT_FALSE(expandSegments(Words{1, 4, 100}, 4)) << "a line from nowhere";
    EXPECT_FALSE(expandSegments(Words{0, 9, 1, 2}, 9)) << "cut off";
    EXPECT_FALSE(expandSegments(Words{0, 1, 5, 2, 1, 6, 0}, 2)) << "of itself";
    EXPECT_FALSE(expandSegments(Words{0, 1, 5, 2, 65535, 0, 0}, 2)) << "more than there are";
    EXPECT_FALSE(expandSegments(Words{7, 1, 5}, 1)) << "of an unknown kind";
    EXPECT_FALSE(expandSegments(Words{}, 2));
}

TEST(Uids, AreTheSameOfATextAndOfItsDigest) {
    EXPECT_EQ(uidFromSha256(sha256Hex("1.2.3")), uidFrom("1.2.3"));
    EXPECT_NE(uidFrom("1.2.3"), uidFrom("1.2.4"));
    EXPECT_LE(uidFromSha256(std::string(64, 'f')).size(), 64u);
}

}  // namespace
}  // namespace macula::dicom::test
