#include "pipeline/gpu/spirv_reflection.h"

#include <algorithm>
#include <utility>

namespace macula::gpu {
namespace {

// Numbers of the SPIR-V specification (1.6, unified1) that the parser needs.
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;
enum Op : std::uint32_t {
    opName = 5,
    opMemberName = 6,
    opEntryPoint = 15,
    opExecutionMode = 16,
    opTypeInt = 21,
    opTypeFloat = 22,
    opTypeVector = 23,
    opTypeMatrix = 24,
    opTypeImage = 25,
    opTypeSampledImage = 27,
    opTypeArray = 28,
    opTypeRuntimeArray = 29,
    opTypeStruct = 30,
    opTypePointer = 32,
    opConstant = 43,
    opSpecConstantTrue = 48,
    opSpecConstantFalse = 49,
    opSpecConstant = 50,
    opSpecConstantComposite = 51,
    opVariable = 59,
    opDecorate = 71,
    opMemberDecorate = 72,
    opExecutionModeId = 331,
};
enum Decoration : std::uint32_t {
    decorationSpecId = 1,
    decorationArrayStride = 6,
    decorationMatrixStride = 7,
    decorationBuiltIn = 11,
    decorationBinding = 33,
    decorationDescriptorSet = 34,
    decorationOffset = 35,
};
constexpr std::uint32_t kBuiltInWorkgroupSize = 25;
constexpr std::uint32_t kModelGlCompute = 5;
constexpr std::uint32_t kModeLocalSize = 17;
constexpr std::uint32_t kModeLocalSizeId = 38;
constexpr std::uint32_t kStorageUniformConstant = 0;
constexpr std::uint32_t kStorageUniform = 2;
constexpr std::uint32_t kStoragePushConstant = 9;
constexpr std::uint32_t kStorageStorageBuffer = 12;
constexpr std::uint32_t kDimBuffer = 5;
constexpr std::uint32_t kImageIsStorage = 2;
constexpr int kMaxDepth = 16;  // of nested types: valid modules stay far below it

struct MemberInfo {
    std::string name;
    std::uint32_t offset = 0;
    std::uint32_t matrixStride = 0;
};

// What the module says about one result id.
struct Id {
    std::uint32_t op = 0;
    std::span<const std::uint32_t> operands;  // all words of the instruction after the first
    std::string name;
    std::vector<MemberInfo> members;
    std::uint32_t arrayStride = 0;
    std::uint32_t set = 0;
    std::optional<std::uint32_t> binding;
    std::optional<std::uint32_t> specId;
    bool isWorkgroupSize = false;
};

// Thrown and caught in this file only: parsing fails at many depths, always in the same way.
struct Malformed {
    const char* why;
};

std::string textOf(std::span<const std::uint32_t> words) {
    const auto* text = reinterpret_cast<const char*>(words.data());
    return {text, strnlen(text, words.size_bytes())};
}

class Parser {
  public:
    explicit Parser(std::span<const std::uint32_t> words) : words_(words) {}

    Reflection parse() {
        readInstructions();
        if (reflection_.entryPoint.empty()) throw Malformed{"it has no compute entry point"};
        readLocalSize();
        for (const std::uint32_t variable : variables_) readVariable(id(variable));
        std::sort(reflection_.bindings.begin(), reflection_.bindings.end(), [](const auto& a, const auto& b) {
            return std::pair(a.set, a.binding) < std::pair(b.set, b.binding);
        });
        for (const Id& constant : ids_)
            if (constant.specId) addSpecialization(constant);
        return std::move(reflection_);
    }

  private:
    Id& id(std::uint32_t number) {
        if (number >= ids_.size()) throw Malformed{"it uses an id beyond its bound"};
        return ids_[number];
    }

    static std::uint32_t operand(const Id& of, std::size_t index) { return word(of.operands, index); }
    static std::uint32_t word(std::span<const std::uint32_t> words, std::size_t index) {
        if (index >= words.size()) throw Malformed{"an instruction is too short"};
        return words[index];
    }

    void readInstructions() {
        if (words_.size() < kHeaderWords || words_[0] != kMagic)
            throw Malformed{"it does not start as SPIR-V does"};
        // Every id is made by an instruction, so a module cannot have more ids than words.
        if (words_[3] > words_.size()) throw Malformed{"its bound is larger than the module"};
        ids_.resize(words_[3]);
        for (std::size_t at = kHeaderWords; at < words_.size();) {
            const std::uint32_t count = words_[at] >> 16;
            if (count == 0 || count > words_.size() - at) throw Malformed{"it breaks off"};
            readInstruction(words_[at] & 0xffffu, words_.subspan(at + 1, count - 1));
            at += count;
        }
    }

    void readInstruction(std::uint32_t op, std::span<const std::uint32_t> operands) {
        const auto define = [&](std::size_t resultAt) {
            Id& made = id(word(operands, resultAt));
            made.op = op;
            made.operands = operands;
        };
        switch (op) {
            case opName:
                id(word(operands, 0)).name = textOf(operands.subspan(1));
                break;
            case opMemberName: {
                MemberInfo& info = member(word(operands, 0), word(operands, 1));
                info.name = textOf(operands.subspan(2));
                break;
            }
            case opEntryPoint:
                if (word(operands, 0) != kModelGlCompute) throw Malformed{"it is not a compute shader"};
                reflection_.entryPoint = textOf(operands.subspan(std::min<std::size_t>(2, operands.size())));
                break;
            case opExecutionMode:
            case opExecutionModeId:
                if (word(operands, 1) == kModeLocalSize || word(operands, 1) == kModeLocalSizeId)
                    localSize_ = operands;
                break;
            case opTypeInt:
            case opTypeFloat:
            case opTypeVector:
            case opTypeMatrix:
            case opTypeImage:
            case opTypeSampledImage:
            case opTypeArray:
            case opTypeRuntimeArray:
            case opTypeStruct:
            case opTypePointer:
                define(0);
                break;
            case opConstant:
            case opSpecConstantTrue:
            case opSpecConstantFalse:
            case opSpecConstant:
            case opSpecConstantComposite:
                define(1);
                break;
            case opVariable:
                define(1);
                variables_.push_back(word(operands, 1));
                break;
            case opDecorate:
                readDecoration(operands);
                break;
            case opMemberDecorate:
                readMemberDecoration(operands);
                break;
            default:
                break;
        }
    }

    MemberInfo& member(std::uint32_t structId, std::uint32_t index) {
        if (index >= words_.size()) throw Malformed{"a struct has too many members"};
        auto& members = id(structId).members;
        if (members.size() <= index) members.resize(index + 1);
        return members[index];
    }

    void readDecoration(std::span<const std::uint32_t> operands) {
        Id& target = id(word(operands, 0));
        switch (word(operands, 1)) {
            case decorationSpecId:
                target.specId = word(operands, 2);
                break;
            case decorationArrayStride:
                target.arrayStride = word(operands, 2);
                break;
            case decorationBinding:
                target.binding = word(operands, 2);
                break;
            case decorationDescriptorSet:
                target.set = word(operands, 2);
                break;
            case decorationBuiltIn:
                target.isWorkgroupSize = word(operands, 2) == kBuiltInWorkgroupSize;
                break;
            default:
                break;
        }
    }

    void readMemberDecoration(std::span<const std::uint32_t> operands) {
        const std::uint32_t decoration = word(operands, 2);
        if (decoration == decorationOffset)
            member(word(operands, 0), word(operands, 1)).offset = word(operands, 3);
        if (decoration == decorationMatrixStride)
            member(word(operands, 0), word(operands, 1)).matrixStride = word(operands, 3);
    }

    static std::uint32_t constantBits(const Id& constant) {
        switch (constant.op) {
            case opSpecConstantTrue:
                return VK_TRUE;
            case opSpecConstantFalse:
                return VK_FALSE;
            case opConstant:
            case opSpecConstant:
                return operand(constant, 2);
            default:
                throw Malformed{"a constant is not a plain number"};
        }
    }

    void readLocalSize() {
        if (!localSize_.empty()) {
            const bool byId = localSize_[1] == kModeLocalSizeId;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint32_t value = word(localSize_, 2 + axis);
                reflection_.localSize[axis] = byId ? localSizeOf(id(value)) : LocalSize{value, {}};
            }
        }
        // The built-in overrides the execution mode. glslang emits it even if it is constant.
        for (const Id& composite : ids_) {
            if (!composite.isWorkgroupSize || composite.op != opSpecConstantComposite) continue;
            for (std::size_t axis = 0; axis < 3; ++axis)
                reflection_.localSize[axis] = localSizeOf(id(operand(composite, 2 + axis)));
        }
    }

    // glslang emits local_size_x_id twice: for the execution mode and for gl_WorkGroupSize.
    void addSpecialization(const Id& constant) {
        auto& known = reflection_.specializations;
        const auto same = std::find_if(known.begin(), known.end(),
                                       [&](const auto& other) { return other.id == *constant.specId; });
        if (same == known.end())
            known.push_back({constant.name, *constant.specId, constantBits(constant)});
        else if (same->name.empty())
            same->name = constant.name;
    }

    static LocalSize localSizeOf(const Id& constant) { return {constantBits(constant), constant.specId}; }

    void readVariable(const Id& variable) {
        const std::uint32_t storage = operand(variable, 2);
        if (storage != kStorageUniformConstant && storage != kStorageUniform &&
            storage != kStoragePushConstant && storage != kStorageStorageBuffer)
            return;
        const Id* type = &id(operand(id(operand(variable, 0)), 2));

        ReflectedBinding result;
        result.set = variable.set;
        result.binding = variable.binding.value_or(0);
        if (type->op == opTypeArray || type->op == opTypeRuntimeArray) {
            result.count = type->op == opTypeArray ? constantBits(id(operand(*type, 2))) : 0;
            type = &id(operand(*type, 1));
        }
        result.type = descriptorType(*type, storage);
        if (type->op == opTypeStruct) {
            result.block = describeType(*type, 0, 0);
            result.block.name = type->name;
        }
        result.name = variable.name.empty() ? type->name : variable.name;
        if (storage == kStoragePushConstant)
            reflection_.pushConstants = std::move(result);
        else
            reflection_.bindings.push_back(std::move(result));
    }

    static VkDescriptorType descriptorType(const Id& type, std::uint32_t storage) {
        if (storage == kStoragePushConstant) return VK_DESCRIPTOR_TYPE_MAX_ENUM;
        if (storage == kStorageStorageBuffer) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        if (storage == kStorageUniform) return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        if (type.op == opTypeSampledImage || type.op == opTypeImage) return imageDescriptorType(type);
        throw Malformed{"it has a resource of a kind that is not supported"};
    }

    static VkDescriptorType imageDescriptorType(const Id& type) {
        if (type.op == opTypeSampledImage) return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        const bool isBuffer = operand(type, 2) == kDimBuffer;
        const bool isStorage = operand(type, 6) == kImageIsStorage;
        if (isBuffer)
            return isStorage ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
                             : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
        return isStorage ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    }

    // Size and inner structure; the caller fills in name and offset.
    ReflectedMember describeType(const Id& type, std::uint32_t matrixStride, int depth) {
        if (depth > kMaxDepth) throw Malformed{"its types are nested too deeply"};
        ReflectedMember result;
        switch (type.op) {
            case opTypeInt:
            case opTypeFloat:
                result.bytes = operand(type, 1) / 8;
                break;
            case opTypeVector: {
                const auto component = describeType(id(operand(type, 1)), 0, depth + 1);
                result.bytes = component.bytes * operand(type, 2);
                break;
            }
            case opTypeMatrix: {
                const auto column = describeType(id(operand(type, 1)), 0, depth + 1);
                const std::uint32_t columns = operand(type, 2);
                if (columns == 0) throw Malformed{"a matrix has no columns"};
                result.matrixStride = matrixStride;
                result.bytes = (columns - 1) * matrixStride + column.bytes;
                break;
            }
            case opTypeArray:
            case opTypeRuntimeArray:
                result = describeType(id(operand(type, 1)), matrixStride, depth + 1);
                result.arrayStride = type.arrayStride;
                result.arrayLength = type.op == opTypeArray ? constantBits(id(operand(type, 2))) : 0;
                result.bytes = result.arrayStride * result.arrayLength;
                break;
            case opTypeStruct:
                for (std::size_t i = 1; i < type.operands.size(); ++i) {
                    const MemberInfo info = i - 1 < type.members.size() ? type.members[i - 1] : MemberInfo{};
                    ReflectedMember inner = describeType(id(type.operands[i]), info.matrixStride, depth + 1);
                    inner.name = info.name;
                    inner.offset = info.offset;
                    result.bytes = std::max(result.bytes, inner.offset + inner.bytes);
                    result.members.push_back(std::move(inner));
                }
                break;
            default:
                throw Malformed{"a block has a member of a kind that is not supported"};
        }
        return result;
    }

    std::span<const std::uint32_t> words_;
    std::vector<Id> ids_;
    std::vector<std::uint32_t> variables_;
    std::span<const std::uint32_t> localSize_;  // operands of the execution mode
    Reflection reflection_;
};

}  // namespace

const ReflectedMember* ReflectedMember::find(std::string_view memberName) const {
    const auto found = std::find_if(members.begin(), members.end(), [&](const ReflectedMember& candidate) {
        return candidate.name == memberName;
    });
    return found == members.end() ? nullptr : &*found;
}

Result<Reflection> reflectSpirv(std::span<const std::uint32_t> words) {
    try {
        return Parser(words).parse();
    } catch (const Malformed& malformed) {
        return Error{ErrorCode::inputNotUsable, Text("A shader cannot be used: {}.", malformed.why), "",
                     Text("Build Macula again.")};
    }
}

}  // namespace macula::gpu
