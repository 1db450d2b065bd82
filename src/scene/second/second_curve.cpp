#include "scene/second/second_curve.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <utility>

#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"

namespace macula::scene {

namespace {

constexpr int kColours = 16;           // pieces of a colour table
constexpr double kClearPart = 0.25;    // share of the window, as over slices
constexpr double kMostOpacity = 0.95;  // the highest opacity of a millimetre

}  // namespace

TransferFunction secondCurve(const Volume& second, const DisplayWindow& window, slices::ColourTable colours,
                             double opacity) {
    const double low = window.center - 0.5 * window.width;
    TransferFunction function;
    function.name = "second";
    function.title = "Window and colours";
    function.unit = second.unit();
    function.opacity = {
        {.value = low + kClearPart * window.width, .opacity = 0.0},
        {.value = low + window.width, .opacity = kMostOpacity * std::clamp(opacity, 0.0, 1.0)}};
    for (int i = 0; i <= kColours; ++i) {
        const auto grey = static_cast<std::uint8_t>(255 * i / kColours);
        const slices::Rgb rgb = slices::colourOf(colours, grey);
        function.colour.push_back({.value = low + window.width * i / kColours,
                                   .colour = glm::dvec3(rgb.red, rgb.green, rgb.blue) / 255.0});
    }
    return function;
}

bool isSecondIn3d(const SecondVolumeState& state) {
    return state.in3d && state.isLinked() && state.view != SecondVolumePlace::hidden;
}

SecondVolumeState secondPartIn3d(SecondVolumeState state) {
    const SecondVolumeState usual;
    state.view = usual.view;
    state.linksWindow = usual.linksWindow;
    state.boundMm = usual.boundMm;
    state.rivalMm = usual.rivalMm;
    state.isodoses = usual.isodoses;
    if (!state.preset) return state;
    state.window = usual.window;
    state.opacity = usual.opacity;
    state.colours = usual.colours;
    return state;
}

bool maySecondBeIn3d(const study::Identity& study, const study::Identity& second) {
    return study::samePatient(study, second) != study::SamePatient::no;
}

DrawnSecondVolume secondIn3d(const SecondVolumeState& state, std::shared_ptr<const Volume> second) {
    TransferFunction function = state.preset
                                    ? fitted(*state.preset, *second)
                                    : secondCurve(*second, state.window.value_or(seriesWindow(*second)),
                                                  state.colours, state.opacity);
    DrawnSecondVolume made;
    made.function = std::make_shared<const TransferFunction>(std::move(function));
    made.secondFromVolumeMm = state.secondFromStudy;
    made.volume = std::move(second);
    return made;
}

Text secondRemark(const Volume& second, const SecondVolumeState& state, study::SamePatient patient) {
    const std::string& modality = second.modality();
    const bool isCode = !modality.empty() && modality.size() <= 16 &&
                        std::ranges::all_of(modality, [](unsigned char c) { return std::isalnum(c) != 0; });
    std::vector<Text> remarks{isCode ? Text("with {}", modality) : Text("with a second volume")};
    if (state.link == SecondVolumeLink::registered && state.isDoubtful)
        remarks.push_back(Text("registration doubtful"));
    if (patient == study::SamePatient::no) remarks.push_back(Text("of ANOTHER PATIENT"));
    if (patient == study::SamePatient::unknown) remarks.push_back(Text("perhaps of another patient"));
    return Text::joined(std::move(remarks), ", ");
}

}  // namespace macula::scene
