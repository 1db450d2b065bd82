// Seeds of fuzz_preset and fuzz_state: small texts of each format, with all that a format may have.
#include "fuzz/seeds.h"
#include "live/store/own_preset.h"
#include "pipeline/trace/light_rig_json.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/camera/camera_file.h"
#include "scene/camera/camera_path.h"
#include "scene/slices/own_windows.h"
#include "scene/state/study_state.h"

namespace macula::fuzz {
namespace {

using scene::StudyState;

TransferFunction smallPreset() {
    TransferFunction function;
    function.name = "made-up";
    function.title = "Made up";
    function.modalities = {"CT", "MR"};
    function.opacity = {{-100.0, 0.0, 0.3, 0.2}, {40.0, 0.5}, {300.0, 1.0}};
    function.colour = {{-100.0, glm::dvec3(0.2, 0.1, 0.0), 0.4, 0.9}, {300.0, glm::dvec3(1.0)}};
    function.gradientOpacity = {{0.0, 0.1}, {200.0, 1.0}};
    function.colourSpace = ColourSpace::lab;
    function.fitToVolume = TransferFunction::Fit{-100.0, 300.0, TransferFunction::Fit::To::valueRange};
    function.effectiveRange = ValueRange{-200.0, 400.0};
    function.number = 140;
    return function;
}

Camera oblique() {
    Camera camera;
    camera.positionMm = {250.5, -700.0, 12.5};
    camera.targetMm = {0.1, 0.2, 0.3};
    camera.verticalFovDeg = 42.0;
    return camera;
}

trace::LightRig smallRig() {
    trace::LightRig rig{.name = "rim", .title = "Rim"};
    rig.ambientZenith = {0.28, 0.31, 0.38};
    rig.ambientNadir = {0.08, 0.08, 0.09};
    rig.lights = {{.azimuthDeg = -130.0, .elevationDeg = 25.0, .angularRadiusDeg = 18.0, .radiance = 32.0}};
    return rig;
}

DisplayWindow window() {
    DisplayWindow window;
    window.center = -600.5;
    window.width = 1500.0;
    window.function = "SIGMOID";
    return window;
}

scene::Cuts cuts() {
    scene::Cuts cuts;
    scene::EyeCut eye;
    eye.plane = {.normal = {0.0, 0.6, 0.8}, .offsetMm = -3.0};
    eye.fromMiddleMm = 12.5;
    cuts.eye = eye;
    scene::ScissorCut scissors;
    scissors.camera = oblique();
    scissors.outline = {{-0.5, -0.5}, {0.25, -0.5}, {0.0, 0.7}};
    scissors.removesOutside = true;
    cuts.scissors = {scissors};
    return cuts;
}

scene::SecondVolumeState beside() {
    scene::SecondVolumeState beside;
    beside.seriesDigest = "fedcba";
    beside.volume = 2;
    beside.volumeKey = "abcdef-2";
    beside.pair = "abc123";
    beside.link = scene::SecondVolumeLink::registered;
    beside.secondFromStudy = affine({0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}, {0.5, 7.0, -80.0});
    beside.boundMm = 0.7;
    beside.isDoubtful = true;
    beside.rivalMm = 30.0;
    beside.view = scene::SecondVolumePlace::over;
    beside.window = window();
    beside.opacity = 0.3;
    beside.colours = slices::ColourTable::green;
    beside.in3d = true;
    return beside;
}

std::vector<slices::Measurement> measurements() {
    slices::SlicePlane plane;
    plane.right = {0.6, 0.8, 0.0};
    plane.down = {0.0, 0.0, -1.0};
    slices::Ellipse ellipse;
    ellipse.plane = plane;
    ellipse.radiiMm = {12.5, 3.0};
    return {{.label = "L3, \"höher\"",
             .shape = slices::Distance{{glm::dvec3(0.1, -0.0, 3.0), {4.0, 5.0, 6.0}}},
             .normal = {1.0, 0.0, 0.0}},
            {.shape = slices::Angle{{glm::dvec3(1.0, 2.0, 3.0), {4.0, 5.0, 6.0}, {-7.0, 8.0, 9.0}}},
             .normal = {0.0, -0.6, 0.8}},
            {.label = "liver", .shape = ellipse, .normal = plane.normal()},
            {.label = "node",
             .shape = slices::Bidirectional{.firstMm = {{{0.0, 0.0, 0.0}, {9.0, 0.0, 0.0}}},
                                            .secondMm = {{{4.0, -2.0, 0.0}, {4.0, 2.0, 0.0}}},
                                            .isNode = true}},
            {.shape = slices::Distance{{glm::dvec3(1.0), {2.0, 2.0, 2.0}}}},
            {.shape = slices::Outline{{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 4.0, 0.0}}}}};
}

const std::string kClip =
    R"({"version": 1, "name": "corner", "title": "Corner", "cut": {"at": [0.5, 0.5, 0.5], "towards": "LAS"},
"greyFaces": {"center": 40, "width": 400}, "belowWindow": "black"})";

// Everything that may be chosen, in parts: a seed is to be small.
StudyState seenState() {
    StudyState state;
    state.seriesDigest = "0123456789abcdef";
    state.settings.look = trace::Look::minip;
    state.settings.shading = trace::Shading::none;
    for (const scene::Parameter& p : scene::parameters())
        p.set(state.settings, p.isWhole ? p.high : 0.5 * p.high);
    state.windows.at(std::size_t(trace::Look::minip)) = window();
    state.camera = oblique();
    state.camera->parallelHeightMm = 143.5;
    state.showsMarks = false;
    state.background = scene::BackgroundColour(16, 240, 255);
    state.layout = scene::Layout::sagittal;
    state.slices.window = window();
    state.slices.slab.thicknessMm = 7.5;
    state.slices.isInverted = true;
    state.slices.asAcquired = true;
    state.slices.crosshairMm = glm::dvec3(0.5, -2.0, 1e5);
    state.otherKeys = R"({"ofTomorrow":[1,{"a":null}]})";
    return state;
}

StudyState cutState() {
    StudyState state;
    if (auto clip = clipPresetFromJson(kClip, "clip")) state.clip = *clip;
    state.cuts = cuts();
    scene::NamedClip named;
    named.name = "lungs";
    named.clip = state.clip;
    named.cuts = state.cuts;
    state.namedClips = {named};
    state.measurements = measurements();
    return state;
}

StudyState shownState() {
    StudyState state;
    state.preset = std::make_shared<const TransferFunction>(smallPreset());
    state.lights = std::make_shared<const trace::LightRig>(smallRig());
    state.secondVolume = beside();
    scene::SegmentSettings segment;
    segment.number = 7;
    segment.isVisible = false;
    segment.opacity = 0.25;
    segment.in3d = scene::In3d::alone;
    scene::SegmentationSettings segmentation;
    segmentation.digest = std::string(64, 'd');
    segmentation.isShown = true;
    segmentation.segments = {segment};
    state.segmentations = {segmentation};
    return state;
}

std::string plist(const std::string& inside) {
    return "<plist version=\"1.0\"><dict><key>name</key><string>CT-a</string>" + inside + "</dict></plist>";
}

}  // namespace

void writePresetSeeds(const std::filesystem::path& corpus) {
    const std::filesystem::path folder = corpus / "preset";
    save(folder / "macula", toJson(smallPreset()));
    save(folder / "slicer_json",
         R"({"volumeProperties": [{"effectiveRange": [0, 10], "components": [{"scalarOpacity": {"points":
[{"x": 0, "y": 0, "midpoint": 0.5, "sharpness": 0.5}, {"x": 10, "y": 1}]}, "rgbTransferFunction": {"points":
[{"x": 0, "color": [1, 0.5, 0]}]}}]}]})");
    save(
        folder / "slicer_xml",
        R"(<?xml version="1.0"?><MRML><VolumeProperty name="CT-a" scalarOpacity="4 0 0 10 1" colorTransfer="8 0 1 1 1 9 0 0 0"
gradientOpacity="4 0 1 255 1" shade="1" ambient="0.1" specularPower="10" interpolation="1" effectiveRange="0 10"/></MRML>)");
    save(folder / "slicer_vp", "1\n1\n0.9\n0.1\n0.2\n10\n4 0 0 10 1\n4 0 1 255 1\n8 0 1 0 0 10 0 0 1\n");
    save(
        folder / "paraview",
        R"([{"Name": "CT-a", "ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0]}])");
    save(
        folder / "volview",
        R"({"Name": "MR-a", "AbsoluteRange": true, "ColorSpace": "HSV", "HSVWrap": 1, "EffectiveRange": [0, 1],
"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "OpacityPoints": [0, 0, 1, 1]} // made up)");
    save(
        folder / "mitk",
        R"(<Version TransferfunctionVersion="1"/><TransferFunction><ScalarOpacity><point x="0" y="1"/></ScalarOpacity>
<GradientOpacity><point x="0" y="1"/></GradientOpacity><Color><point x="0" r="1" g="1" b="1" midpoint="0.5" sharpness="0"/></Color></TransferFunction>)");
    save(folder / "horos_curves",
         plist("<key>useShading</key><true/><key>shading</key><string>Glossy Bone</string>"
               "<key>16bitClutCurves</key><array><array><dict><key>x</key><real>0</real><key>y</key>"
               "<real>1</real></dict></array></array><key>16bitClutColors</key><array><array><dict>"
               "<key>red</key><real>1</real><key>green</key><real>1</real><key>blue</key><real>1</real>"
               "</dict></array></array>"));
    std::string shades;
    for (int i = 0; i < 256; ++i) shades += "<integer>" + std::to_string(i) + "</integer>";
    std::string table;
    for (const char* name : {"Red", "Green", "Blue"})
        table += std::string("<key>") + name + "</key><array>" + shades + "</array>";
    save(folder / "horos_table",
         plist("<key>wl</key><integer>40</integer><key>ww</key><real>400</real><key>CLUT</key>"
               "<string>mine</string><key>opacity</key><string>Logarithmic Table</string>") +
             "<!-- the colour table -->" + plist(table));
}

void writeStateSeeds(const std::filesystem::path& corpus) {
    const std::filesystem::path folder = corpus / "state";
    save(folder / "state_seen", "s" + toJson(seenState()));
    save(folder / "state_cut", "s" + toJson(cutState()));
    save(folder / "state_shown", "s" + toJson(shownState()));
    live::OwnPreset own;
    own.id = "own-1";
    own.function = std::make_shared<const TransferFunction>(smallPreset());
    live::SeenLook look;
    look.state.slices.window = window();
    look.camera = live::RelativeCamera{oblique()};
    own.seen = look;
    save(folder / "own_preset", "o" + toJson(own));
    save(folder / "own_windows", "w" + toJson(std::vector<scene::OwnWindow>{{"Kidney", window(), "HU"}}));
    save(folder / "clip", "k" + kClip);
    save(
        folder / "clip_planes",
        R"(k{"version": 1, "name": "left", "title": "Left", "planes": [{"normal": [1, 0, 0], "at": [0.5, 0.5, 0.5]}]})");
    save(folder / "lights", "l" + trace::toJson(smallRig()));
    save(folder / "quality", R"(q{"version": 1, "name": "draft", "title": "Draft", "samplesPerPixel": 1,
"bounces": 16, "filter": "trilinear", "denoise": true})");
    save(folder / "camera", "c" + toJson(oblique()).dump());
    save(folder / "cameras_of_3dgs",
         R"(3[{"id": 0, "img_name": "a.png", "width": 640, "height": 480, "position": [1, 2, 3],
"rotation": [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]], "fy": 500.5, "fx": 500.5, "cx": 320, "cy": 240}])");
    scene::CameraPath path = scene::turntable(oblique(), 40.0, 1.0);
    Camera rolled = oblique();
    rolled.up = {1.0, 0.2, 0.0};
    path.stops.push_back({.atS = 2.0, .camera = rolled});
    save(folder / "camera_path", "p" + toJson(path));
}

}  // namespace macula::fuzz
