// Structs of macula.h, whose first member is their size: it tells older and newer headers apart.
#pragma once

#include <macula.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "base/result.h"

namespace macula::c {

// The error for a struct of a wrong size. It names both sizes, by which a reader can find the struct.
template <class T>
Error wrongSize(const T* given) {
    if (given == nullptr)
        return {ErrorCode::usage,
                Text("A struct for a result is null."),
                {},
                Text("Give one whose first member is its size.")};
    return {ErrorCode::usage,
            Text("A struct of macula.h says that it has {} bytes, and Macula knows it with {}.", given->size,
                 sizeof(T)),
            {},
            Text("Set its first member, size, to its sizeof, and the other members to 0.")};
}

inline Error newerStruct() {
    return {
        ErrorCode::usage,
        Text("A struct of a newer macula.h asks for something that this Macula does not know."),
        {},
        Text("Leave the members 0 that are newer than Macula {}, or install a newer one.", macula_version())};
}

// Reads the members of T that the caller's header has; the others are 0. usage if the size is not possible,
// or if members of a newer header are in use. `given` may be null: then all is 0.
template <class T>
Result<T> taken(const T* given) {
    static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
    T mine{};
    mine.size = sizeof(T);
    if (given == nullptr) return mine;
    const std::uint32_t size = given->size;
    if (size < 2 * sizeof(std::uint32_t) || size > 65536) return wrongSize(given);
    const auto* bytes = reinterpret_cast<const unsigned char*>(given);
    if (size > sizeof(T) &&
        std::any_of(bytes + sizeof(T), bytes + size, [](unsigned char byte) { return byte != 0; }))
        return newerStruct();
    std::memcpy(&mine, given, std::min<std::size_t>(size, sizeof(T)));
    mine.size = sizeof(T);
    return mine;
}

// Whether `out` has a size that a T can have.
template <class T>
bool isSized(const T* out) {
    return out != nullptr && out->size >= 2 * sizeof(std::uint32_t) && out->size <= 65536;
}

// Writes as much of `mine` as the caller has room for. The caller's size stays, and members that are newer
// than T become 0. False if the size is not possible.
template <class T>
bool give(const T& mine, T* out) {
    static_assert(std::is_trivially_copyable_v<T> && offsetof(T, size) == 0);
    if (!isSized(out)) return false;
    const std::uint32_t size = out->size;
    std::memset(static_cast<void*>(out), 0, size);
    std::memcpy(static_cast<void*>(out), &mine, std::min<std::size_t>(size, sizeof(T)));
    out->size = size;
    return true;
}

}  // namespace macula::c
