#include "dicom/presentation/softcopy_annotations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "dicom/read/presentation_tags.h"

namespace macula::dicom {

namespace {

namespace tags = presentation_tag;

constexpr Tag kLayer{0x0070, 0x0002};
constexpr Tag kBoxUnits{0x0070, 0x0003};
constexpr Tag kAnchorUnits{0x0070, 0x0004};
constexpr Tag kGraphicUnits{0x0070, 0x0005};
constexpr Tag kUnformattedText{0x0070, 0x0006};
constexpr Tag kTexts{0x0070, 0x0008};
constexpr Tag kGraphics{0x0070, 0x0009};
constexpr Tag kBoxTopLeft{0x0070, 0x0010};
constexpr Tag kBoxBottomRight{0x0070, 0x0011};
constexpr Tag kJustification{0x0070, 0x0012};
constexpr Tag kAnchorPoint{0x0070, 0x0014};
constexpr Tag kAnchorVisibility{0x0070, 0x0015};
constexpr Tag kGraphicData{0x0070, 0x0022};
constexpr Tag kGraphicType{0x0070, 0x0023};
constexpr Tag kGraphicFilled{0x0070, 0x0024};
constexpr Tag kLayers{0x0070, 0x0060};
constexpr Tag kLayerOrder{0x0070, 0x0062};
constexpr Tag kLayerGrey{0x0070, 0x0066};
constexpr Tag kLayerColour{0x0070, 0x0401};
constexpr Tag kCompounds{0x0070, 0x0209};
constexpr std::size_t kMostObjects = 10'000;
constexpr std::size_t kMostPoints = 100'000;  // of one graphic
constexpr std::size_t kMostLines = 200;       // of one text
constexpr double kFarthest = 1e6;

struct Layer {
    int order = 0;
    std::uint8_t grey = 255;
};

// MATRIX differs from PIXEL only for images in tiles.
std::optional<GraphicUnits> unitsOf(const Dataset& item, Tag tag) {
    const std::string units = item.shortText(tag);
    if (units == "PIXEL" || units == "MATRIX") return GraphicUnits::pixel;
    return units == "DISPLAY" ? std::optional(GraphicUnits::display) : std::nullopt;
}

bool isNear(double value) {
    return std::isfinite(value) && std::abs(value) <= kFarthest;
}

std::optional<glm::dvec2> pointOf(const Dataset& item, Tag tag) {
    const auto numbers = item.numbers(tag, 2);
    if (!numbers || !isNear((*numbers)[0]) || !isNear((*numbers)[1])) return {};
    return glm::dvec2((*numbers)[0], (*numbers)[1]);
}

std::map<std::string, Layer> layersOf(const Dataset& file) {
    constexpr double kMostLightness = 65535.0;
    std::map<std::string, Layer> layers;
    for (const Dataset& item : file.items(kLayers)) {
        Layer layer{.order = item.integer(kLayerOrder).value_or(0)};
        if (const auto grey = item.word(kLayerGrey)) layer.grey = static_cast<std::uint8_t>(*grey >> 8);
        // Of CIELab, the lightness.
        const std::vector<std::uint16_t> lab = item.words(kLayerColour);
        if (!item.has(kLayerGrey) && lab.size() == 3)
            layer.grey = static_cast<std::uint8_t>(std::lround(255.0 * lab[0] / kMostLightness));
        layers.emplace(item.shortText(kLayer), layer);
    }
    return layers;
}

std::optional<SoftcopyGraphic> graphicOf(const Dataset& item) {
    using Kind = SoftcopyGraphic::Kind;
    static const std::map<std::string, std::pair<Kind, std::size_t>> kKinds{
        {"POINT", {Kind::point, 1}},
        {"POLYLINE", {Kind::polyline, 2}},
        {"INTERPOLATED", {Kind::interpolated, 2}},
        {"CIRCLE", {Kind::circle, 2}},
        {"ELLIPSE", {Kind::ellipse, 4}}};
    const auto kind = kKinds.find(item.shortText(kGraphicType));
    const auto units = unitsOf(item, kGraphicUnits);
    const std::vector<double> numbers = item.allNumbers(kGraphicData);
    if (kind == kKinds.end() || !units || numbers.size() % 2 != 0 || numbers.size() / 2 > kMostPoints ||
        numbers.size() / 2 < kind->second.second || !std::ranges::all_of(numbers, isNear))
        return {};
    SoftcopyGraphic graphic{.kind = kind->second.first, .units = *units};
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        graphic.points.emplace_back(numbers[i], numbers[i + 1]);
    graphic.isFilled = item.shortText(kGraphicFilled) == "Y";
    return graphic;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char letter : text) {
        if (letter == '\n')
            lines.emplace_back();
        else if (letter != '\r')
            lines.back() += letter;
        if (lines.size() == kMostLines) break;
    }
    return lines;
}

std::optional<SoftcopyText> textOf(const Dataset& item) {
    SoftcopyText text{.lines = linesOf(item.text(kUnformattedText).value_or(""))};
    const auto topLeft = pointOf(item, kBoxTopLeft);
    const auto bottomRight = pointOf(item, kBoxBottomRight);
    const auto boxUnits = unitsOf(item, kBoxUnits);
    if (topLeft && bottomRight && boxUnits) text.box = SoftcopyText::Box{*topLeft, *bottomRight, *boxUnits};
    const auto anchor = pointOf(item, kAnchorPoint);
    const auto anchorUnits = unitsOf(item, kAnchorUnits);
    if (anchor && anchorUnits)
        text.anchor = SoftcopyText::Anchor{*anchor, *anchorUnits, item.shortText(kAnchorVisibility) != "N"};
    if (!text.box && !text.anchor) return {};
    const std::string justification = item.shortText(kJustification);
    if (justification == "RIGHT") text.justification = SoftcopyText::Justification::right;
    if (justification == "CENTER") text.justification = SoftcopyText::Justification::centre;
    return text;
}

}  // namespace

SoftcopyAnnotations readAnnotations(const Dataset& file) {
    const std::map<std::string, Layer> layers = layersOf(file);
    SoftcopyAnnotations read;
    std::size_t objects = 0;
    for (const Dataset& item : file.items(tags::kGraphicAnnotations)) {
        SoftcopyAnnotation annotation{.images = referencedFrames(item.items(tags::kReferencedImages)),
                                      .layer = item.shortText(kLayer)};
        if (const auto layer = layers.find(annotation.layer); layer != layers.end()) {
            annotation.order = layer->second.order;
            annotation.grey = layer->second.grey;
        }
        for (const Dataset& each : item.items(kGraphics)) {
            auto graphic = ++objects <= kMostObjects ? graphicOf(each) : std::nullopt;
            read.hasOthers = read.hasOthers || !graphic;
            if (graphic) annotation.graphics.push_back(*std::move(graphic));
        }
        for (const Dataset& each : item.items(kTexts)) {
            auto text = ++objects <= kMostObjects ? textOf(each) : std::nullopt;
            read.hasOthers = read.hasOthers || !text;
            if (text) annotation.texts.push_back(*std::move(text));
        }
        read.hasOthers = read.hasOthers || item.itemCount(kCompounds) > 0;
        read.all.push_back(std::move(annotation));
    }
    std::ranges::stable_sort(read.all, {}, &SoftcopyAnnotation::order);
    return read;
}

}  // namespace macula::dicom
