// Each of 3D Slicer's presets, as it is carried and as presets.xml gives it, against its numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"
#include "presets/importers.h"
#include "presets/slicer_numbers.h"

namespace macula {
namespace {

std::vector<double> numbersOf(std::string_view text) {
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    std::vector<double> numbers;
    for (double number = 0.0; stream >> number;) numbers.push_back(number);
    return numbers;
}

// VTK's piecewise-linear rule, written again in the plainest way: over groups of `stride` numbers, the height
// at `column`.
double heightAt(const std::vector<double>& curve, std::size_t stride, std::size_t column, double x) {
    if (x <= curve[0]) return curve[column];
    for (std::size_t i = stride; i < curve.size(); i += stride) {
        if (x > curve[i]) continue;
        const double x0 = curve[i - stride];
        const double s = (x - x0) / (curve[i] - x0);
        return (1.0 - s) * curve[i - stride + column] + s * curve[i + column];
    }
    return curve[curve.size() - stride + column];
}

// At each point of a curve, between points, and beyond its ends.
std::vector<double> placesOn(const std::vector<double>& curve, std::size_t stride) {
    std::vector<double> places{curve.front() - 100.0, curve[curve.size() - stride] + 100.0};
    for (std::size_t i = 0; i < curve.size(); i += stride) {
        places.push_back(curve[i]);
        if (i == 0) continue;
        for (const double u : {0.001, 0.25, 0.5, 0.9, 0.999})
            places.push_back(curve[i - stride] + u * (curve[i] - curve[i - stride]));
    }
    return places;
}

void expectSame(const TransferFunction& preset, const slicer::Numbers& numbers) {
    SCOPED_TRACE(std::string(numbers.name));
    EXPECT_EQ(preset.title, numbers.name);
    const std::vector<double> opacity = numbersOf(numbers.opacity);
    ASSERT_EQ(preset.opacity.size() * 2, opacity.size());
    for (std::size_t i = 0; i < preset.opacity.size(); ++i) {
        EXPECT_EQ(preset.opacity[i], (OpacityPoint{opacity[2 * i], opacity[2 * i + 1]}));
    }
    for (const double x : placesOn(opacity, 2)) {
        const double expected = heightAt(opacity, 2, 1, x);
        EXPECT_NEAR(opacityAt(preset, x), expected, 1e-12) << x;
        // Nothing is hidden in the step from opacity to extinction: one mm of it lets 1 - opacity through.
        if (expected < 0.999) {
            EXPECT_NEAR(std::exp(-extinctionPerMm(preset, x)), 1.0 - expected, 1e-12) << x;
        }
    }
    const std::vector<double> colour = numbersOf(numbers.colour);
    ASSERT_EQ(preset.colour.size() * 4, colour.size());
    for (const double x : placesOn(colour, 4)) {
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(colourAt(preset, x)[channel], heightAt(colour, 4, std::size_t(channel) + 1, x), 1e-12)
                << x;
    }
    const std::vector<double> gradient = numbersOf(numbers.gradient);
    ASSERT_EQ(preset.gradientOpacity.size() * 2, gradient.size());
    for (const double x : placesOn(gradient, 2)) {
        EXPECT_NEAR(gradientOpacityAt(preset, x), heightAt(gradient, 2, 1, x), 1e-12) << x;
    }
    const std::vector<double> light = numbersOf(numbers.light);
    EXPECT_EQ(preset.lighting, (Lighting{numbers.shade, light[0], light[1], light[2], light[3]}));
    EXPECT_EQ(preset.interpolation, Interpolation::linear);
    EXPECT_EQ(preset.unitDistanceMm, 1.0);
    EXPECT_EQ(preset.density, 1.0);
    EXPECT_EQ(preset.effectiveRange.has_value(), !numbers.range.empty());
    if (preset.effectiveRange) {
        const std::vector<double> range = numbersOf(numbers.range);
        EXPECT_EQ(*preset.effectiveRange, (ValueRange{range[0], range[1]}));
    }
    EXPECT_EQ(preset.unit, numbers.name.starts_with("CT-") ? Unit::hounsfield : Unit::raw);
}

TEST(SlicerNumbers, AreWhatTheBuiltInPresetsHold) {
    for (std::size_t i = 0; i < slicer::kPresets.size(); ++i) {
        bool found = false;
        for (const auto& file : presets::transferFiles()) {
            const auto preset = transferFunctionFromJson(file.text, std::string(file.name));
            ASSERT_TRUE(preset.ok());
            if (preset->number != static_cast<int>(i + 1)) continue;
            found = true;
            EXPECT_EQ(preset->source, "3D Slicer");
            expectSame(*preset, slicer::kPresets[i]);
        }
        EXPECT_TRUE(found) << slicer::kPresets[i].name;
    }
}

TEST(SlicerNumbers, AreWhatPresetsXmlGives) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<MRML>\n";
    for (const slicer::Numbers& numbers : slicer::kPresets) {
        const auto counted = [](std::string_view curve) {
            return fmt::format("{} {}", numbersOf(curve).size(), curve);
        };
        const std::vector<double> light = numbersOf(numbers.light);
        xml += fmt::format(
            "<VolumeProperty selected=\"false\" name=\"{}\" scalarOpacity=\"{}\" colorTransfer=\"{} \" "
            "gradientOpacity=\"{}\" shade=\"{}\" ambient=\"{}\" diffuse=\"{}\" specular=\"{}\" "
            "specularPower=\"{}\" interpolation=\"1\" effectiveRange=\"{}\"/>\n",
            numbers.name, counted(numbers.opacity), counted(numbers.colour), counted(numbers.gradient),
            numbers.shade ? 1 : 0, light[0], light[1], light[2], light[3],
            numbers.name == "CT-X-ray" ? "-250.0.0 1550.0"
            : numbers.range.empty()    ? "0 -1"
                                       : numbers.range);
    }
    const auto read = presets::presetsFromSlicerXml({xml + "</MRML>\n", "presets.xml", "presets"});
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->size(), slicer::kPresets.size());
    for (std::size_t i = 0; i < read->size(); ++i) {
        expectSame((*read)[i].function, slicer::kPresets[i]);
        // The one range with a typing error is said to be left out, and nothing else has to be said.
        EXPECT_EQ((*read)[i].notes.size(), slicer::kPresets[i].name == "CT-X-ray" ? 1u : 0u);
    }
}

// So says the reference: volren replaces such curves by their cumulated sum, and shows lungs as solid bodies.
TEST(SlicerNumbers, TenAreNotMonotone) {
    int count = 0;
    for (const slicer::Numbers& numbers : slicer::kPresets) {
        const std::vector<double> curve = numbersOf(numbers.opacity);
        bool falls = false;
        for (std::size_t i = 3; i < curve.size(); i += 2) falls = falls || curve[i] < curve[i - 2];
        count += falls ? 1 : 0;
    }
    EXPECT_EQ(count, 10);
}

}  // namespace
}  // namespace macula
