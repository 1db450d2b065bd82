// Adds samples to the pixels of some blocks of the picture.
//
// Needs trace/host.glsl, and from its host: EXTEND_SAMPLE(path, rng), which is extendPath or a variant of it,
// TELL_SAMPLE(path, sampleIndex), called for each complete, finite sample, and TELL_PIXEL(pixelIndex), called
// after the last.
layout(local_size_x = 8, local_size_y = 8) in;

#include "trace/film.glsl"

// lavapipe (Mesa 22.3) silently ends every loop after 65535 rounds of all loops together. It counts the eight
// lanes of a group as one, which together run up to 3.4 times the rounds of each (measured on the phantom):
// the host sets a limit well below a quarter there, and takes smaller portions when paths reach it.
layout(constant_id = 1) const int kMaxRounds = 16000;

void main() {
    // Not push constants: lavapipe would compile the shader again for each number of samples.
    PlannedBlock plan = planned[gl_WorkGroupID.x];
    int block = int(plan.block);
    int columns = (params.imageSize.x + 7) / 8;
    ivec2 pixel = 8 * ivec2(block % columns, block / columns) + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;

    int index = pixel.y * params.imageSize.x + pixel.x;
    vec4 sum = sums[index];
    vec4 compensation = lost[index];
    vec2 square = squares[index];
    uint finite = 0u;
    uint done = 0u;
    int rounds = 0;  // of the samples done
    int above = 0;   // likewise, sum of Path.aboveBound
    IndirectRecord record = IndirectRecord(uvec4(0u), vec3(0.0));
    Rng rng;
    Path path = startSample(pixel, plan.firstSample, rng);
    while (done < plan.sampleCount && rounds + path.rounds < kMaxRounds) {
        rounds += 1;
        if (!EXTEND_SAMPLE(path, rng)) {
            vec4 value = vec4(lightOf(path), path.coverage);
            if (isFinite(value) && isFinite(sum + value)) {
                accumulate(sum, compensation, value);
                accumulate(square, squareOfLuminance(value.xyz));
                finite += 1u;
                if (useIndirect() && path.cells.y != 0u) record = IndirectRecord(path.cells, path.radiance);
                TELL_SAMPLE(path, plan.firstSample + done);
            }
            done += 1u;
            rounds += path.rounds;
            above += path.aboveBound;
            path = startSample(pixel, plan.firstSample + done, rng);
        }
    }
    if (done < plan.sampleCount) above += path.aboveBound;  // of the path that is given up
    sums[index] = sum;
    lost[index] = compensation;
    squares[index] = square;
    counts[index] += finite;
    if (useIndirect()) tellIndirect(pixel, record);
    TELL_PIXEL(index);
    if (finite < done) atomicAdd(nonFinite, done - finite);
    if (done < plan.sampleCount) atomicAdd(abandoned, plan.sampleCount - done);
    if (above > 0) atomicAdd(aboveBound, uint(above));
}
