// Adam (Kingma and Ba 2015, algorithm 1) for one number.

struct AdamStep {
    float first;  // moments
    float second;
    float change;  // of the parameter
};

// `corrections` are 1 / (1 - beta1^t) and 1 / (1 - beta2^t) at step t of this parameter.
AdamStep adamStep(float gradient, float first, float second, vec2 corrections, float rate, float beta1,
                  float beta2, float epsilon) {
    AdamStep result;
    result.first = beta1 * first + (float(1.0) - beta1) * gradient;
    result.second = beta2 * second + (float(1.0) - beta2) * gradient * gradient;
    result.change = -rate * (result.first * corrections.x) / (sqrt(result.second * corrections.y) + epsilon);
    return result;
}

// Whether the square of a gradient is finite. Tests its bits: a compiler that assumes finite numbers may
// remove a comparison.
bool isUsableGradient(float gradient) {
    return (floatBitsToUint(gradient) & 0x7fffffffu) < 0x5d5e0b6bu;  // 1e18
}
