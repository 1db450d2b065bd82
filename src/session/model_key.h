// The key of a stored model, and identities of studies and series.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace macula::session {

// 64 lower-case hexadecimal digits, as sha256Hex() gives them.
bool isDigest(std::string_view text);

// The names of a study and a series in the store: digests of their UIDs. They do not reveal a UID, but
// whoever knows it can find the entry. The name of a series includes the study's UID, so series of two
// studies never share one.
std::string studyIdentity(std::string_view studyUid);
std::string seriesIdentity(std::string_view studyUid, std::string_view seriesUid);

// One input of a model besides the volume: transfer function, clip, table, lights.
struct KeyPart {
    std::string name;    // letters a to z and '-': "transfer-function"
    std::string digest;  // of the part's content, not of its name
    bool operator==(const KeyPart&) const = default;
};

// Parts in any order, each name once. The whole is the key: a model is only found under the same volume,
// trainer and parts.
struct ModelKey {
    std::string volume;        // digest over all voxels and the geometry
    std::int64_t trainer = 0;  // version of the trainer: kTrainerVersion
    std::vector<KeyPart> parts;

    std::string digest() const;
    bool isValid() const;
};

// textOfParts gives "clip=<digest>\n...", ordered by name; partsOfText reads it back. False, with `parts`
// unusable, for text that textOfParts cannot have written.
std::string textOfParts(std::vector<KeyPart> parts);
bool partsOfText(std::string_view text, std::vector<KeyPart>& parts);

// The names of parts that differ, or that only one key has, in order; also "trainer" and "volume".
std::vector<std::string> differences(const ModelKey& a, const ModelKey& b);

}  // namespace macula::session
