#include "pipeline/gpu/spirv_reflection.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <random>
#include <span>
#include <vector>

#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

TEST(Reflection, ReadsBindingsPushConstantsAndSpecializations) {
    const auto result = reflectSpirv(shaders::affine_comp.words);
    ASSERT_TRUE(result.ok()) << result.error().message;
    EXPECT_EQ(result->entryPoint, "main");

    ASSERT_EQ(result->bindings.size(), 3u);
    EXPECT_EQ(result->bindings[0].name, "stored");
    EXPECT_EQ(result->bindings[0].binding, 0u);
    EXPECT_EQ(result->bindings[0].type, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
    EXPECT_EQ(result->bindings[1].binding, 2u);
    EXPECT_EQ(result->bindings[2].name, "result");
    EXPECT_EQ(result->bindings[2].binding, 5u);
    EXPECT_EQ(result->bindings[2].type, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    ASSERT_EQ(result->bindings[2].block.members.size(), 1u);
    EXPECT_EQ(result->bindings[2].block.members[0].arrayStride, 4u);
    EXPECT_EQ(result->bindings[2].block.members[0].arrayLength, 0u);

    ASSERT_TRUE(result->pushConstants.has_value());
    EXPECT_EQ(result->pushConstants->block.bytes, 8u);
    ASSERT_NE(result->pushConstants->block.find("scale"), nullptr);
    EXPECT_EQ(result->pushConstants->block.find("scale")->offset, 4u);
    EXPECT_EQ(result->pushConstants->block.find("no such member"), nullptr);

    const LocalSize& x = result->localSize[0];
    EXPECT_EQ(x.value, 1u);
    EXPECT_EQ(x.specializationId, 0u);
    EXPECT_FALSE(result->localSize[1].specializationId.has_value());
    ASSERT_EQ(result->specializations.size(), 3u);
    bool foundBias = false;
    for (const auto& constant : result->specializations) {
        if (constant.name != "kBias") continue;
        foundBias = true;
        EXPECT_EQ(constant.id, 1u);
        EXPECT_EQ(constant.defaultBits, 0x3f000000u);
    }
    EXPECT_TRUE(foundBias);
}

TEST(Reflection, ReadsImagesAndLocalSize) {
    const auto result = reflectSpirv(shaders::picture_comp.words);
    ASSERT_TRUE(result.ok());
    ASSERT_EQ(result->bindings.size(), 2u);
    EXPECT_EQ(result->bindings[0].type, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    EXPECT_EQ(result->bindings[1].type, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
    EXPECT_FALSE(result->pushConstants.has_value());
    EXPECT_EQ(result->localSize[0].value, 8u);
    EXPECT_EQ(result->localSize[1].value, 4u);
    EXPECT_EQ(result->localSize[2].value, 1u);
}

TEST(Reflection, RefusesWhatIsNoComputeShader) {
    const std::uint32_t text[] = {0x74786574, 0, 0, 0, 0};
    EXPECT_FALSE(reflectSpirv({}).ok());
    EXPECT_FALSE(reflectSpirv(text).ok());
    const auto words = shaders::affine_comp.words;
    EXPECT_FALSE(reflectSpirv(words.first(5)).ok());
    const auto brokenOff = reflectSpirv(words.first(8));  // within the second instruction
    ASSERT_FALSE(brokenOff.ok());
    EXPECT_EQ(brokenOff.error().code, ErrorCode::inputNotUsable);
}

// Words before a page that nobody may read.
class GuardedWords {
  public:
    explicit GuardedWords(std::size_t most) : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
        bytes_ = (most * sizeof(std::uint32_t) + page_ - 1) / page_ * page_;
        memory_ = mmap(nullptr, bytes_ + page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED || mprotect(end(), page_, PROT_NONE) != 0) std::abort();
    }
    ~GuardedWords() { munmap(memory_, bytes_ + page_); }
    GuardedWords(const GuardedWords&) = delete;
    GuardedWords& operator=(const GuardedWords&) = delete;

    std::span<const std::uint32_t> hold(const std::vector<std::uint32_t>& words) {
        const std::size_t size = words.size() * sizeof(std::uint32_t);
        std::memcpy(end() - size, words.data(), size);
        return {reinterpret_cast<const std::uint32_t*>(end() - size), words.size()};
    }

  private:
    std::byte* end() { return static_cast<std::byte*>(memory_) + bytes_; }
    std::size_t page_;
    std::size_t bytes_ = 0;
    void* memory_ = nullptr;
};

// Nothing is read beyond the module, what is no module is refused as such.
TEST(Reflection, SurvivesDamage) {
    std::mt19937 random(1);
    for (const ShaderCode& code : {shaders::affine_comp, shaders::layout_comp, shaders::picture_comp}) {
        GuardedWords guarded(code.words.size());
        int taken = 0;
        constexpr int kRounds = 3000;
        for (int round = 0; round < kRounds; ++round) {
            std::vector<std::uint32_t> words(code.words.begin(), code.words.end());
            for (int hit = 0; hit < 3; ++hit)
                words[random() % words.size()] = random() % 4 ? random() % 64 : random();
            words.resize(random() % 4 ? words.size() : random() % words.size());
            const auto result = reflectSpirv(guarded.hold(words));
            if (!result) {
                ASSERT_EQ(result.error().code, ErrorCode::inputNotUsable);
                continue;
            }
            ++taken;
            ASSERT_FALSE(result->entryPoint.empty());
        }
        EXPECT_GT(taken, kRounds / 10);  // and most damage is seen
        EXPECT_LT(taken, kRounds / 2);
    }
}

}  // namespace
}  // namespace macula::gpu
