#include "opened.h"

#include <algorithm>
#include <cmath>

namespace macula::dicom::test {

Opened::Opened(const std::filesystem::path& path) {
    if (auto found = test::scan(path)) scan_ = std::move(*found);
}

std::vector<const Series*> Opened::series() const {
    std::vector<const Series*> result;
    for (const Study& study : scan_.studies) {
        for (const Series& series : study.series) result.push_back(&series);
    }
    return result;
}

std::vector<const Stack*> Opened::stacks() const {
    std::vector<const Stack*> result;
    for (const Series* series : series()) {
        for (const Stack& stack : series->stacks) result.push_back(&stack);
    }
    return result;
}

std::vector<const Stack*> Opened::volumes() const {
    std::vector<const Stack*> result = stacks();
    std::erase_if(result, [](const Stack* stack) { return !stack->canBeVolume(); });
    return result;
}

std::vector<OtherObject> Opened::others() const {
    std::vector<OtherObject> result;
    for (const Series* series : series())
        result.insert(result.end(), series->objects.begin(), series->objects.end());
    return result;
}

std::size_t Opened::frames() const {
    std::size_t count = 0;
    for (const Stack* stack : stacks()) count += stack->frames.size();
    return count;
}

std::shared_ptr<const Volume> Opened::load(const Stack& stack) const {
    for (const Series* series : series()) {
        for (const Stack& own : series->stacks) {
            if (&own != &stack) continue;
            Progress progress;
            auto volume = loadVolume(*series, stack, progress);
            if (volume) return *volume;
            ADD_FAILURE() << "loading: " << volume.error().message << " [" << keys() << "]";
            return nullptr;
        }
    }
    ADD_FAILURE() << "not a stack of this folder";
    return nullptr;
}

std::shared_ptr<const Volume> Opened::onlyVolume() const {
    const auto found = volumes();
    if (found.size() != 1) {
        ADD_FAILURE() << found.size() << " volumes in " << stacks().size() << " stacks [" << keys() << "]";
        return nullptr;
    }
    return load(*found.front());
}

std::vector<const Message*> Opened::messages() const {
    std::vector<const Message*> result;
    const auto add = [&](const std::vector<Message>& messages) {
        for (const Message& message : messages) result.push_back(&message);
    };
    add(scan_.messages);
    for (const SkippedFile& file : scan_.skipped) result.push_back(&file.message);
    for (const Series* series : series()) {
        add(series->messages);
        for (const Stack& stack : series->stacks) add(stack.messages);
    }
    return result;
}

const Message* Opened::find(std::string_view key) const& {
    for (const Message* message : messages()) {
        if (message->key == key) return message;
    }
    return nullptr;
}

std::string Opened::keys() const {
    std::string result;
    for (const Message* message : messages()) result += message->key + " ";
    return result;
}

double numberArgument(const Message& message, std::string_view name) {
    for (const TextArgument& argument : message.arguments) {
        if (argument.name != name) continue;
        if (const auto* number = std::get_if<double>(&argument.value)) return *number;
        if (const auto* whole = std::get_if<std::int64_t>(&argument.value))
            return static_cast<double>(*whole);
    }
    ADD_FAILURE() << message.key << " has no number " << name;
    return 0.0;
}

void expectOnlyVolume(const Opened& opened, const SyntheticSeries& series) {
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
}

void expectPhases(const Opened& opened, const SyntheticSeries& series) {
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), static_cast<std::size_t>(series.phases)) << opened.keys();
    EXPECT_EQ(opened.frames(), static_cast<std::size_t>(series.phases * series.size.z));
    for (int phase = 0; phase < series.phases; ++phase) {
        SCOPED_TRACE(fmt::format("phase {}", phase));
        const auto volume = opened.load(*volumes[static_cast<std::size_t>(phase)]);
        ASSERT_NE(volume, nullptr);
        expectVolumeOf(*volume, series, phase);
    }
}

void expectPhasesInAnyOrder(const Opened& opened, const SyntheticSeries& series) {
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), static_cast<std::size_t>(series.phases)) << opened.keys();
    EXPECT_EQ(opened.frames(), static_cast<std::size_t>(series.phases * series.size.z));
    const glm::dvec3 first = transformPoint(series.expectedAffine(), {0, 0, 0});
    std::vector<int> phases;
    for (const Stack* stack : volumes) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        const double above = volume->value(0, 0, 0) - series.rampOf()(first);
        phases.push_back(static_cast<int>(std::lround(above / series.phaseStep)));
        expectVolumeOf(*volume, series, phases.back());
    }
    std::sort(phases.begin(), phases.end());
    for (int phase = 0; phase < series.phases; ++phase)
        EXPECT_EQ(phases[static_cast<std::size_t>(phase)], phase);
}

}  // namespace macula::dicom::test
