// What a stored model was made for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace macula::session {

// 64 lower-case hexadecimal digits, as sha256Hex() gives them.
bool isDigest(std::string_view text);

// What a study and a series are called in the store: digests of their UIDs, under which nobody can read the
// UID, but who knows it can find the entry. The UID of the study is part of the series' name: series of two
// studies are never one.
std::string studyIdentity(std::string_view studyUid);
std::string seriesIdentity(std::string_view studyUid, std::string_view seriesUid);

// One thing besides the volume that a model depends on: transfer function, clip, table, lights.
struct KeyPart {
    std::string name;    // letters a to z and '-': "transfer-function"
    std::string digest;  // of what it is, not of what it is called
    bool operator==(const KeyPart&) const = default;
};

// Parts in any order, each name once. All of it together is the key: a model is found under the same volume,
// trainer and parts, and under nothing else.
struct ModelKey {
    std::string volume;        // digest over all voxels and the geometry
    std::int64_t trainer = 0;  // version of the trainer: kTrainerVersion
    std::vector<KeyPart> parts;

    std::string digest() const;
    bool isValid() const;
};

// "clip=<digest>\n...", ordered by name; and back. Text that no key has gives no parts and false.
std::string textOfParts(std::vector<KeyPart> parts);
bool partsOfText(std::string_view text, std::vector<KeyPart>& parts);

// The names of the parts that only one of two keys has, or that differ, in order; "trainer" and "volume" too.
std::vector<std::string> differences(const ModelKey& a, const ModelKey& b);

}  // namespace macula::session
