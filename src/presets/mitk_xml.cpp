#include "presets/importers.h"

#include "base/parsing.h"
#include "presets/preset_name.h"
#include "presets/vtk_curve.h"
#include "presets/xml_document.h"

namespace macula::presets {

namespace {

// Reads attributes of points, and keeps the first error.
class PointReader {
  public:
    explicit PointReader(const PresetText& file) : file_(file) {}

    double value(pugi::xml_node point, const char* key) {
        return number(point, key, -kLargestValue, kLargestValue);
    }
    double fraction(pugi::xml_node point, const char* key) { return number(point, key, 0.0, 1.0); }
    // Reads a height, clamped as VTK does.
    double height(pugi::xml_node point, const char* key) {
        const double read = number(point, key, -kLargestValue, kLargestValue);
        const double inside = std::min(std::max(read, 0.0), 1.0);
        clamped_ = clamped_ || inside != read;
        return inside;
    }
    bool clamped() const { return clamped_; }
    Result<void> status() const {
        if (error_) return *error_;
        return {};
    }

  private:
    double number(pugi::xml_node point, const char* key, double low, double high) {
        const std::optional<double> read = finiteNumber(point.attribute(key).value());
        if (read && *read >= low && *read <= high) return *read;
        if (!error_) {
            error_ = Error{ErrorCode::inputNotUsable,
                           Text("A point of {} has no usable {}.", point.parent().name(), key), file_.where,
                           Text("Give it a number from {:g} to {:g}.", low, high)};
        }
        return low > 0.0 ? low : 0.0;
    }

    const PresetText& file_;
    bool clamped_ = false;
    std::optional<Error> error_;
};

Result<std::vector<pugi::xml_node>> pointsOf(pugi::xml_node function, const char* curve,
                                             const PresetText& file) {
    std::vector<pugi::xml_node> points;
    for (const pugi::xml_node point : function.child(curve).children("point")) points.push_back(point);
    if (points.empty() || points.size() > kMostPoints) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The {} of the transfer function has {} points.", curve, points.size()), file.where,
                     Text("Give it 1 to {} points.", kMostPoints)};
    }
    return points;
}

Result<std::vector<OpacityPoint>> opacityOf(pugi::xml_node function, const char* curve,
                                            const PresetText& file, PointReader& reader) {
    MACULA_TRY(const std::vector<pugi::xml_node> nodes, pointsOf(function, curve, file));
    std::vector<OpacityPoint> points;
    for (const pugi::xml_node node : nodes)
        points.push_back({reader.value(node, "x"), reader.height(node, "y")});
    sortAsAdded(points, false);
    return points;
}

}  // namespace

Result<ImportedPresets> presetsFromMitkXml(const PresetText& file) {
    MACULA_TRY(const XmlDocument document, XmlDocument::parse(file.text, file.where));
    const pugi::xml_node root = document.root();
    if (const pugi::xml_node version = root.child("Version");
        version && version.attribute("TransferfunctionVersion").as_int() != 1) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The version of the MITK transfer function is not known."), file.where,
                     Text("Only version 1 can be read.")};
    }
    const pugi::xml_node node = root.child("TransferFunction");
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    if (!nameAfter(function, file.fallbackName)) preset.notes.push_back(assumedHounsfield());
    function.source = "MITK";

    PointReader reader(file);
    MACULA_TRY(function.opacity, opacityOf(node, "ScalarOpacity", file, reader));
    MACULA_TRY(function.gradientOpacity, opacityOf(node, "GradientOpacity", file, reader));
    MACULA_TRY(const std::vector<pugi::xml_node> colours, pointsOf(node, "Color", file));
    for (const pugi::xml_node point : colours) {
        function.colour.push_back(
            {reader.value(point, "x"),
             {reader.height(point, "r"), reader.height(point, "g"), reader.height(point, "b")},
             reader.fraction(point, "midpoint"),
             reader.fraction(point, "sharpness")});
    }
    MACULA_TRY_VOID(reader.status());
    sortAsAdded(function.colour, false);
    if (reader.clamped())
        preset.notes.emplace_back(Text("Opacities or colours outside 0 to 1 were clamped."));
    return ImportedPresets{std::move(preset)};
}

}  // namespace macula::presets
