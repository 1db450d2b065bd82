// What Mesa's lavapipe does silently, and what our kernels do about it. The validation layer sees none of it.
//
// 1. An invocation runs at most 65535 rounds of loops, all its loops together; then each loop ends after its
//    first round. So a dispatch must do less than that per invocation: slice the work over several
//    dispatches.
// 2. Mesa 22.3.6 (Debian 12) miscompiles a common loop form: a value loaded from a storage buffer inside a
//    divergent loop and used after it, as in `while (true) { m = a[k]; if (m > t) break; ++k; } use(m);`, is
//    0 in every lane that left earlier than the last one. Our kernels use the forms of loop_forms.comp.
#include <random>

#include "gpu/gpu_test.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

class Lavapipe : public GpuTest {};

TEST_F(Lavapipe, RunsTheSafeLoopFormsRightly) {
    constexpr std::uint32_t kCount = 512;
    constexpr std::uint32_t kSearches = 777;
    constexpr float kThreshold = 0.9f;
    std::mt19937 random(7);
    std::vector<float> values(kCount);
    for (float& value : values) value = static_cast<float>(random() % 1000 + 1) / 1001.0f;
    std::vector<std::uint32_t> starts(kSearches);
    for (std::uint32_t& start : starts) start = random() % kCount;

    std::vector<float> expected;
    for (std::uint32_t k : starts) {
        while (k + 1 < kCount && values[k] <= kThreshold) ++k;
        expected.push_back(values[k]);
    }

    const Buffer valuesBuffer = expectOk(Buffer::create(device(), {.label = "values", .bytes = kCount * 4}));
    const Buffer startsBuffer =
        expectOk(Buffer::create(device(), {.label = "starts", .bytes = kSearches * 4}));
    const Buffer found = expectOk(Buffer::create(device(), {.label = "found", .bytes = kSearches * 4}));
    expectOk(uploadTo<float>(valuesBuffer, values));
    expectOk(uploadTo<std::uint32_t>(startsBuffer, starts));
    struct {
        std::uint32_t count = kCount;
        std::uint32_t searches = kSearches;
        float threshold = kThreshold;
    } const push;
    for (const std::uint32_t form : {0u, 1u, 2u}) {
        const Kernel kernel = expectOk(
            Kernel::create(device(), shaders::loop_forms_comp, {.specializations = {{"kForm", form}}}));
        auto recorder = expectOk(Recorder::create(device(), "loop"));
        recorder.fill(found, 0);
        recorder.dispatch(kernel, {kSearches}, push, {valuesBuffer, startsBuffer, found});
        expectOk(recorder.submit());
        EXPECT_EQ(expectOk(read<float>(found)), expected) << "form " << form;
    }
}

TEST_F(Lavapipe, RunsAtMost65535RoundsOfLoopsInAnInvocation) {
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::loop_limit_comp));
    const Buffer result = expectOk(Buffer::create(device(), {.label = "rounds", .bytes = 8}));
    struct Push {
        std::uint32_t once;
        std::uint32_t outer;
        std::uint32_t inner;
    };
    const auto rounds = [&](const Push& push) {
        auto recorder = expectOk(Recorder::create(device(), "rounds"));
        recorder.dispatch(kernel, {8}, push, {result});
        expectOk(recorder.submit());
        return expectOk(read<std::uint32_t>(result));
    };
    using Rounds = std::vector<std::uint32_t>;
    EXPECT_EQ(rounds({65'000, 10, 10}), (Rounds{65'000, 100}));
    EXPECT_EQ(rounds({0, 100, 600}), (Rounds{0, 60'000}));
    if (!device()->isCpu()) GTEST_SKIP() << "only lavapipe has the limit";
    // When this fails, Mesa has lifted the limit: good news.
    EXPECT_EQ(rounds({100'000, 0, 0}), (Rounds{65'535, 0}));
    EXPECT_EQ(rounds({65'000, 1'000, 1'000})[0], 65'000u);
    EXPECT_LT(rounds({0, 1'000, 1'000})[1], 65'536u);
}

}  // namespace
}  // namespace macula::gpu
