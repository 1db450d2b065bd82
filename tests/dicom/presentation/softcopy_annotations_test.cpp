// Graphics and texts of presentation states: those of ../shared/data against their truth, and nonsense.
#include "dicom/presentation/softcopy_annotations.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "dicom/presentation/softcopy_state.h"
#include "support.h"
#include "synthetic_softcopy.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Kind = SoftcopyGraphic::Kind;

SoftcopyState stateWith(const Edit& edit) {
    const TemporaryFolder folder;
    SyntheticSoftcopy softcopy{.imageUids = {"2.25.1"}};
    softcopy.edits.push_back(edit);
    writeSoftcopy(folder / "state.dcm", softcopy);
    const auto read = readSoftcopyState(folder / "state.dcm");
    EXPECT_TRUE(read);
    return read ? *read : SoftcopyState{};
}

void addGraphic(DcmItem& item, const char* type, const std::vector<Float32>& data,
                const char* units = "PIXEL") {
    DcmItem& annotation = nested(item, DCM_GraphicAnnotationSequence);
    put(annotation, DCM_GraphicLayer, "ONE");
    DcmItem& graphic = appended(annotation, DCM_GraphicObjectSequence);
    put(graphic, DCM_GraphicAnnotationUnits, units);
    put(graphic, DCM_GraphicType, type);
    graphic.putAndInsertFloat32Array(DCM_GraphicData, data.data(), static_cast<unsigned long>(data.size()));
}

TEST(SoftcopyAnnotations, OfKindsAndNumbersThatMakeNoSenseAreLeftOutAndTold) {
    const float infinite = std::numeric_limits<float>::infinity();
    const SoftcopyState state = stateWith([&](DcmItem& item) {
        addGraphic(item, "POLYLINE", {1, 2, 3, 4});
        addGraphic(item, "POLYLINE", {1, 2, 3});
        addGraphic(item, "CIRCLE", {1, 2});
        addGraphic(item, "ELLIPSE", {1, 2, 3, 4, infinite, 6, 7, 8});
        addGraphic(item, "SPIRAL", {1, 2, 3, 4});
        addGraphic(item, "POINT", {1, 2}, "MILES");
    });
    ASSERT_EQ(state.annotations.all.size(), 1u);
    ASSERT_EQ(state.annotations.all[0].graphics.size(), 1u);
    EXPECT_EQ(state.annotations.all[0].graphics[0].points, (std::vector<glm::dvec2>{{1, 2}, {3, 4}}));
    EXPECT_TRUE(state.annotations.hasOthers);
    EXPECT_EQ(state.leftOutOfImages, std::vector<Text>{Text("annotations of other kinds")});
}

TEST(SoftcopyAnnotations, LieInTheOrderOfTheirLayers) {
    const SoftcopyState state = stateWith([](DcmItem& item) {
        for (const char* name : {"UPPER", "LOWER"}) {
            DcmItem& annotation = appended(item, DCM_GraphicAnnotationSequence);
            put(annotation, DCM_GraphicLayer, name);
            DcmItem& layer = appended(item, DCM_GraphicLayerSequence);
            put(layer, DCM_GraphicLayer, name);
            put(layer, DCM_GraphicLayerOrder, *name == 'U' ? "7" : "3");
            putWord(layer, DCM_GraphicLayerRecommendedDisplayGrayscaleValue, *name == 'U' ? 0x4000 : 0xffff);
        }
    });
    ASSERT_EQ(state.annotations.all.size(), 2u);
    EXPECT_EQ(state.annotations.all[0].layer, "LOWER");
    EXPECT_EQ(state.annotations.all[1].grey, 0x40);
    EXPECT_TRUE(state.leftOutOfImages.empty());
    EXPECT_EQ(state.leftOut, std::vector<Text>{Text("annotations")}) << "of slices they are";
}

void expectGraphics(const SoftcopyAnnotation& read, const Json& truth) {
    static const std::map<std::string, Kind> kKinds{{"POINT", Kind::point},
                                                    {"POLYLINE", Kind::polyline},
                                                    {"INTERPOLATED", Kind::interpolated},
                                                    {"CIRCLE", Kind::circle},
                                                    {"ELLIPSE", Kind::ellipse}};
    ASSERT_EQ(read.graphics.size(), truth["graphics"].size());
    for (std::size_t i = 0; i < read.graphics.size(); ++i) {
        const SoftcopyGraphic& graphic = read.graphics[i];
        const Json& wanted = truth["graphics"][i];
        EXPECT_EQ(graphic.kind, kKinds.at(wanted["type"]));
        EXPECT_EQ(graphic.units == GraphicUnits::display, wanted["units"] == "DISPLAY");
        EXPECT_EQ(graphic.isFilled, wanted["filled"] == "Y");
        ASSERT_EQ(2 * graphic.points.size(), wanted["points"].size());
        for (std::size_t p = 0; p < graphic.points.size(); ++p) {
            EXPECT_NEAR(graphic.points[p].x, wanted["points"][2 * p].get<double>(), 1e-6);
            EXPECT_NEAR(graphic.points[p].y, wanted["points"][2 * p + 1].get<double>(), 1e-6);
        }
    }
    ASSERT_EQ(read.texts.size(), truth["texts"].size());
    for (std::size_t i = 0; i < read.texts.size(); ++i) {
        const Json& wanted = truth["texts"][i];
        std::string text;
        for (const std::string& line : read.texts[i].lines) text += (text.empty() ? "" : "\r\n") + line;
        EXPECT_EQ(text, wanted["text"].get<std::string>());
        EXPECT_EQ(read.texts[i].box.has_value(), !wanted["box"].is_null());
        EXPECT_EQ(read.texts[i].anchor.has_value(), !wanted["anchor"].is_null());
        EXPECT_EQ(read.texts[i].justification == SoftcopyText::Justification::centre,
                  wanted["justification"] == "CENTER");
    }
}

TEST(SoftcopyAnnotations, OfRealFilesAreTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = sharedData() / "planar";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    std::ifstream stream(data / "truth" / "2_structured.json");
    const Json all = Json::parse(stream);
    std::size_t states = 0;
    for (const auto& [name, truth] : all.items()) {
        if (!truth.is_object() || !truth.contains("gsps")) continue;
        SCOPED_TRACE(name);
        ++states;
        const Json& wanted = truth["gsps"];
        const auto read = readSoftcopyState(data / name);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_FALSE(read->annotations.hasOthers);
        ASSERT_EQ(read->annotations.all.size(), wanted["annotations"].size());
        // Layers reorder them: those of one layer keep their order.
        for (const Json& each : wanted["annotations"]) {
            const auto same = std::ranges::find_if(read->annotations.all, [&](const SoftcopyAnnotation& a) {
                return a.layer == each["layer"] && a.graphics.size() == each["graphics"].size() &&
                       a.texts.size() == each["texts"].size();
            });
            ASSERT_NE(same, read->annotations.all.end());
            expectGraphics(*same, each);
        }
        EXPECT_EQ(read->shutter.has_value(), wanted.contains("ShutterShape"));
        EXPECT_EQ(read->isInverse, wanted["PresentationLUTShape"] == "INVERSE");
        if (wanted.contains("overlay_activation_layers")) {
            EXPECT_EQ(read->overlays.size(), wanted["overlay_activation_layers"].size());
        }
    }
    EXPECT_GE(states, 3u);
}

}  // namespace
}  // namespace macula::dicom::test
