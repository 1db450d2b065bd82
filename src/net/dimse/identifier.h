// Identifiers of queries and retrievals (PS3.4 annex C): what is looked for, and what was found.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::net {

// The attributes that Macula asks for.
enum class Key : std::uint32_t {
    specificCharacterSet = 0x00080005,
    sopClassUid = 0x00080016,
    sopInstanceUid = 0x00080018,
    studyDate = 0x00080020,
    studyTime = 0x00080030,
    accessionNumber = 0x00080050,
    level = 0x00080052,
    modality = 0x00080060,
    modalitiesInStudy = 0x00080061,
    referringPhysician = 0x00080090,
    studyDescription = 0x00081030,
    seriesDescription = 0x0008103e,
    patientName = 0x00100010,
    patientId = 0x00100020,
    patientBirthDate = 0x00100030,
    patientSex = 0x00100040,
    bodyPart = 0x00180015,
    studyInstanceUid = 0x0020000d,
    seriesInstanceUid = 0x0020000e,
    studyId = 0x00200010,
    seriesNumber = 0x00200011,
    instanceNumber = 0x00200013,
    seriesOfStudy = 0x00201206,     // their number
    instancesOfStudy = 0x00201208,  // their number
    instancesOfSeries = 0x00201209,
};

// Keys with their values in UTF-8; an empty value asks for the attribute.
using Keys = std::map<Key, std::string>;

// The bytes to send. `characterSet` is the defined term that texts are written in; an error if one cannot be.
Result<std::vector<unsigned char>> identifierBytes(const Keys& keys, std::string_view transferSyntax,
                                                   const std::string& characterSet);

// What an archive answered, decoded by its own character set: UTF-8, without control characters, cut at a
// length that no sound value has. Empty where the bytes are malformed.
std::optional<Keys> identifierOf(std::span<const unsigned char> bytes, std::string_view transferSyntax);

// The first of several values (separated by backslashes), and all of them.
std::string firstValue(const Keys& keys, Key key);
std::vector<std::string> allValues(const Keys& keys, Key key);
// A UID; empty if it is none, or several.
std::string uidValue(const Keys& keys, Key key);
std::optional<int> numberValue(const Keys& keys, Key key);

}  // namespace macula::net
