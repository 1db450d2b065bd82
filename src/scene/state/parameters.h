// The numbers that a person can set, in two tables. They generate options of `macula render`, keys of saved
// views and remarks on pictures; a test compares docs/parameters.md with them.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "pipeline/trace/settings.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

// What a change makes stale, from the least to the most; each includes those before it.
enum class Stale {
    nothing,
    display,  // only how the traced picture is displayed
    camera,   // samples and guides; the peripheral model stays
    light,    // the light from matter: peripheral model and picture start over
    matter,   // what can be seen: tables, bricks on the device, outline
    volume,   // all
};

// A number of the settings, or of the preset.
template <class Of>
struct ParameterOf {
    std::string_view id;      // JSON key; of a MatterParameter, key in StateRequest and RenderRecord
    std::string_view option;  // of the command
    std::string_view label;   // for people, within a sentence
    std::string_view unit;    // "degrees"; empty: a count or a factor
    double low = 0.0;         // the lowest value allowed
    double high = 0.0;
    bool isWhole = false;
    Stale stale = Stale::light;
    std::string_view does;  // a sentence
    double (*get)(const Of&);
    void (*set)(Of&, double);

    double fallback() const { return get(Of{}); }
};

using Parameter = ParameterOf<trace::Settings>;
// How matter scatters light. A saved view holds it within its preset.
using MatterParameter = ParameterOf<TransferFunction>;

std::span<const Parameter> parameters();
std::span<const MatterParameter> matterParameters();

// The parameter with that id, which must be in its table.
const Parameter& parameter(std::string_view id);
const MatterParameter& matterParameter(std::string_view id);

}  // namespace macula::scene
