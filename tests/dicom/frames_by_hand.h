// Frames made by hand, for tests of what is made of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/split/split.h"

namespace macula::dicom::test {

inline std::size_t attribute(std::string_view name) {
    const auto& all = splitRules().attributes;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Attribute& a) { return a.name == name; });
    EXPECT_NE(found, all.end()) << name;
    return static_cast<std::size_t>(found - all.begin());
}

class Frames {
  public:
    // An axial CT-like frame at `z` mm.
    Frame& add(double z) {
        auto instance = std::make_shared<Instance>();
        ++number_;
        instance->sopInstanceUid = "1.2." + std::to_string(number_);
        instance->instanceNumber = number_;
        instance->transferSyntaxUid = "1.2.840.10008.1.2.1";
        instance->photometricInterpretation = "MONOCHROME2";
        instance->columns = instance->rows = 16;
        instance->format = CellFormat{};
        Frame frame;
        frame.instance = instance;
        frame.imageType = {"ORIGINAL", "PRIMARY", "AXIAL"};
        frame.positionMm = glm::dvec3(0, 0, z);
        frame.plane = ImagePlane{.positionMm = *frame.positionMm};
        frame.hasOrientation = true;
        frame.spacingSource = PixelSpacingSource::pixelSpacing;
        frame.slope = 1.0;
        frame.intercept = 0.0;
        frame.attributes.assign(splitRules().attributes.size(), "");
        frames.push_back(std::move(frame));
        set("InstanceNumber", std::to_string(number_));
        set("ImageOrientationPatient", "1\\0\\0\\0\\1\\0");
        return frames.back();
    }

    // Of the frame that was added last.
    Frames& set(std::string_view name, const std::string& value) {
        for (std::size_t i = 0; i < splitRules().attributes.size(); ++i) {
            if (splitRules().attributes[i].name == name) frames.back().attributes[i] = value;
        }
        return *this;
    }

    Instance& instance() { return const_cast<Instance&>(*frames.back().instance); }

    std::vector<Frame> frames;

  private:
    int number_ = 0;
};

inline bool has(const std::vector<Message>& messages, std::string_view key) {
    return std::any_of(messages.begin(), messages.end(), [&](const Message& m) { return m.key == key; });
}

inline std::string keys(const Split& split) {
    std::string text;
    for (const Message& m : split.messages) text += m.key + " ";
    for (const Stack& stack : split.stacks) {
        text += "| " + std::to_string(stack.frames.size()) + ": ";
        for (const Message& m : stack.messages) text += m.key + " ";
    }
    return text;
}

// The image numbers of every stack, and that no frame is lost or doubled.
inline std::vector<std::set<int>> numbers(const Split& split, std::size_t total) {
    std::vector<std::set<int>> stacks;
    std::size_t count = 0;
    for (const Stack& stack : split.stacks) {
        std::set<int> of;
        for (const Frame& frame : stack.frames) of.insert(*frame.instance->instanceNumber);
        count += stack.frames.size();
        stacks.push_back(std::move(of));
    }
    EXPECT_EQ(count, total);
    return stacks;
}

inline Split splitOf(const Frames& made, const std::string& modality = "CT") {
    Split split = splitSeries(made.frames, modality, splitRules());
    const auto expected = numbers(split, made.frames.size());
    // Whatever order the files come in.
    std::mt19937 random(7);
    for (int i = 0; i < 3; ++i) {
        std::vector<Frame> shuffled = made.frames;
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        EXPECT_EQ(numbers(splitSeries(shuffled, modality, splitRules()), made.frames.size()), expected);
    }
    return split;
}

}  // namespace macula::dicom::test
