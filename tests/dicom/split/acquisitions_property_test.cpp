// Series of several acquisitions made by chance, with what a scanner, an archive and a copy do to them: no
// volume mixes two acquisitions without a warning.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "frames_by_hand.h"

namespace macula::dicom {
namespace {

using namespace test;

enum class Layout { sameGrid, drift, shifted, overlapping, middle };
enum class Times { none, equal, sweeps, reconstructed, byPosition };
enum class Numbers { blocks, byPosition, random, none };

struct Recipe {
    std::string modality = "CT";
    int acquisitions = 2;
    int positions = 12;
    double stepMm = 2.0;
    double shiftOfStep = 0.0;  // of each acquisition against the one before
    Layout layout = Layout::sameGrid;
    Times times = Times::equal;
    Numbers numbers = Numbers::blocks;
    int missing = 0;     // images that got lost
    int late = 0;        // reconstructed once more, after all others
    int reacquired = 0;  // taken once more, with a number of their own, instead of the first one
    int repeated = 0;    // the same beside the first one
};

struct Image {
    int acquisition = 0;  // the truth
    int place = 0;
    double zMm = 0.0;
    double seconds = 0.0;
    int number = 0;
};

class Chance {
  public:
    explicit Chance(unsigned seed) : random_(seed) {}
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    double upTo(double most) { return most * double(random_()) / double(std::mt19937::max()); }
    template <class T>
    T oneOf(std::initializer_list<T> choices) {
        return *(choices.begin() + below(static_cast<int>(choices.size())));
    }
    template <class T>
    void shuffle(std::vector<T>& items) {
        std::shuffle(items.begin(), items.end(), random_);
    }

  private:
    std::mt19937 random_;
};

double secondsOf(const Recipe& recipe, int acquisition, int place, Chance& chance) {
    switch (recipe.times) {
        case Times::none:
        case Times::equal:
            return 300.0 * acquisition;
        case Times::sweeps:  // one after the other
            return 60.0 * acquisition + 0.5 * place;
        case Times::reconstructed:  // begun before the one before has ended
            return 3.0 * acquisition + 0.5 * place + chance.upTo(0.2);
        case Times::byPosition:  // a film at each position
            return 20.0 * place + 0.8 * acquisition;
    }
    return 0.0;
}

std::vector<Image> imagesOf(const Recipe& recipe, Chance& chance) {
    std::vector<Image> images;
    for (int a = 0; a < recipe.acquisitions; ++a) {
        int first = 0;
        int end = recipe.positions;
        if (recipe.layout == Layout::overlapping) first = a * (recipe.positions - 4);
        if (recipe.layout == Layout::overlapping) end = first + recipe.positions;
        if (recipe.layout == Layout::middle && a > 0) {
            first = recipe.positions / 3;
            end = 2 * recipe.positions / 3 + 1;
        }
        for (int k = first; k < end; ++k) {
            Image image{.acquisition = a, .place = k};
            image.zMm = recipe.stepMm * (k + recipe.shiftOfStep * a);
            image.seconds = secondsOf(recipe, a, k, chance);
            images.push_back(image);
        }
    }
    int number = 0;
    if (recipe.numbers == Numbers::byPosition)
        std::stable_sort(images.begin(), images.end(), [](const Image& a, const Image& b) {
            return std::pair(a.zMm, a.acquisition) < std::pair(b.zMm, b.acquisition);
        });
    std::vector<int> order;
    for (std::size_t n = 0; n < images.size(); ++n) order.push_back(++number);
    if (recipe.numbers == Numbers::random) chance.shuffle(order);
    for (std::size_t n = 0; n < images.size(); ++n) images[n].number = order[n];

    double last = 0.0;
    for (const Image& image : images) last = std::max(last, image.seconds);
    const auto any = [&] { return static_cast<std::size_t>(chance.below(static_cast<int>(images.size()))); };
    for (int n = 0; n < recipe.missing; ++n)
        images.erase(images.begin() + static_cast<std::ptrdiff_t>(any()));
    for (int n = 0; n < recipe.late; ++n) images[any()].seconds = last + 1.0 + chance.upTo(60.0);
    for (int n = 0; n < recipe.reacquired; ++n) {
        Image& image = images[any()];
        image.seconds = last + 40.0 + chance.upTo(60.0);
        image.number = ++number;
    }
    for (int n = 0; n < recipe.repeated; ++n) {
        Image image = images[any()];
        image.acquisition = recipe.acquisitions + n;
        image.seconds = last + 40.0 + chance.upTo(60.0);
        image.number = ++number;
        images.push_back(image);
    }
    return images;
}

std::string clock(double seconds) {
    const int whole = static_cast<int>(seconds);
    return fmt::format("20200102{:02}{:02}{:09.6f}", 10 + whole / 3600, whole / 60 % 60,
                       seconds - 60.0 * (whole / 60));
}

Frames framesOf(const Recipe& recipe, const std::vector<Image>& images) {
    Frames made;
    for (const Image& image : images) {
        made.add(image.zMm);
        if (recipe.times != Times::none)
            made.set(recipe.times == Times::reconstructed ? "ContentTime" : "AcquisitionTime",
                     clock(image.seconds));
        if (recipe.numbers == Numbers::none) {
            made.instance().instanceNumber.reset();
            made.set("InstanceNumber", "");
        } else {
            made.instance().instanceNumber = image.number;
            made.set("InstanceNumber", std::to_string(image.number));
        }
    }
    return made;
}

std::string describe(const Recipe& r) {
    return fmt::format(
        "{} acquisitions {} positions {} step {} shift {} layout {} times {} numbers {} missing {} late {} "
        "reacquired {} repeated {}",
        r.modality, r.acquisitions, r.positions, r.stepMm, r.shiftOfStep, int(r.layout), int(r.times),
        int(r.numbers), r.missing, r.late, r.reacquired, r.repeated);
}

Recipe recipeOf(Chance& chance) {
    Recipe r;
    r.modality = chance.oneOf({"CT", "CT", "MR", "PT"});
    r.acquisitions = 1 + chance.below(5);
    r.positions = 8 + chance.below(14);
    r.stepMm = chance.oneOf({0.625, 1.0, 2.5, 5.0});
    r.layout = chance.oneOf({Layout::sameGrid, Layout::sameGrid, Layout::drift, Layout::shifted,
                             Layout::overlapping, Layout::middle});
    r.times =
        chance.oneOf({Times::none, Times::equal, Times::sweeps, Times::reconstructed, Times::byPosition});
    r.numbers =
        chance.oneOf({Numbers::blocks, Numbers::blocks, Numbers::byPosition, Numbers::random, Numbers::none});
    if (r.layout == Layout::drift) r.shiftOfStep = chance.oneOf({0.002, 0.01, 0.03});
    if (r.layout == Layout::shifted) r.shiftOfStep = chance.oneOf({0.1, 0.3, 0.37, 0.5});
    if (r.layout == Layout::overlapping) r.shiftOfStep = chance.oneOf({0.0, 0.1, 0.3});
    if (r.layout == Layout::middle) r.shiftOfStep = chance.oneOf({0.0, 0.1, 0.4});
    return r;
}

// Two sets of slices half a step apart look like one volume to whoever sees headers only, where neither times
// nor numbers tell: what their values tell is for the loader (key::kAlternatingValues).
bool canBeTold(const Recipe& r) {
    const bool numbersTell = r.numbers == Numbers::blocks && r.modality != "MR";
    const bool timesTell = (r.times == Times::equal || r.times == Times::sweeps) && r.modality != "MR";
    const bool isEven = r.layout == Layout::shifted && std::abs(r.shiftOfStep * r.acquisitions - 1.0) < 0.02;
    return !isEven || timesTell || numbersTell;
}

bool isWarned(const Split& split, const Stack& stack) {
    const auto warns = [](const Message& m) { return m.severity >= Severity::warning; };
    return std::ranges::any_of(split.messages, warns) || std::ranges::any_of(stack.messages, warns);
}

// The acquisitions in a stack.
std::map<int, int> acquisitionsIn(const Stack& stack, const Frames& made, const std::vector<Image>& images) {
    std::map<std::string_view, int> truth;
    for (std::size_t n = 0; n < images.size(); ++n)
        truth[made.frames[n].instance->sopInstanceUid] = images[n].acquisition;
    std::map<int, int> counts;
    for (const Frame& frame : stack.frames) ++counts[truth.at(frame.instance->sopInstanceUid)];
    return counts;
}

TEST(AcquisitionsMadeByChance, NoVolumeMixesTwoWithoutAWarning) {
    int mixed = 0;
    int volumes = 0;
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        Chance chance(seed);
        Recipe recipe = recipeOf(chance);
        recipe.missing = chance.below(4);
        recipe.late = chance.below(3);
        recipe.reacquired = chance.below(2);
        recipe.repeated = chance.below(2);
        if (!canBeTold(recipe)) continue;
        const auto images = imagesOf(recipe, chance);
        const Frames made = framesOf(recipe, images);
        const Split split = splitSeries(made.frames, recipe.modality, splitRules());
        std::size_t frames = 0;
        for (const Stack& stack : split.stacks) {
            frames += stack.frames.size();
            if (!stack.canBeVolume()) continue;
            ++volumes;
            if (acquisitionsIn(stack, made, images).size() < 2) continue;
            ++mixed;
            EXPECT_TRUE(isWarned(split, stack)) << "seed " << seed << ": " << describe(recipe) << "\n"
                                                << keys(split);
        }
        EXPECT_EQ(frames, images.size()) << seed;
    }
    // The warning must not be how every series is passed.
    EXPECT_LT(5 * mixed, volumes);
}

// What nobody disturbed comes apart into its acquisitions, whole and without a warning, where times tell.
TEST(AcquisitionsMadeByChance, UndisturbedOnesAreToldApart) {
    int tried = 0;
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        Chance chance(seed);
        const Recipe recipe = recipeOf(chance);
        const bool timesTell = recipe.times == Times::equal || recipe.times == Times::sweeps ||
                               (recipe.layout == Layout::sameGrid && recipe.times == Times::reconstructed);
        if (!timesTell || recipe.acquisitions < 2 || recipe.modality == "MR") continue;
        ++tried;
        const auto images = imagesOf(recipe, chance);
        const Frames made = framesOf(recipe, images);
        const Split split = splitSeries(made.frames, recipe.modality, splitRules());
        SCOPED_TRACE(fmt::format("seed {}: {}\n{}", seed, describe(recipe), keys(split)));
        EXPECT_EQ(std::ssize(split.stacks), recipe.acquisitions);
        for (const Stack& stack : split.stacks) {
            EXPECT_TRUE(stack.isEven());
            EXPECT_EQ(acquisitionsIn(stack, made, images).size(), 1u);
            EXPECT_FALSE(isWarned(split, stack));
        }
    }
    EXPECT_GT(tried, 200);
}

}  // namespace
}  // namespace macula::dicom
