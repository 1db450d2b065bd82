// Tests the exponent bits: a compiler that assumes finite numbers may remove a comparison.
bool isFinite(vec4 v) {
    uint special = 0x7f800000u;
    return (floatBitsToUint(v.x) & special) != special && (floatBitsToUint(v.y) & special) != special &&
           (floatBitsToUint(v.z) & special) != special && (floatBitsToUint(v.w) & special) != special;
}
